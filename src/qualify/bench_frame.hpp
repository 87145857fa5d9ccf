// One scene as a benchmark holds it: compiled, its pipeline ready, to be rendered and timed again and again;
// and how far two pictures are apart.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "compile/compiled_scene.hpp"
#include "gpu/device.hpp"
#include "image/image.hpp"
#include "qualify/bench.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace fringe::qualify {

class BenchFrame {
public:
    enum class Gratings {
        whereLit,   // as `fringe render` has it: tiles that none lights are spared them
        everywhere  // one pipeline for all of the picture
    };

    // Compiles the scene and its pipelines. Keeps a reference to the device. Throws gpu::DeviceError.
    BenchFrame(const gpu::Device& device, const std::string& sceneText,
               Gratings gratings = Gratings::whereLit);

    // A picture; without pixels when it was cancelled.
    image::Image render(const std::atomic<bool>& cancelled, std::uint32_t tile = 0);

    // Milliseconds of a frame's dispatches by the host's clock, the film's clearing included; less than
    // nothing when it was cancelled.
    double dispatch_ms(const std::atomic<bool>& cancelled, std::uint32_t tile = 0);

    // Milliseconds that the pipeline took to make, and its first dispatch of one workgroup.
    double compile_ms() const { return renderer_->clocks().compile; }

    const scene::Scene& scene() const { return scene_; }
    const compile::CompiledScene& compiled() const { return compiled_; }
    const device::Specialisation& constants() const { return constants_; }

private:
    scene::Scene scene_;
    compile::CompiledScene compiled_;
    device::Specialisation constants_;
    std::unique_ptr<render::Renderer> renderer_;
};

// The pixels in the middles of `edge` x `edge` even parts of a picture, as a picture of its own.
// Precondition: it has as many on either side.
image::Image thinned(const image::Image& picture, std::uint32_t edge);

// The same of the reference renderer's picture of a scene, with `samples` to the pixel whatever the scene
// says; without pixels when it was cancelled.
image::Image thinnedReference(const std::string& sceneText, std::uint32_t edge, std::uint32_t samples,
                              const std::atomic<bool>& cancelled);

// Of a picture against another of the same size, relative to the highest Y in the latter.
struct PictureError {
    double largest = 0.0;  // of any of X, Y and Z
    double rms = 0.0;      // of Y
    double deltaE = 0.0;   // CIEDE2000 that 99 % of the pixels do not exceed, with display white as white
    double wrong = 0.0;    // share of the pixels with an error of Y beyond 1 %
};

PictureError pictureError(const image::Image& picture, const image::Image& reference);

}  // namespace fringe::qualify
