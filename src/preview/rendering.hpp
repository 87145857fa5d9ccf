// What the engine's thread works on: one scene on one device, first as a coarse picture, then in full size,
// then sample by sample.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compile/table_memo.hpp"
#include "image/develop.hpp"
#include "preview/live_shaders.hpp"
#include "preview/wish.hpp"
#include "render/progressive.hpp"

namespace fringe::preview {

class Rendering {
public:
    // Keeps a reference to the device, and to the shaders; null: the program's own.
    Rendering(const gpu::Device& device, LiveShaders* shaders) : progressive_(device), shaders_(shaders) {}

    // Whether the wish is for another scene, or for other parts of it, than the one that load() was last
    // called with; or for the same at rest, of which there are drafts of tables so far.
    bool isNewScene(const Wish& wish) const {
        return wish.source != tried_ || wish.switches != triedSwitches_ ||
               (!wish.isMoving && memo_.hasDrafts());
    }

    // Whether the wish is for other shaders than those that are known.
    bool hasNewShaders(const Wish& wish) const { return wish.shaders != wish_.shaders; }

    // Reads and compiles the scene of the wish and begins with it. Throws scene::SceneError, and then the
    // scene before stays, or gpu::DeviceError, and then this is of no more use.
    void load(const Wish& wish);

    // Takes up the camera, display and number of samples of the wish. The picture starts afresh where it has
    // to. Throws gpu::DeviceError. Precondition: hasScene().
    void follow(const Wish& wish);

    bool hasScene() const { return scene_ != nullptr; }

    // Precondition: hasScene().
    const std::shared_ptr<const scene::Scene>& scene() const { return scene_; }

    // Samples of a pixel that the scene file asks for; those of scene() are the wish's.
    std::uint32_t samplesOfScene() const { return samplesOfScene_; }

    // Whether every pixel has one already.
    bool hasSamples() const { return progressive_.samples() > 0; }

    // Whether there is nothing left to do for the wish.
    bool isComplete() const;

    // Works on it for about 30 ms. True when the picture has become better. Throws gpu::DeviceError.
    // Precondition: hasScene().
    bool advance();

    // The picture as it is, as it shall be displayed. Precondition: a sample of every pixel.
    Picture develop();

    // In full size, as opposed to coarse.
    bool isFull() const { return divisor_ == 1; }

    // Why the shaders are not as the wish has them; empty: they are.
    const std::string& shaderError() const { return shaderError_; }

    const Timing& timing() const { return timing_; }

    // The constants of the pipeline that are not 0, "RECTANGLE_COUNT 5, ...".
    std::string specialisation() const;

private:
    void start();
    bool takeShader();
    void restart(std::uint32_t divisor);
    std::uint32_t coarseDivisor() const;
    device::Frame frameOf(std::uint32_t divisor) const;
    double fullPixels() const;

    render::Progressive progressive_;
    LiveShaders* shaders_;
    render::ShaderCode shader_;
    std::string shaderError_;
    std::shared_ptr<const Source> tried_, source_;
    Switches triedSwitches_;
    std::optional<double> wavelength_nm_;  // that is shown; nothing: all of them
    std::shared_ptr<const scene::Scene> scene_;
    std::uint32_t samplesOfScene_ = 1;
    image::Development development_;
    compile::TableMemo memo_;
    compile::CompiledScene compiled_;
    device::Specialisation constants_;
    scene::Image image_;    // size, samples and seed of the picture in full
    scene::Camera camera_;  // that it is seen by
    Wish wish_;
    std::uint32_t divisor_ = 1;  // of the sides of the full picture
    std::vector<image::Pixel> pixels_;
    std::vector<std::uint8_t> rgb_;
    Timing timing_;
};

}  // namespace fringe::preview
