#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <iterator>
#include <vector>

#include "gpu/constant_block.hpp"
#include "render/scene_buffer.hpp"
#include "render/tiling.hpp"
#include "shaders/render_000.h"
#include "shaders/render_001.h"
#include "shaders/render_010.h"
#include "shaders/render_011.h"
#include "shaders/render_100.h"
#include "shaders/render_101.h"
#include "shaders/render_110.h"
#include "shaders/render_111.h"
#include "shaders/render_discs.h"
#include "shaders/render_tree.h"
#include "shaders/render_tree_discs.h"
#include "shaders/render_tree_gratings.h"

namespace fringe::render {
namespace {

// The variant of the shader with no more code than the scene needs (shaders/CMakeLists.txt).
std::span<const std::uint32_t> variantFor(const compile::CompiledScene& scene) {
    static constexpr std::array<std::span<const std::uint32_t>, 8> kVariants{
        render_000, render_001, render_010, render_011, render_100, render_101, render_110, render_111};
    if (scene.tree.depth > 0) {
        if (scene.inBands) return render_tree_discs;
        if (scene.slitGratings.empty() && scene.openingGratings.empty()) return render_tree;
        return render_tree_gratings;
    }
    if (!scene.opticalDiscs.empty()) return render_discs;
    const std::size_t bands = scene.inBands ? 4 : 0;
    const std::size_t slits = scene.slitGratings.empty() ? 0 : 2;
    const std::size_t openings = scene.openingGratings.empty() ? 0 : 1;
    return kVariants.at(bands + slits + openings);
}

constexpr vk::DeviceSize kFilmHeader = sizeof(std::uint32_t);  // FilmBlock.firstRow
constexpr vk::DeviceSize kLargestFilm = 64ULL << 20;  // bytes; a picture beyond it is rendered in bands

// Adds the wall-clock time of its life to a clock.
class Stopwatch {
public:
    explicit Stopwatch(double& total_ms) : total_ms_(total_ms) {}
    ~Stopwatch() { total_ms_ += elapsed_ms(); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

    double elapsed_ms() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    double& total_ms_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Rows of film that there is room for: whole workgroups, and no more than the picture needs.
std::uint32_t rowsOfBand(const gpu::Device& device, const device::Frame& frame) {
    const vk::DeviceSize group =
        vk::DeviceSize{frame.filmWidth} * device::GROUP_EDGE * sizeof(device::FilmPixel);
    const vk::DeviceSize film = std::min<vk::DeviceSize>(kLargestFilm, device.limits().maxStorageBufferRange);
    const auto groups = static_cast<std::uint32_t>(std::max<vk::DeviceSize>((film - kFilmHeader) / group, 1));
    return std::min(groups * device::GROUP_EDGE, wholeGroups(frame.height));
}

image::Pixel resolve(const device::FilmPixel& pixel) {
    const std::uint32_t samples = pixel.state & ~device::NON_FINITE;
    if ((pixel.state & device::NON_FINITE) != 0) return {.nonFinite = true};
    if (samples == 0) return {};  // a cancelled render did not come this far
    const glm::vec3 mean = pixel.sum / static_cast<float>(samples);
    return {mean.x, mean.y, mean.z, false};
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
    : Renderer(device, scene, specialisation, values, layOut(scene, device)) {}

Renderer::Renderer(const gpu::Device& device, const compile::CompiledScene& scene,
                   const device::Specialisation& specialisation, Values values, const SceneLayout& layout)
    : device_(device),
      frame_(scene.frame),
      samples_(scene.samples),
      bandRows_(rowsOfBand(device, scene.frame)),
      scene_(device, layout.size, gpu::Access::hostWrites),
      film_(device, filmBytes(bandRows_),
            gpu::hasSharedMemory(device) ? gpu::Access::shared : gpu::Access::deviceOnly) {
    if (film_.mapped().empty()) readback_.emplace(device, film_.size(), gpu::Access::hostReads);
    {
        const Stopwatch watch(clocks_.upload);
        upload(layout, scene_);
    }
    const Stopwatch watch(clocks_.compile);
    std::array<std::uint32_t, device::kSpecialisationCount> constants{};
    std::memcpy(constants.data(), &specialisation, sizeof specialisation);
    std::span<const std::uint32_t> shader = variantFor(scene);
    std::vector<std::uint32_t> withValues;
    if (values == Values::asConstants) {
        withValues = gpu::withConstantBlock(shader, std::as_bytes(std::span(&layout.block, 1)));
        shader = withValues;
    }
    kernel_.emplace(device, shader, bindings(layout, scene_, film_), constants);
    // Drivers may put off compiling until the first dispatch: one workgroup, which render() clears away.
    const gpu::Groups corner{0, 0, 0};
    kernel_->run({&corner, 1}, {1, 1, 1});
}

bool Renderer::render(const Control& control) {
    Tiling tiling(frame_.filmWidth, bandRows_, samples_, control.tile);
    std::vector<image::Pixel> pixels;
    for (std::uint32_t firstRow = 0; firstRow < frame_.height; firstRow += bandRows_) {
        const std::uint32_t rows = std::min(bandRows_, frame_.height - firstRow);
        clear(firstRow, rows);
        const bool complete = Pass(*this, control, tiling, firstRow, wholeGroups(rows)).run();
        {
            const Stopwatch watch(clocks_.readback);
            const std::span<device::FilmPixel> film = readFilm(rows);
            pixels.clear();
            for (std::uint32_t row = 0; row < rows; ++row) {
                const auto used = film.subspan(std::size_t{row} * frame_.filmWidth, frame_.width);
                std::transform(used.begin(), used.end(), std::back_inserter(pixels), resolve);
            }
        }
        if (control.onBand) control.onBand({firstRow, rows, pixels});
        if (!complete) return false;
    }
    return true;
}

vk::DeviceSize Renderer::filmBytes(std::uint32_t rows) const {
    return kFilmHeader + vk::DeviceSize{rows} * frame_.filmWidth * sizeof(device::FilmPixel);
}

void Renderer::clear(std::uint32_t firstRow, std::uint32_t rows) {
    const Stopwatch watch(clocks_.dispatch);
    gpu::clear(device_, film_.handle(), firstRow, filmBytes(wholeGroups(rows)));
}

std::span<device::FilmPixel> Renderer::readFilm(std::uint32_t rows) {
    if (readback_) gpu::copy(device_, {film_.handle(), readback_->handle(), filmBytes(rows)});
    const gpu::Buffer& readable = readback_ ? *readback_ : film_;
    return {reinterpret_cast<device::FilmPixel*>(readable.mapped().data() + kFilmHeader),
            std::size_t{rows} * frame_.filmWidth};
}

}  // namespace fringe::render
