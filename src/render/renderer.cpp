#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "gpu/constant_block.hpp"
#include "render/scene_buffer.hpp"
#include "render/stopwatch.hpp"
#include "render/tiling.hpp"
#include "render/variant.hpp"

namespace fringe::render {
namespace {

constexpr vk::DeviceSize kLargestFilm = 64ULL << 20;  // bytes; a picture beyond it is rendered in bands

// Rows of film that there is room for: whole workgroups, and no more than the picture needs.
std::uint32_t rowsOfBand(const gpu::Device& device, const device::Frame& frame) {
    const vk::DeviceSize film = std::min<vk::DeviceSize>(kLargestFilm, device.limits().maxStorageBufferRange);
    const std::uint64_t group = std::uint64_t{frame.filmWidth} * device::GROUP_EDGE;
    const auto groups = static_cast<std::uint32_t>(std::max<std::uint64_t>(Film::pixelsIn(film) / group, 1));
    return std::min(groups * device::GROUP_EDGE, wholeGroups(frame.height));
}

}  // namespace

// One band's rendering: where it is, and how far it has come.
class Renderer::Pass {
public:
    Pass(Renderer& renderer, const Control& control, Tiling& tiling, std::uint32_t firstRow,
         std::uint32_t rows)
        : renderer_(renderer), control_(control), tiling_(tiling), firstRow_(firstRow), rows_(rows) {}

    // All samples of all pixels of the band; false when cancelled.
    bool run() {
        const std::uint32_t samples = renderer_.samples_;
        for (std::uint32_t done = 0; done < samples;) {
            const std::uint32_t batch = std::min(tiling_.batch(), samples - done);
            if (!sweep(done, batch)) return false;
            done += batch;
        }
        return true;
    }

private:
    // Samples firstSample.. of every pixel of the band, tile by tile.
    bool sweep(std::uint32_t firstSample, std::uint32_t batch) {
        const std::uint32_t filmWidth = renderer_.frame_.filmWidth;
        for (std::uint32_t y = 0; y < rows_;) {
            const std::uint32_t height = std::min(tiling_.tileHeight(), rows_ - y);
            const std::uint32_t tileWidth = tiling_.tileWidth();
            double slowest_ms = 0.0;
            for (std::uint32_t x = 0; x < filmWidth; x += tileWidth) {
                if (control_.cancelled) return false;
                const std::uint32_t width = std::min(tileWidth, filmWidth - x);
                slowest_ms = std::max(slowest_ms, dispatch({x, y, firstSample}, width, height, batch));
                work_ += double{1.0} * width * height * batch;
                report();
            }
            y += height;
            tiling_.learn(slowest_ms);
        }
        return true;
    }

    void report() const {
        if (!control_.onProgress) return;
        const double row = double{1.0} * renderer_.frame_.filmWidth * renderer_.samples_;
        control_.onProgress((firstRow_ * row + work_) / (wholeGroups(renderer_.frame_.height) * row));
    }

    // `from`: pixel and row of the film, and first sample. Returns how long it took, in milliseconds.
    double dispatch(gpu::Groups from, std::uint32_t width, std::uint32_t height, std::uint32_t batch) {
        double spent_ms = 0.0;
        {
            const Stopwatch watch(spent_ms);
            // Vulkan promises workgroups up to 65535, and so the schema allows that many samples.
            std::vector<gpu::Groups> firstGroups;
            for (std::uint32_t i = 0; i < batch; ++i) {
                firstGroups.push_back({from.x / device::GROUP_EDGE, from.y / device::GROUP_EDGE, from.z + i});
            }
            renderer_.kernel_->run(firstGroups, {width / device::GROUP_EDGE, height / device::GROUP_EDGE, 1});
        }
        renderer_.clocks_.dispatch += spent_ms;
        renderer_.clocks_.dispatches += batch;
        return spent_ms;
    }

    Renderer& renderer_;
    const Control& control_;
    Tiling& tiling_;
    std::uint32_t firstRow_;
    std::uint32_t rows_;
    double work_ = 0.0;  // pixel samples of this band
};

Renderer::Renderer(const gpu::Device& device, const compile::CompiledScene& scene,
                   const device::Specialisation& specialisation, Values values)
    : Renderer(device, scene, specialiseFor(device, scene, specialisation), values, layOut(scene, device)) {}

Renderer::Renderer(const gpu::Device& device, const compile::CompiledScene& scene,
                   const device::Specialisation& specialisation, Values values, const SceneLayout& layout)
    : device_(device),
      frame_(scene.frame),
      samples_(scene.samples),
      bandRows_(rowsOfBand(device, scene.frame)),
      scene_(device, layout.size, gpu::Access::hostWrites),
      film_(device, std::uint64_t{bandRows_} * frame_.filmWidth) {
    {
        const Stopwatch watch(clocks_.upload);
        upload(layout, scene_);
        texels_ = uploadTexels(device, scene, specialisation);
    }
    const Stopwatch watch(clocks_.compile);
    std::array<std::uint32_t, device::kSpecialisationCount> constants{};
    std::memcpy(constants.data(), &specialisation, sizeof specialisation);
    std::span<const std::uint32_t> shader = embeddedShader(variantFor(scene));
    std::vector<std::uint32_t> withValues;
    if (values == Values::asConstants) {
        withValues = gpu::withConstantBlock(shader, std::as_bytes(std::span(&layout.block, 1)));
        shader = withValues;
    }
    kernel_.emplace(device, shader, bindings(layout, scene_, film_.buffer(), texels_), constants);
    // Drivers may put off compiling until the first dispatch: one workgroup, which render() clears away.
    const gpu::Groups corner{0, 0, 0};
    kernel_->run({&corner, 1}, {1, 1, 1});
}

bool Renderer::render(const Control& control) {
    Tiling tiling(frame_.filmWidth, bandRows_, samples_, control.tile);
    std::vector<image::Pixel> pixels;
    for (std::uint32_t firstRow = 0; firstRow < frame_.height; firstRow += bandRows_) {
        const std::uint32_t rows = std::min(bandRows_, frame_.height - firstRow);
        {
            const Stopwatch watch(clocks_.dispatch);
            film_.clear(firstRow, std::uint64_t{wholeGroups(rows)} * frame_.filmWidth);
        }
        const bool complete = Pass(*this, control, tiling, firstRow, wholeGroups(rows)).run();
        {
            const Stopwatch watch(clocks_.readback);
            pixels.clear();
            film_.read(frame_, rows, pixels);
        }
        if (control.onBand) control.onBand({firstRow, rows, pixels});
        if (!complete) return false;
    }
    return true;
}

}  // namespace fringe::render
