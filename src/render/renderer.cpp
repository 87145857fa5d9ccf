#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "gpu/constant_block.hpp"
#include "render/pieces.hpp"
#include "render/scene_buffer.hpp"
#include "render/stopwatch.hpp"
#include "render/tiling.hpp"
#include "render/variant.hpp"

namespace fringe::render {
namespace {

constexpr vk::DeviceSize kLargestFilm = 64ULL << 20;  // bytes; a picture beyond it is rendered in bands

// Whether a pipeline without gratings saves more time with so many samples of tiles that no grating lights
// than it takes to compile (docs/skipping.md). GPUs skip what none of neighbouring invocations needs, and
// compile for longer.
bool pays(std::uint64_t unlitSamples, const gpu::Device& device) {
    constexpr std::uint64_t kFewest = 2'000'000;
    return unlitSamples >= kFewest && device.description().isProcessor();
}

// Rows of film that there is room for: whole workgroups, and no more than the picture needs.
std::uint32_t rowsOfBand(const gpu::Device& device, const device::Frame& frame) {
    const vk::DeviceSize film = std::min<vk::DeviceSize>(kLargestFilm, device.limits().maxStorageBufferRange);
    const std::uint64_t group = std::uint64_t{frame.filmWidth} * device::GROUP_EDGE;
    const auto groups = static_cast<std::uint32_t>(std::max<std::uint64_t>(Film::pixelsIn(film) / group, 1));
    return std::min(groups * device::GROUP_EDGE, wholeGroups(frame.height));
}

// Pixels of tiles, and of those that no grating lights.
std::uint64_t allPixels(const compile::LitTiles& tiles) {
    return tiles.lit.size() * std::uint64_t{compile::LitTiles::kEdge} * compile::LitTiles::kEdge;
}
std::uint64_t unlitPixels(const compile::LitTiles& tiles) {
    const auto unlit = static_cast<std::uint64_t>(std::count(tiles.lit.begin(), tiles.lit.end(), false));
    return unlit * compile::LitTiles::kEdge * compile::LitTiles::kEdge;
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
            const Piece tile{from.x, firstRow_ + from.y, width, height, true};
            for (const Piece& piece : piecesOf(tile, renderer_.litTiles_)) dispatch(piece, from.z, batch);
        }
        renderer_.clocks_.dispatch += spent_ms;
        return spent_ms;
    }

    void dispatch(const Piece& piece, std::uint32_t firstSample, std::uint32_t batch) {
        // Vulkan promises workgroups up to 65535, and so the schema allows that many samples.
        std::vector<gpu::Groups> firstGroups;
        for (std::uint32_t i = 0; i < batch; ++i) {
            firstGroups.push_back(
                {piece.x / device::GROUP_EDGE, (piece.y - firstRow_) / device::GROUP_EDGE, firstSample + i});
        }
        const gpu::Kernel& pipeline =
            piece.isLit ? renderer_.pipelines_.front() : renderer_.pipelines_.back();
        pipeline.run(firstGroups, {piece.width / device::GROUP_EDGE, piece.height / device::GROUP_EDGE, 1});
        renderer_.clocks_.dispatches += batch;
    }

    Renderer& renderer_;
    const Control& control_;
    Tiling& tiling_;
    std::uint32_t firstRow_;
    std::uint32_t rows_;
    double work_ = 0.0;  // pixel samples of this band
};

Renderer::Renderer(const gpu::Device& device, const compile::CompiledScene& scene,
                   const device::Specialisation& specialisation, Values values, compile::LitTiles litTiles)
    : Renderer(device, scene, specialiseFor(device, scene, specialisation), values, std::move(litTiles),
               layOut(scene, device)) {}

Renderer::Renderer(const gpu::Device& device, const compile::CompiledScene& scene,
                   const device::Specialisation& specialisation, Values values, compile::LitTiles litTiles,
                   const SceneLayout& layout)
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
    const auto addPipeline = [&](const Variant& variant, const device::Specialisation& constants) {
        std::array<std::uint32_t, device::kSpecialisationCount> words{};
        std::memcpy(words.data(), &constants, sizeof constants);
        std::span<const std::uint32_t> shader = embeddedShader(variant);
        std::vector<std::uint32_t> withValues;
        if (values == Values::asConstants) {
            withValues = gpu::withConstantBlock(shader, std::as_bytes(std::span(&layout.block, 1)));
            shader = withValues;
        }
        pipelines_.emplace_back(device, shader, bindings(layout, scene_, film_.buffer(), texels_), words);
        // Drivers may put off compiling until the first dispatch: one workgroup, which render() clears away.
        const gpu::Groups corner{0, 0, 0};
        pipelines_.back().run({&corner, 1}, {1, 1, 1});
    };
    const std::uint64_t unlit = unlitPixels(litTiles);
    const bool isDark = litTiles.isKnown() && unlit == allPixels(litTiles);
    if (!isDark) addPipeline(variantFor(scene), specialisation);
    if (isDark || pays(unlit * samples_, device))
        addPipeline(withoutGratings(variantFor(scene)), compile::withoutGratings(specialisation));
    if (pipelines_.size() == 2) litTiles_ = std::move(litTiles);
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
