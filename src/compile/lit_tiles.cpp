#include "compile/lit_tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "compile/extent.hpp"
#include "compile/grating_grid.hpp"
#include "compile/materials.hpp"

namespace fringe::compile {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::size_t kMostCells = std::size_t{1} << 15;  // 32 to a side, where a room is a cube

// A part of the picture; coordinates run from -1 to 1 and upwards.
struct Window {
    dvec2 low{std::numeric_limits<double>::infinity()};
    dvec2 high{-std::numeric_limits<double>::infinity()};
};
const Window kWholePicture{dvec2(-1.0), dvec2(1.0)};

// Where regions of space are seen, never less than that.
class View {
public:
    View(const scene::Camera& camera, const device::Camera& packed)
        : isOrthographic_(std::holds_alternative<scene::Orthographic>(camera.projection)),
          position_(packed.position),
          forward_(packed.forward),
          right_(dvec3(packed.right) / glm::dot(dvec3(packed.right), dvec3(packed.right))),
          up_(dvec3(packed.up) / glm::dot(dvec3(packed.up), dvec3(packed.up))),
          halfSize_(glm::length(dvec3(packed.right)), glm::length(dvec3(packed.up))),
          lensRadius_(glm::length(dvec3(packed.lensRight))),
          focus_(packed.focusDistance) {}

    // Nothing where it lies behind the camera.
    std::optional<Window> windowOf(const Region& region) const {
        const double size = std::max(farthestCoordinate(region.low), farthestCoordinate(region.high));
        if (std::isinf(size)) return kWholePicture;
        const std::array<dvec3, 8> corners = seenCorners(region);
        if (isOrthographic_) {
            Window window;
            for (const dvec3& corner : corners) add(dvec2(corner), window);
            return window;
        }
        // What lies nearer than this plane is in the picture only next to the camera.
        const double nearest = 1e-5 * std::max(size, farthestCoordinate(position_));
        const dvec3 away = glm::max(glm::max(region.low - position_, position_ - region.high), dvec3(0.0));
        if (glm::length(away) <= lensRadius_ + nearest * (2.0 + glm::length(halfSize_))) return kWholePicture;
        return project(corners, nearest);
    }

private:
    static double farthestCoordinate(dvec3 point) {
        const dvec3 size = glm::abs(point);
        return std::max({size.x, size.y, size.z});
    }

    // To the right and upwards, in halves of the picture at distance 1, and forwards.
    std::array<dvec3, 8> seenCorners(const Region& region) const {
        std::array<dvec3, 8> corners;
        for (unsigned i = 0; i < 8; ++i) {
            const dvec3 corner((i & 1U) != 0 ? region.high.x : region.low.x,
                               (i & 2U) != 0 ? region.high.y : region.low.y,
                               (i & 4U) != 0 ? region.high.z : region.low.z);
            const dvec3 offset = corner - position_;
            corners[i] = {glm::dot(offset, right_), glm::dot(offset, up_), glm::dot(offset, forward_)};
        }
        return corners;
    }

    // The projection of a convex body is bounded by those of its corners, here with those that the plane
    // cuts.
    std::optional<Window> project(const std::array<dvec3, 8>& corners, double nearest) const {
        Window window;
        double least = std::numeric_limits<double>::infinity(), most = 0.0;  // depth
        const auto project = [&](dvec3 point) {
            add(dvec2(point) / point.z, window);
            least = std::min(least, point.z);
            most = std::max(most, point.z);
        };
        for (unsigned i = 0; i < 8; ++i) {
            if (corners[i].z >= nearest) project(corners[i]);
            for (unsigned bit = 1; bit < 8; bit *= 2) {
                const dvec3 a = corners[i], b = corners[i | bit];
                if ((a.z < nearest) != (b.z < nearest))
                    project(glm::mix(a, b, (nearest - a.z) / (b.z - a.z)));
            }
        }
        if (most == 0.0) return std::nullopt;
        // From elsewhere on the lens a point that is out of focus is seen in another place.
        if (lensRadius_ > 0.0) {
            const double blur = lensRadius_ * std::max(std::abs(1.0 / least - 1.0 / focus_),
                                                       std::abs(1.0 / most - 1.0 / focus_));
            window.low -= blur / halfSize_;
            window.high += blur / halfSize_;
        }
        return window;
    }

    static void add(dvec2 point, Window& window) {
        window.low = glm::min(window.low, point);
        window.high = glm::max(window.high, point);
    }

    bool isOrthographic_;
    dvec3 position_, forward_, right_, up_;
    dvec2 halfSize_;  // of the picture, at distance 1
    double lensRadius_, focus_;
};

Region boxOf(const scene::Shape& shape) {
    Region box{};
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 along(0.0);
        along[axis] = 1.0;
        const Interval side = extentAlong(shape, along);
        box.low[axis] = side.low;
        box.high[axis] = side.high;
    }
    return box;
}

void mark(const Window& window, const device::Frame& frame, LitTiles& tiles) {
    // A pixel more on each side covers the rounding of rays and hits.
    const dvec2 size(frame.width, frame.height);
    const dvec2 low = dvec2(0.5 + 0.5 * window.low.x, 0.5 - 0.5 * window.high.y) * size - 1.0;
    const dvec2 high = dvec2(0.5 + 0.5 * window.high.x, 0.5 - 0.5 * window.low.y) * size + 1.0;
    if (high.x < 0.0 || high.y < 0.0 || low.x >= size.x || low.y >= size.y) return;
    const auto tile = [](double pixel, std::uint32_t count) {
        return static_cast<std::uint32_t>(std::clamp(pixel / LitTiles::kEdge, 0.0, count - 1.0));
    };
    for (std::uint32_t row = tile(low.y, tiles.rows); row <= tile(high.y, tiles.rows); ++row) {
        for (std::uint32_t column = tile(low.x, tiles.columns); column <= tile(high.x, tiles.columns);
             ++column)
            tiles.lit[std::size_t{row} * tiles.columns + column] = true;
    }
}

}  // namespace

LitTiles litTiles(const scene::Scene& scene, const CompiledScene& compiled) {
    LitTiles tiles;
    // The rows of a spectrum are no places.
    if (GratingReach(compiled).count() == 0 || compiled.isSpectrum) return tiles;
    tiles.columns = (compiled.frame.width + LitTiles::kEdge - 1) / LitTiles::kEdge;
    tiles.rows = (compiled.frame.height + LitTiles::kEdge - 1) / LitTiles::kEdge;
    tiles.lit.assign(std::size_t{tiles.columns} * tiles.rows, false);

    const View view(scene.camera, compiled.frame.camera);
    const std::vector<Region> regions = litRegions(scene, compiled, kMostCells);
    for (const Region& region : regions) {
        if (const auto window = view.windowOf(region)) mark(*window, compiled.frame, tiles);
    }
    if (regions.empty()) return tiles;
    for (const scene::Object& object : scene.objects) {
        if (!isSpecular(scene.materials[object.material])) continue;
        if (const auto window = view.windowOf(boxOf(object.shape))) mark(*window, compiled.frame, tiles);
    }
    return tiles;
}

}  // namespace fringe::compile
