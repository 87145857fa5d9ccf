// A picture that grows sample by sample, of a scene that may change at any moment: what a preview shows. Its
// values are in uniforms (Values::inUniforms), so that a pipeline serves every scene of the same
// Specialisation; the film has the same bits as that of a Renderer with as many samples.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "compile/compiled_scene.hpp"
#include "render/film.hpp"
#include "render/scene_buffer.hpp"
#include "render/variant.hpp"

namespace fringe::render {

// SPIR-V of the renderer; null: as it is embedded. Another pointer is another shader.
using ShaderCode = std::shared_ptr<const std::vector<std::uint32_t>>;

class Progressive {
public:
    // Keeps a reference to the device.
    explicit Progressive(const gpu::Device& device);
    ~Progressive();
    Progressive(const Progressive&) = delete;
    Progressive& operator=(const Progressive&) = delete;

    // Pixels of the largest picture, its rows filled up to whole workgroups.
    std::uint64_t mostPixels() const;

    // From now on the samples are of this scene. Compiles a pipeline, which takes a fraction of a second or
    // more, unless one of the last few serves its constants. `shader` is that of variantFor(scene). Throws
    // gpu::DeviceError; then show() is needed before anything else.
    void show(const compile::CompiledScene& scene, device::Specialisation constants,
              const ShaderCode& shader = nullptr);

    // The same scene in another frame (compile::setView). Precondition: its constants are those of show(),
    // and it has no more rows and columns than the frame of show().
    void look(const device::Frame& frame);

    // Takes samples for about 30 ms: of a part of the rows, or of all of them once or several times, up to
    // `samples` of each pixel. Throws gpu::DeviceError.
    void advance(std::uint32_t samples);

    // How many of every pixel have been taken.
    std::uint32_t samples() const { return samples_; }

    // The same, with the share of the one under way.
    double progress() const { return samples_ + 1.0 * nextRow_ / std::max(frame_.height, nextRow_ + 1); }

    const device::Frame& frame() const { return frame_; }

    // The means of the samples, row by row.
    void read(std::vector<image::Pixel>& pixels);

    // Milliseconds that a sample of a picture of so many pixels is expected to take; nothing before the
    // first.
    std::optional<double> expected_ms(std::uint64_t pixels) const;

    // Milliseconds of the last compilation, and how many there have been.
    double compile_ms() const { return compile_ms_; }
    std::uint64_t compilations() const { return compilations_; }

private:
    struct Pipeline;

    Pipeline& pipelineFor(const Variant& variant, const device::Specialisation& constants,
                          const ShaderCode& shader, const SceneLayout& layout);
    void restart();

    const gpu::Device& device_;
    device::Frame frame_{};
    std::optional<gpu::Buffer> scene_;
    SceneTexels texels_;
    std::optional<Film> film_;
    std::vector<std::unique_ptr<Pipeline>> pipelines_;  // the one in use last
    std::uint32_t samples_ = 0;
    std::uint32_t nextRow_ = 0;  // of the sample under way
    double compile_ms_ = 0.0;
    std::uint64_t compilations_ = 0;
};

}  // namespace fringe::render
