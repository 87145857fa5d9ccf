#include "compile/casters.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "compile/extent.hpp"

namespace fringe::compile {
namespace {

using glm::dot;
using glm::dvec3;

// Where shadow rays to a light end. The shapes of area lights count as shapes.
Interval lightInterval(const scene::Light& light, dvec3 along) {
    if (std::holds_alternative<scene::EnvironmentLight>(light.model)) return {-kInfinity, kInfinity};
    if (const auto* directional = std::get_if<scene::DirectionalLight>(&light.model)) {
        const double rise = -dot(directional->direction, along);
        const double spread = std::sin(0.5 * (directional->angularSize / units::rad));
        return {rise < spread ? -kInfinity : kInfinity, rise > -spread ? kInfinity : -kInfinity};
    }
    if (const auto* grating = std::get_if<scene::Grating>(&light.model)) {
        const double half =
            0.5 * (grating->beam.height / units::m);  // a ray ends at the slits' height it comes from
        return around(dot(grating->position, along), half * std::abs(dot(grating->slitDirection, along)));
    }
    return std::visit(
        [along](const auto& model) -> Interval {
            if constexpr (requires { model.position; }) return around(dot(model.position, along), 0.0);
            else return {kInfinity, -kInfinity};  // nothing
        },
        light.model);
}

bool isOnOneSide(const FlatPlane& plane, const std::vector<scene::Shape>& shapes, const scene::Scene& scene) {
    Interval all{kInfinity, -kInfinity};
    for (const scene::Shape& shape : shapes) all = join(all, extentAlong(shape, plane.normal));
    for (const scene::Light& light : scene.lights) all = join(all, lightInterval(light, plane.normal));
    // Walls that share an edge touch each other's plane up to the rounding of their coordinates.
    const double height = dot(plane.point, plane.normal);
    const double finite = std::max(std::isfinite(all.low) ? std::abs(all.low) : 0.0,
                                   std::isfinite(all.high) ? std::abs(all.high) : 0.0);
    const double rounding = 1e-12 * std::max(finite, std::abs(height));
    return all.low >= height - rounding || all.high <= height + rounding;
}

}  // namespace

std::vector<scene::Shape> allShapes(const scene::Scene& scene) {
    std::vector<scene::Shape> shapes;
    for (const scene::Object& object : scene.objects) shapes.push_back(object.shape);
    for (const scene::Light& light : scene.lights) {
        if (const auto* area = std::get_if<scene::AreaLight>(&light.model)) {
            std::visit([&](const auto& shape) { shapes.emplace_back(shape); }, area->shape);
        }
    }
    return shapes;
}

std::vector<bool> shadowCasters(const scene::Scene& scene) {
    // Looking at every shape for every flat one is quadratic; in scenes of many shapes a few walls matter
    // little.
    constexpr std::size_t kMostFlatShapes = 64;
    const std::vector<scene::Shape> shapes = allShapes(scene);
    std::vector<bool> casters(shapes.size(), true);
    const auto flat =
        std::count_if(shapes.begin(), shapes.end(), [](const auto& s) { return planeOf(s).has_value(); });
    if (static_cast<std::size_t>(flat) > kMostFlatShapes) return casters;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const auto plane = planeOf(shapes[i]);
        if (plane && isOnOneSide(*plane, shapes, scene)) casters[i] = false;
    }
    return casters;
}

}  // namespace fringe::compile
