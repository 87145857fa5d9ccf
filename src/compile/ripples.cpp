#include "compile/ripples.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <variant>

#include "compile/extent.hpp"
#include "optics/spectrum.hpp"

namespace fringe::compile {
namespace {

using glm::dvec3;

constexpr double kHidingRipples = 2.0;  // smears of so many ripples hide them wholly

// A sample's least width on a shape.
double leastPixel(const scene::Scene& scene, const device::Frame& frame, const scene::Shape& shape) {
    const scene::Camera& camera = scene.camera;
    const auto* perspective = std::get_if<scene::Perspective>(&camera.projection);
    if (perspective == nullptr) return frame.pixelWidth;
    // Through mirrors the way is only longer.
    dvec3 away;
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 along(0.0);
        along[axis] = 1.0;
        away[axis] = nearest(extentFrom(camera.position, shape, along));
    }
    const double lens = perspective->lens ? 0.5 * (perspective->lens->diameter / units::m) : 0.0;
    return frame.pixelAngle * std::max(glm::length(away) - lens, 0.0);
}

class Grating {
public:
    explicit Grating(const device::SlitGrating& g) : g_(g) {}

    bool showsRippleOn(const scene::Shape& shape, double pixel) const {
        const Interval height = extentFrom(g_.position, shape, g_.along);
        const Interval across = extentFrom(g_.position, shape, g_.across);
        const Interval normal = extentFrom(g_.position, shape, g_.normal);
        if (normal.high <= 0.0) return false;  // nothing goes there
        const double range = std::hypot(farthest(across), std::max(normal.high, 0.0));
        if (!std::isfinite(range)) return true;
        const bool isCollimated = g_.convergence == 0.0F;
        if (isCollimated && nearest(height) > reach(range)) return false;

        const auto plane = planeOf(shape);
        const double slope = plane ? glm::length(glm::cross(dvec3(g_.along), plane->normal)) : 0.0;
        const double nearRange = std::hypot(nearest(across), std::max(normal.low, 0.0));
        // Against the range, a pixel's smear is constant and the source's grows, a ripple grows like its root
        // or as fast: the pixel hides least far away, the source nearby.
        return pixel * slope <= kHidingRipples * ripple(range) &&
               g_.angularSize * nearRange <= kHidingRipples * ripple(nearRange);
    }

    // What showsRippleOn() says nothing about.
    bool isBeyondReckoning() const { return g_.isWide != 0 || g_.linesAreImages != 0 || g_.betaIn != 0.0F; }

private:
    // From the axis, with what diffraction spills (SPILL_REACH of shaders/beam.glsl).
    double reach(double range) const {
        return g_.halfHeight + 0.5 * g_.angularSize * range +
               20.0 * std::sqrt(0.5 * optics::kLongestVisible.si * range);
    }
    // Width of one, or of the main lobe of a beam narrower than that.
    double ripple(double range) const {
        return std::max(std::sqrt(optics::kLongestVisible.si * range),
                        0.5 * optics::kLongestVisible.si * range / g_.halfHeight);
    }

    const device::SlitGrating& g_;
};

bool isMatt(const scene::Scene& scene, const scene::Object& object) {
    return std::holds_alternative<scene::Diffuse>(scene.materials[object.material].model);
}

}  // namespace

bool ripplesShow(const scene::Scene& scene, const device::Frame& frame,
                 std::span<const device::SlitGrating> gratings) {
    return std::any_of(gratings.begin(), gratings.end(), [&](const device::SlitGrating& packed) {
        if (packed.profile == device::GAUSSIAN_BEAM && packed.isWide == 0) return false;
        const Grating grating(packed);
        return grating.isBeyondReckoning() ||
               std::any_of(scene.objects.begin(), scene.objects.end(), [&](const scene::Object& object) {
                   return isMatt(scene, object) &&
                          grating.showsRippleOn(object.shape, leastPixel(scene, frame, object.shape));
               });
    });
}

}  // namespace fringe::compile
