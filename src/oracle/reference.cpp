#include "oracle/reference.hpp"

#include <cassert>
#include <thread>
#include <vector>

#include "oracle/path.hpp"
#include "oracle/sampler.hpp"

namespace fringe::oracle {
namespace {

// What of a pixel is sampled.
enum Sampled : Dimension { inPixel, onLens, alongPath };

}  // namespace

Reference::Reference(const scene::Scene& scene, image::Quantity quantity)
    : image_(scene.image),
      camera_(scene.camera, scene.image.width, scene.image.height),
      world_(makeWorld(scene, quantity)) {}

bool Reference::render(std::uint32_t firstRow, std::uint32_t rowCount, std::span<image::Pixel> out,
                       unsigned threads, const std::atomic<bool>& cancelled) const {
    const std::size_t count = std::size_t{rowCount} * image_.width;
    assert(threads >= 1 && out.size() == count);

    // Workers take one pixel after another until none is left.
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < count && !cancelled; i = next++) {
            const auto x = static_cast<std::uint32_t>(i % image_.width);
            const auto y = static_cast<std::uint32_t>(i / image_.width);
            out[i] = pixel(x, firstRow + y, cancelled);
        }
    };
    {
        std::vector<std::jthread> helpers;
        for (unsigned i = 1; i < threads; ++i) helpers.emplace_back(work);
        work();
    }
    return !cancelled;
}

// The mean over the pixel's samples; black and flagged if a formula was 0/0 in any of them.
image::Pixel Reference::pixel(std::uint32_t x, std::uint32_t y, const std::atomic<bool>& cancelled) const {
    Value sum;
    for (std::uint32_t i = 0; i < image_.samples && !cancelled; ++i) {
        const Sampler sampler(image_.seed, std::uint64_t{y} * image_.width + x, i, image_.samples);
        const Ray ray = camera_.ray(glm::dvec2(x, y) + sampler.pair(inPixel), sampler.pair(onLens));
        const Tracer tracer(world_, sampler, image_.maxDepth);
        sum += tracer.radiance(ray, Path{.dimension = alongPath});
    }
    if (sum.nonFinite) return {.nonFinite = true};
    const Xyz mean = sum.xyz / static_cast<double>(image_.samples);
    return {static_cast<float>(mean.x), static_cast<float>(mean.y), static_cast<float>(mean.z)};
}

}  // namespace fringe::oracle
