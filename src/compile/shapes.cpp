#include "compile/shapes.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "compile/casters.hpp"
#include "compile/extent.hpp"
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

// A shape and its place in the array of its kind.
struct PlacedShape {
    scene::Shape shape;
    device::uint index;
};

// How many there are of the shape's kind so far.
device::uint sizeOfKind(const scene::Shape& shape, const CompiledScene& out) {
    const std::array sizes{out.planes.size(), out.rectangles.size(), out.discs.size(), out.spheres.size(),
                           out.boxes.size(),  out.cylinders.size(),  out.cones.size(), out.triangles.size()};
    static_assert(sizes.size() == std::variant_size_v<scene::Shape>);
    return count(sizes.at(shape.index()));
}

// Over the shapes that lie in storage buffers: the loops over the others are unrolled. Planes have no box.
Tree treeOf(const std::vector<PlacedShape>& placed, const CompiledScene& out) {
    std::vector<TreeLeaf> leaves;
    for (const auto& [shape, index] : placed) {
        if (sizeOfKind(shape, out) <= device::FEW || std::holds_alternative<scene::Plane>(shape)) continue;
        TreeLeaf leaf{count(shape.index()), index, {}, {}};
        for (int axis = 0; axis < 3; ++axis) {
            dvec3 along(0.0);
            along[axis] = 1.0;
            const Interval interval = extentAlong(shape, along);
            leaf.low[axis] = interval.low;
            leaf.high[axis] = interval.high;
        }
        leaves.push_back(leaf);
    }
    return buildTree(std::move(leaves));
}

}  // namespace

void addShapes(const scene::Scene& scene, device::uint firstLightMaterial, CompiledScene& out) {
    const std::vector<scene::Shape> shapes = allShapes(scene);
    const std::vector<bool> casters = shadowCasters(scene);
    std::vector<std::pair<scene::Disc, device::uint>> hubs;
    std::vector<PlacedShape> placed;
    const auto add = [&](const scene::Shape& shape, device::uint material) {
        std::visit(ShapeCompiler{out, material}, shape);
        placed.push_back({shape, sizeOfKind(shape, out) - 1});
    };
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
            add(shape, material);
        }
    };
    addAll(true);
    out.planeCasters = count(out.planes.size());
    out.rectangleCasters = count(out.rectangles.size());
    out.discCasters = count(out.discs.size());
    out.triangleCasters = count(out.triangles.size());
    addAll(false);
    for (const auto& [hub, material] : hubs) add(hub, material);
    out.clearHubs = !hubs.empty();
    out.tree = treeOf(placed, out);
}

}  // namespace fringe::compile
