#include "oracle/emitters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/frame.hpp"
#include "oracle/sampler.hpp"

namespace fringe::oracle {
namespace {

using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;
using std::numbers::pi;

// A point of a flat emitter of `area`, taken uniformly.
std::optional<EmitterPoint> flatPoint(const dvec3& position, const dvec3& normal, double area, bool twoSided,
                                      const dvec3& observer) {
    const dvec3 toObserver = observer - position;
    const double distance = length(toObserver);
    const double height = dot(toObserver, normal);
    if (height == 0.0 || (height < 0.0 && !twoSided)) return {};
    return EmitterPoint{position, std::abs(height) / distance * area / (distance * distance)};
}

std::optional<EmitterPoint> pointOf(const scene::Rectangle& rectangle, bool twoSided, const dvec3& observer,
                                    const glm::dvec2& u) {
    const auto& [center, halfU, halfV] = rectangle;
    const dvec3 position = center + (2.0 * u.x - 1.0) * halfU + (2.0 * u.y - 1.0) * halfV;
    return flatPoint(position, normalize(cross(halfU, halfV)), area(rectangle), twoSided, observer);
}

// A hole takes its share of the squared radius.
std::optional<EmitterPoint> pointOf(const scene::Disc& disc, bool twoSided, const dvec3& observer,
                                    const glm::dvec2& u) {
    const glm::dvec2 onUnit = onUnitDisc(u);
    const double squaredRadius = dot(onUnit, onUnit);
    const double squaredHole = disc.innerRadius * disc.innerRadius;
    const double squaredRing = disc.radius * disc.radius - squaredHole;
    const double stretch = squaredRadius > 0.0 ? std::sqrt(squaredRing + squaredHole / squaredRadius) : 0.0;
    const dvec3 offset = Frame::around(disc.normal).toWorld(dvec3(stretch * onUnit, 0.0));
    return flatPoint(disc.center + offset, disc.normal, area(disc), twoSided, observer);
}

// From outside, a sphere fills a cone of directions about its centre, whose projection along the cone's axis
// is a disc of radius sin(half angle): uniform there, and 1 / cosine more solid angle the further a direction
// is from the axis. From inside it fills every direction.
std::optional<EmitterPoint> pointOf(const scene::Sphere& sphere, bool twoSided, const dvec3& observer,
                                    const glm::dvec2& u) {
    const dvec3 toCenter = sphere.center - observer;
    const double distance = length(toCenter);
    dvec3 direction;
    double solidAngle = 4.0 * pi;
    if (distance > sphere.radius) {
        const double sine = sphere.radius / distance;
        const glm::dvec2 across = sine * onUnitDisc(u);
        const double cosine = std::sqrt(1.0 - dot(across, across));
        direction = Frame::around(toCenter / distance).toWorld(dvec3(across, cosine));
        solidAngle = pi * sine * sine / cosine;
    } else if (twoSided) {
        const double z = 1.0 - 2.0 * u.x;
        const double angle = 2.0 * pi * u.y;
        direction = dvec3(std::sqrt(1.0 - z * z) * glm::dvec2(std::cos(angle), std::sin(angle)), z);
    } else {
        return {};
    }
    const double closest = dot(toCenter, direction);
    const dvec3 miss = toCenter - closest * direction;
    const double halfChord = std::sqrt(std::max(0.0, sphere.radius * sphere.radius - dot(miss, miss)));
    const double reach = distance > sphere.radius ? closest - halfChord : closest + halfChord;
    return EmitterPoint{observer + reach * direction, solidAngle};
}

}  // namespace

double area(const scene::Rectangle& rectangle) {
    return 4.0 * length(cross(rectangle.u, rectangle.v));
}

double area(const scene::Disc& disc) {
    return pi * (disc.radius * disc.radius - disc.innerRadius * disc.innerRadius);
}

double area(const scene::Sphere& sphere) {
    return 4.0 * pi * sphere.radius * sphere.radius;
}

std::optional<EmitterPoint> pointOn(const scene::Shape& shape, bool twoSided, const dvec3& observer,
                                    const glm::dvec2& u) {
    return std::visit(
        [&](const auto& s) -> std::optional<EmitterPoint> {
            if constexpr (requires { pointOf(s, twoSided, observer, u); })
                return pointOf(s, twoSided, observer, u);
            return {};
        },
        shape);
}

}  // namespace fringe::oracle
