#include "compile/shapes.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "compile/casters.hpp"
#include "compile/number.hpp"

namespace fringe::compile {
namespace {

using glm::dvec3;

dvec3 dual(dvec3 halfEdge) {
    return halfEdge / glm::dot(halfEdge, halfEdge);
}

struct ShapeCompiler {
    CompiledScene& out;
    device::uint material;

    void operator()(const scene::Plane& s) const {
        out.planes.push_back({toFloat(s.point), toFloat(s.normal), material});
    }
    void operator()(const scene::Rectangle& s) const {
        out.rectangles.push_back({toFloat(s.center), toFloat(dual(s.u)), toFloat(dual(s.v)), material});
    }
    void operator()(const scene::Disc& s) const {
        out.discs.push_back({toFloat(s.center), toFloat(s.normal), toFloat(s.innerRadius * s.innerRadius),
                             toFloat(s.radius * s.radius), material});
    }
    void operator()(const scene::Sphere& s) const {
        out.spheres.push_back({toFloat(s.center), toFloat(s.radius), material});
    }
    void operator()(const scene::Box& s) const {
        out.boxes.push_back(
            {toFloat(s.center), toFloat(dual(s.u)), toFloat(dual(s.v)), toFloat(dual(s.w)), material});
    }
    void operator()(const scene::Cylinder& s) const {
        const double height = glm::length(s.top - s.base);
        out.cylinders.push_back({toFloat(s.base), toFloat((s.top - s.base) / height), toFloat(height),
                                 toFloat(s.radius), s.capped ? 1U : 0U, material});
    }
    void operator()(const scene::Cone& s) const {
        const double height = glm::length(s.base - s.apex);
        out.cones.push_back({toFloat(s.apex), toFloat((s.base - s.apex) / height), toFloat(height),
                             toFloat(s.radius / height), s.capped ? 1U : 0U, material});
    }
    void operator()(const scene::Triangle& s) const {
        const dvec3 edge1 = s.vertices[1] - s.vertices[0];
        const dvec3 edge2 = s.vertices[2] - s.vertices[0];
        out.triangles.push_back({toFloat(s.vertices[0]), toFloat(edge1), toFloat(edge2),
                                 toFloat(glm::normalize(glm::cross(edge1, edge2))), material});
    }
};

// The clear middle of an optical disc, if it has one.
std::optional<scene::Disc> clearHub(const scene::Object& object, const scene::Scene& scene) {
    const auto* disc = std::get_if<scene::OpticalDisc>(&scene.materials[object.material].model);
    const auto* shape = std::get_if<scene::Disc>(&object.shape);
    if (disc == nullptr || shape == nullptr || !disc->metal || shape->innerRadius >= disc->metalInnerRadius)
        return {};
    return scene::Disc{shape->center, shape->normal, std::min(disc->metalInnerRadius, shape->radius),
                       shape->innerRadius};
}

}  // namespace

void addShapes(const scene::Scene& scene, device::uint firstLightMaterial, CompiledScene& out) {
    const std::vector<scene::Shape> shapes = allShapes(scene);
    const std::vector<bool> casters = shadowCasters(scene);
    std::vector<std::pair<scene::Disc, device::uint>> hubs;
    const auto addAll = [&](bool casting) {
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (casters[i] != casting) continue;
            const device::uint material = i < scene.objects.size()
                                              ? scene.objects[i].material
                                              : firstLightMaterial + count(i - scene.objects.size());
            scene::Shape shape = shapes[i];
            // A clear hub is a shape of its own, which casts no shadow.
            if (const auto hub =
                    i < scene.objects.size() ? clearHub(scene.objects[i], scene) : std::nullopt) {
                hubs.emplace_back(*hub, material);
                if (hub->radius == std::get<scene::Disc>(shape).radius) continue;
                std::get<scene::Disc>(shape).innerRadius = hub->radius;
            }
            std::visit(ShapeCompiler{out, material}, shape);
        }
    };
    addAll(true);
    out.planeCasters = count(out.planes.size());
    out.rectangleCasters = count(out.rectangles.size());
    out.discCasters = count(out.discs.size());
    out.triangleCasters = count(out.triangles.size());
    addAll(false);
    for (const auto& [hub, material] : hubs) ShapeCompiler{out, material}(hub);
    out.clearHubs = !hubs.empty();
}

}  // namespace fringe::compile
