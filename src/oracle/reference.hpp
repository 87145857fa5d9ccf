// The reference renderer: Fringe's scenes on the CPU, in double precision, by the shortest way from the
// definitions. It is what the renderer on the device is judged by, so it shares nothing with it but the scene
// and the pixel, and takes another formulation wherever there is a choice. It is built to be obviously right,
// not fast.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "image/image.hpp"
#include "oracle/camera.hpp"
#include "oracle/world.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

// Immutable once made; `render` may be called from several threads at once.
class Reference {
public:
    explicit Reference(const scene::Scene& scene, image::Quantity quantity = image::Quantity::color);

    // Renders rows [firstRow, firstRow + rowCount) of the picture into `out` (rowCount * width pixels, row by
    // row), on `threads` >= 1 threads, the caller's among them. Every pixel depends on the scene alone: not
    // on the number of threads, and not on which rows are rendered together. False if `cancelled` became
    // true, looked at before each sample; what `out` holds then is unfinished.
    bool render(std::uint32_t firstRow, std::uint32_t rowCount, std::span<image::Pixel> out, unsigned threads,
                const std::atomic<bool>& cancelled) const;

    // One of these pixels.
    image::Pixel pixel(std::uint32_t x, std::uint32_t y, const std::atomic<bool>& cancelled) const;

private:
    scene::Image image_;
    Camera camera_;
    World world_;
};

}  // namespace fringe::oracle
