#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <vector>

#include "render/scene_buffer.hpp"
#include "render/tiling.hpp"
#include "shaders/render.comp.h"

namespace fringe::render {
namespace {

constexpr std::uint32_t kGroupEdge = 8;               // local_size of shaders/render.comp
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

std::uint32_t rowsOfBand(const gpu::Device& device, const device::Frame& frame) {
    const vk::DeviceSize row = vk::DeviceSize{frame.width} * sizeof(device::FilmPixel);
    const vk::DeviceSize film = std::min<vk::DeviceSize>(kLargestFilm, device.limits().maxStorageBufferRange);
    return static_cast<std::uint32_t>(std::clamp<vk::DeviceSize>(film / row, 1, frame.height));
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
        const std::uint32_t samples = renderer_.frame_.samples;
        for (std::uint32_t done = 0; done < samples;) {
            const std::uint32_t batch = std::min(tiling_.batch(), samples - done);
            if (!sweep(done, batch)) return false;
            done += batch;
        }
        return true;
    }

    // Pixels that no sample has reached yet hold whatever the memory held before; make them empty.
    void clearUntouched(std::span<device::FilmPixel> film) const {
        if (touchedOnce_) return;
        const std::uint32_t width = renderer_.frame_.width;
        for (std::uint32_t y = touchedRows_; y < rows_; ++y) {
            const std::uint32_t from = y < touchedRows_ + rowHeight_ ? touchedColumns_ : 0;
            const auto row = film.subspan(std::size_t{y} * width, width);
            std::fill(row.begin() + from, row.end(), device::FilmPixel{});
        }
    }

private:
    // `batch` samples of every pixel of the band, tile by tile.
    bool sweep(std::uint32_t firstSample, std::uint32_t batch) {
        const device::Frame& frame = renderer_.frame_;
        for (std::uint32_t y = 0; y < rows_;) {
            const std::uint32_t height = std::min(tiling_.tileHeight(), rows_ - y);
            const std::uint32_t tileWidth = tiling_.tileWidth();
            double slowest_ms = 0.0;
            for (std::uint32_t x = 0; x < frame.width; x += tileWidth) {
                if (control_.cancelled) return false;
                const std::uint32_t width = std::min(tileWidth, frame.width - x);
                slowest_ms = std::max(slowest_ms, dispatch({.x = x,
                                                            .y = firstRow_ + y,
                                                            .width = width,
                                                            .height = height,
                                                            .firstRow = firstRow_,
                                                            .firstSample = firstSample,
                                                            .sampleCount = batch}));
                note(y, x + width, height);
                work_ += double{1.0} * width * height * batch;
                const double all = double{1.0} * frame.width * frame.height * frame.samples;
                const double before = double{1.0} * frame.width * firstRow_ * frame.samples;
                if (control_.onProgress) control_.onProgress((before + work_) / all);
            }
            y += height;
            if (!touchedOnce_) touchedRows_ = y, touchedColumns_ = 0;
            tiling_.learn(slowest_ms);
        }
        touchedOnce_ = true;
        return true;
    }

    void note(std::uint32_t row, std::uint32_t columns, std::uint32_t height) {
        if (touchedOnce_) return;
        touchedRows_ = row;
        touchedColumns_ = columns;
        rowHeight_ = height;
    }

    double dispatch(const device::Tile& tile) {
        double spent_ms = 0.0;
        {
            const Stopwatch watch(spent_ms);
            renderer_.kernel_->run(
                std::as_bytes(std::span(&tile, 1)),
                {(tile.width + kGroupEdge - 1) / kGroupEdge, (tile.height + kGroupEdge - 1) / kGroupEdge, 1});
        }
        renderer_.clocks_.dispatch += spent_ms;
        ++renderer_.clocks_.dispatches;
        return spent_ms;
    }

    Renderer& renderer_;
    const Control& control_;
    Tiling& tiling_;
    std::uint32_t firstRow_;
    std::uint32_t rows_;
    double work_ = 0.0;  // pixel samples of this band
    bool touchedOnce_ = false;
    std::uint32_t touchedRows_ = 0;     // complete rows of tiles of the first sweep,
    std::uint32_t touchedColumns_ = 0;  // columns done in the row of tiles that follows
    std::uint32_t rowHeight_ = 0;       // and its height
};

Renderer::Renderer(const gpu::Device& device, const compile::CompiledScene& scene,
                   const device::Specialisation& specialisation)
    : device_(device),
      frame_(scene.frame),
      bandRows_(rowsOfBand(device, scene.frame)),
      scene_(device, layOut(scene, device).size, gpu::Access::hostWrites),
      film_(device, vk::DeviceSize{bandRows_} * frame_.width * sizeof(device::FilmPixel),
            gpu::hasSharedMemory(device) ? gpu::Access::shared : gpu::Access::deviceOnly) {
    if (film_.mapped().empty()) readback_.emplace(device, film_.size(), gpu::Access::hostReads);
    const SceneLayout layout = layOut(scene, device);
    {
        const Stopwatch watch(clocks_.upload);
        upload(layout, scene_);
    }
    const Stopwatch watch(clocks_.compile);
    std::array<std::uint32_t, device::kSpecialisationCount> constants{};
    std::memcpy(constants.data(), &specialisation, sizeof specialisation);
    kernel_.emplace(device, render_comp, bindings(layout, scene_, film_), constants, sizeof(device::Tile));
    // Drivers may put off compiling until the first dispatch: an empty one.
    const device::Tile nothing{};
    kernel_->run(std::as_bytes(std::span(&nothing, 1)), {1, 1, 1});
}

bool Renderer::render(const Control& control) {
    Tiling tiling(frame_.width, bandRows_, frame_.samples, control.tile);
    std::vector<image::Pixel> pixels;
    for (std::uint32_t firstRow = 0; firstRow < frame_.height; firstRow += bandRows_) {
        const std::uint32_t rows = std::min(bandRows_, frame_.height - firstRow);
        Pass pass(*this, control, tiling, firstRow, rows);
        const bool complete = pass.run();
        {
            const Stopwatch watch(clocks_.readback);
            const std::span<device::FilmPixel> film = readFilm(rows);
            if (!complete) pass.clearUntouched(film);
            pixels.resize(film.size());
            std::transform(film.begin(), film.end(), pixels.begin(), resolve);
        }
        if (control.onBand) control.onBand({firstRow, rows, pixels});
        if (!complete) return false;
    }
    return true;
}

std::span<device::FilmPixel> Renderer::readFilm(std::uint32_t rows) {
    const std::size_t count = std::size_t{rows} * frame_.width;
    if (readback_)
        gpu::copy(device_, {film_.handle(), readback_->handle(), count * sizeof(device::FilmPixel)});
    const gpu::Buffer& readable = readback_ ? *readback_ : film_;
    return {reinterpret_cast<device::FilmPixel*>(readable.mapped().data()), count};
}

}  // namespace fringe::render
