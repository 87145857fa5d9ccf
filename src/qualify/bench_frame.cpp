#include "qualify/bench_frame.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/vec3.hpp>
#include <thread>
#include <vector>

#include "compile/lit_tiles.hpp"
#include "optics/color_difference.hpp"
#include "oracle/reference.hpp"
#include "scene/parse.hpp"

namespace fringe::qualify {
namespace {

// Of part number `part` of `parts` even ones of `whole`.
std::uint32_t middleOf(std::uint32_t part, std::uint32_t parts, std::uint32_t whole) {
    return static_cast<std::uint32_t>((2.0 * part + 1.0) * whole / (2.0 * parts));
}

glm::dvec3 xyzOf(const image::Pixel& pixel) {
    return {pixel.x, pixel.y, pixel.z};
}

}  // namespace

BenchFrame::BenchFrame(const gpu::Device& device, const std::string& sceneText, Gratings gratings)
    : scene_(scene::parseScene(sceneText, "benchmark")),
      compiled_(compile::compileScene(scene_)),
      constants_(compile::specialise(compiled_, scene_.camera)),
      renderer_(std::make_unique<render::Renderer>(
          device, compiled_, constants_, render::Values::asConstants,
          gratings == Gratings::whereLit ? compile::litTiles(scene_, compiled_) : compile::LitTiles())) {}

image::Image BenchFrame::render(const std::atomic<bool>& cancelled, std::uint32_t tile) {
    image::Image picture{scene_.image.width, scene_.image.height, {}};
    const auto append = [&](const render::Band& band) {
        picture.pixels.insert(picture.pixels.end(), band.pixels.begin(), band.pixels.end());
    };
    if (!renderer_->render({.cancelled = cancelled, .onProgress = {}, .onBand = append, .tile = tile}))
        picture.pixels.clear();
    return picture;
}

double BenchFrame::dispatch_ms(const std::atomic<bool>& cancelled, std::uint32_t tile) {
    const double before = renderer_->clocks().dispatch;
    const bool complete =
        renderer_->render({.cancelled = cancelled, .onProgress = {}, .onBand = {}, .tile = tile});
    return complete ? renderer_->clocks().dispatch - before : -1.0;
}

image::Image thinned(const image::Image& picture, std::uint32_t edge) {
    assert(picture.width >= edge && picture.height >= edge);
    image::Image few{edge, edge, {}};
    for (std::uint32_t i = 0; i < edge * edge; ++i) {
        few.pixels.push_back(
            picture.pixels[std::size_t{middleOf(i / edge, edge, picture.height)} * picture.width +
                           middleOf(i % edge, edge, picture.width)]);
    }
    return few;
}

image::Image thinnedReference(const std::string& sceneText, std::uint32_t edge, std::uint32_t samples,
                              const std::atomic<bool>& cancelled) {
    scene::Scene scene = scene::parseScene(sceneText, "benchmark");
    scene.image.samples = samples;
    const oracle::Reference reference(scene);
    image::Image few{edge, edge, {}};
    few.pixels.resize(std::size_t{edge} * edge);
    std::atomic<std::uint32_t> next = 0;
    const auto work = [&] {
        for (std::uint32_t i = next++; i < edge * edge && !cancelled; i = next++) {
            few.pixels[i] = reference.pixel(middleOf(i % edge, edge, scene.image.width),
                                            middleOf(i / edge, edge, scene.image.height), cancelled);
        }
    };
    {
        std::vector<std::jthread> helpers;
        for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) helpers.emplace_back(work);
        work();
    }
    if (cancelled) few.pixels.clear();
    return few;
}

PictureError pictureError(const image::Image& picture, const image::Image& reference) {
    assert(picture.pixels.size() == reference.pixels.size() && !picture.pixels.empty());
    constexpr double kWrong = 0.01, kMost = 0.99;
    const glm::dvec3 white(0.9505, 1.0, 1.0891);  // D65
    double peak = 0.0;
    for (const image::Pixel& pixel : reference.pixels) peak = std::max(peak, double{pixel.y});
    if (peak == 0.0) peak = 1.0;

    PictureError error;
    double squares = 0.0;
    std::size_t wrong = 0;
    std::vector<double> differences;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const glm::dvec3 got = xyzOf(picture.pixels[i]), expected = xyzOf(reference.pixels[i]);
        const glm::dvec3 off = glm::abs(got - expected) / peak;
        error.largest = std::max({error.largest, off.x, off.y, off.z});
        squares += off.y * off.y;
        if (off.y > kWrong) ++wrong;
        differences.push_back(
            optics::colorDifference(optics::labFromXyz(got, white), optics::labFromXyz(expected, white)));
    }
    std::sort(differences.begin(), differences.end());
    const auto count = static_cast<double>(picture.pixels.size());
    error.rms = std::sqrt(squares / count);
    error.deltaE = quantile(differences, kMost);
    error.wrong = static_cast<double>(wrong) / count;
    return error;
}

}  // namespace fringe::qualify
