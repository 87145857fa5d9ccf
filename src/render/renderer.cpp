#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "gpu/constant_block.hpp"
#include "gpu/kernel.hpp"
#include "render/film.hpp"
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

struct Renderer::Parts {
    Parts(const gpu::Device& device, const compile::CompiledScene& compiled,
          const device::Specialisation& specialisation, Values values, compile::LitTiles tiles,
          const SceneLayout& layout);

    device::Frame frame;
    std::uint32_t samples;
    Clocks clocks;
    std::uint32_t bandRows;
    gpu::Buffer scene;
    SceneTexels texels;
    Film film;
    compile::LitTiles litTiles;          // known only if pipelines has two
    std::vector<gpu::Kernel> pipelines;  // the scene's; the second one for tiles that gratings do not reach
};

// One band's rendering: where it is, and how far it has come.
class Renderer::Pass {
public:
    Pass(Parts& parts, const Control& control, Tiling& tiling, std::uint32_t firstRow, std::uint32_t rows)
        : parts_(parts), control_(control), tiling_(tiling), firstRow_(firstRow), rows_(rows) {}

    // All samples of all pixels of the band; false when cancelled.
    bool run() {
        const std::uint32_t samples = parts_.samples;
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
        const std::uint32_t filmWidth = parts_.frame.filmWidth;
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
        const double row = double{1.0} * parts_.frame.filmWidth * parts_.samples;
        control_.onProgress((firstRow_ * row + work_) / (wholeGroups(parts_.frame.height) * row));
    }

    // `from`: pixel and row of the film, and first sample. Returns how long it took, in milliseconds.
    double dispatch(gpu::Groups from, std::uint32_t width, std::uint32_t height, std::uint32_t batch) {
        double spent_ms = 0.0;
        {
            const Stopwatch watch(spent_ms);
            const Piece tile{from.x, firstRow_ + from.y, width, height, true};
            for (const Piece& piece : piecesOf(tile, parts_.litTiles)) dispatch(piece, from.z, batch);
        }
        parts_.clocks.dispatch += spent_ms;
        return spent_ms;
    }

    void dispatch(const Piece& piece, std::uint32_t firstSample, std::uint32_t batch) {
        // Vulkan promises workgroups up to 65535, and so the schema allows that many samples.
        std::vector<gpu::Groups> firstGroups;
        for (std::uint32_t i = 0; i < batch; ++i) {
            firstGroups.push_back(
                {piece.x / device::GROUP_EDGE, (piece.y - firstRow_) / device::GROUP_EDGE, firstSample + i});
        }
        const gpu::Kernel& pipeline = piece.isLit ? parts_.pipelines.front() : parts_.pipelines.back();
        pipeline.run(firstGroups, {piece.width / device::GROUP_EDGE, piece.height / device::GROUP_EDGE, 1});
        parts_.clocks.dispatches += batch;
    }

    Parts& parts_;
    const Control& control_;
    Tiling& tiling_;
    std::uint32_t firstRow_;
    std::uint32_t rows_;
    double work_ = 0.0;  // pixel samples of this band
};

Renderer::Parts::Parts(const gpu::Device& device, const compile::CompiledScene& compiled,
                       const device::Specialisation& specialisation, Values values, compile::LitTiles tiles,
                       const SceneLayout& layout)
    : frame(compiled.frame),
      samples(compiled.samples),
      bandRows(rowsOfBand(device, frame)),
      scene(device, layout.size, gpu::Access::hostWrites),
      film(device, std::uint64_t{bandRows} * frame.filmWidth) {
    {
        const Stopwatch watch(clocks.upload);
        upload(layout, scene);
        uploadTexels(device, compiled, specialisation, texels);
    }
    const Stopwatch watch(clocks.compile);
    const auto addPipeline = [&](const Variant& variant, const device::Specialisation& constants) {
        std::array<std::uint32_t, device::kSpecialisationCount> words{};
        std::memcpy(words.data(), &constants, sizeof constants);
        std::span<const std::uint32_t> shader = embeddedShader(variant);
        std::vector<std::uint32_t> withValues;
        if (values == Values::asConstants) {
            withValues = gpu::withConstantBlock(shader, std::as_bytes(std::span(&layout.block, 1)));
            shader = withValues;
        }
        pipelines.emplace_back(device, shader, bindings(layout, scene, film.buffer(), texels), words);
        // Drivers may put off compiling until the first dispatch: one workgroup, which render() clears away.
        const gpu::Groups corner{0, 0, 0};
        pipelines.back().run({&corner, 1}, {1, 1, 1});
    };
    const std::uint64_t unlit = unlitPixels(tiles);
    const bool isDark = tiles.isKnown() && unlit == allPixels(tiles);
    if (!isDark) addPipeline(variantFor(compiled), specialisation);
    if (isDark || pays(unlit * samples, device))
        addPipeline(withoutGratings(variantFor(compiled)), compile::withoutGratings(specialisation));
    if (pipelines.size() == 2) litTiles = std::move(tiles);
}

Renderer::Renderer(const gpu::Device& device, const compile::CompiledScene& scene,
                   const device::Specialisation& specialisation, Values values, compile::LitTiles litTiles)
    : parts_(std::make_unique<Parts>(device, scene, specialiseFor(device, scene, specialisation), values,
                                     std::move(litTiles), layOut(scene, device))) {}

Renderer::~Renderer() = default;

const Clocks& Renderer::clocks() const {
    return parts_->clocks;
}

bool Renderer::render(const Control& control) {
    Parts& parts = *parts_;
    const device::Frame& frame = parts.frame;
    Tiling tiling(frame.filmWidth, parts.bandRows, parts.samples, control.tile);
    std::vector<image::Pixel> pixels;
    for (std::uint32_t firstRow = 0; firstRow < frame.height; firstRow += parts.bandRows) {
        const std::uint32_t rows = std::min(parts.bandRows, frame.height - firstRow);
        {
            const Stopwatch watch(parts.clocks.dispatch);
            parts.film.clear(firstRow, std::uint64_t{wholeGroups(rows)} * frame.filmWidth);
        }
        const bool complete = Pass(parts, control, tiling, firstRow, wholeGroups(rows)).run();
        {
            const Stopwatch watch(parts.clocks.readback);
            pixels.clear();
            parts.film.read(frame, rows, pixels);
        }
        if (control.onBand) control.onBand({firstRow, rows, pixels});
        if (!complete) return false;
    }
    return true;
}

}  // namespace fringe::render
