#include "compile/near_field.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "compile/extent.hpp"

namespace fringe::compile {
namespace {

using glm::dvec2, glm::dvec3;

struct Extent {
    double operator()(const optics::Slits&) const { return kInfinity; }
    double operator()(const optics::RectangularAperture& a) const {
        return std::hypot(a.width / units::m, a.height / units::m);
    }
    double operator()(const optics::CircularAperture& a) const { return a.diameter / units::m; }
    double operator()(const optics::PolygonalAperture& a) const {
        double radius = 0.0;
        for (const dvec2& vertex : a.vertices) radius = std::max(radius, glm::length(vertex));
        return 2.0 * radius;
    }
    double operator()(const optics::MaskAperture& a) const {
        return std::hypot(a.columns, a.rows) * (a.pixel / units::m);
    }
    double operator()(const optics::LatticeAperture& a) const { return std::visit(*this, a.cell); }
};

// The main part of the light: a tube as wide as the opening that widens by the first ten side lobes.
class Tube {
public:
    Tube(const scene::Grating& grating, double halfExtent)
        : grating_(grating), half_(halfExtent), spread_(10.0 * kFresnelWavelength / (2.0 * halfExtent)) {}

    // From where to where along the beam it meets the shape, at the most.
    Interval meets(const scene::Shape& shape) const {
        constexpr Interval kNothing{1.0, 0.0};
        Interval along = extentFrom(grating_.position, shape, grating_.beam.direction);
        if (const auto plane = planeOf(shape)) {
            const double slope = glm::dot(grating_.beam.direction, plane->normal);
            const double height = glm::dot(plane->point - grating_.position, plane->normal);
            // Where a ray of the tube's rim meets the plane, in front of the opening.
            const double tilt = glm::length(glm::cross(grating_.beam.direction, plane->normal));
            const auto hit = [&](double sign) {
                const double steepness = std::abs(slope) + sign * spread_ * tilt;
                return (std::abs(height) - sign * half_ * tilt) / steepness;
            };
            if (height * slope <= 0.0) return kNothing;
            const double last = hit(-1.0);
            along.low = std::max(along.low, hit(1.0));
            if (last > 0.0) along.high = std::min(along.high, last);
        }
        along.low = std::max(along.low, 1e-6);
        if (along.low > along.high) return kNothing;
        const double far = std::isfinite(along.high) ? along.high : 1e6;
        const auto misses = [&](const dvec3& across) {
            const Interval aside = extentFrom(grating_.position, shape, across);
            return std::max(aside.low, -aside.high) > half_ + spread_ * far;
        };
        const dvec3 first = glm::normalize(
            glm::cross(grating_.beam.direction,
                       std::abs(grating_.beam.direction.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
        if (misses(first) || misses(glm::cross(grating_.beam.direction, first))) return kNothing;
        return along;
    }

    // From the opening's middle, of what is so far along the beam.
    double farthest(double along) const { return std::hypot(along, half_ + spread_ * along); }

private:
    const scene::Grating& grating_;
    double half_;
    double spread_;
};

// The way that the light goes on: in reflection a beam is given as what falls on the mirror, and its part
// along the normal turns round.
scene::Grating outgoing(const scene::Grating& grating) {
    scene::Grating result = grating;
    const double along = glm::dot(result.beam.direction, result.normal);
    if (along < 0.0) result.beam.direction -= 2.0 * along * result.normal;
    return result;
}

}  // namespace

double openingExtent(const optics::Aperture& aperture) {
    return std::visit(Extent{}, aperture);
}

double wholeExtent(const optics::Aperture& aperture) {
    const auto* lattice = std::get_if<optics::LatticeAperture>(&aperture);
    if (lattice == nullptr) return openingExtent(aperture);
    return openingExtent(aperture) + (lattice->firstCount - 1.0) * glm::length(lattice->first) +
           (lattice->secondCount - 1.0) * glm::length(lattice->second);
}

bool hasNearField(const optics::Aperture& aperture) {
    return std::holds_alternative<optics::RectangularAperture>(aperture) ||
           std::holds_alternative<optics::CircularAperture>(aperture);
}

NearestField nearestField(const scene::Scene& scene, const scene::Grating& given) {
    const scene::Grating grating = outgoing(given);
    const double half = 0.5 * openingExtent(grating.aperture);
    const double convergence = grating.beam.focus ? 1.0 / (*grating.beam.focus / units::m) : 0.0;
    const Tube tube(grating, half);
    const auto numberAt = [&](double distance) {
        return half * half * (1.0 / distance - convergence) / kFresnelWavelength;
    };
    NearestField nearest{0.0, 0.0, kInfinity};
    for (const scene::Object& object : scene.objects) {
        if (!std::holds_alternative<scene::Diffuse>(scene.materials[object.material].model)) continue;
        const Interval along = tube.meets(object.shape);
        if (along.low > along.high) continue;
        for (const double distance : {along.low, along.high}) {
            if (const double number = std::abs(numberAt(distance)); number > nearest.fresnelNumber) {
                nearest.fresnelNumber = number;
                nearest.distance = distance;
            }
        }
        const double first = numberAt(along.low), last = numberAt(tube.farthest(along.high));
        const double least = first * last < 0.0 ? 0.0 : std::min(std::abs(first), std::abs(last));
        nearest.leastNumber = std::min(nearest.leastNumber, least);
    }
    nearest.leastNumber = std::min(nearest.leastNumber, nearest.fresnelNumber);
    return nearest;
}

}  // namespace fringe::compile
