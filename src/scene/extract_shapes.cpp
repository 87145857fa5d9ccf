#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>

#include "scene/extract.hpp"

namespace fringe::scene {
namespace {

// Cosine of the angle between edges that still pass for perpendicular: edges written to four digits miss by
// up to 1e-4. What is left of it is taken out, so that the edges of the scene are perpendicular to rounding.
constexpr double kPerpendicular = 1e-4;

// Sine below which directions written to six digits cannot be told from parallel.
constexpr double kParallel = 1e-6;

// Records a problem at `node` if `length`, which is `what` in messages, is too small for a shape.
void requireLength(const Node& node, double length, std::string_view what) {
    if (length >= kSmallestSize) return;
    node.refuse(fmt::format("{} is {} m; write one of at least 1e-9 m (1 nm)", what, length));
}

struct Edge {
    Node node;
    dvec3 vector;
};

Edge edgeOf(const Node& node) {
    requireLength(node, glm::length(node.vector()), fmt::format("the length of \"{}\"", node.key()));
    return {node, node.vector()};
}

// The edge at `node`, made exactly perpendicular to the `others`, which it must nearly be already.
Edge perpendicularEdge(const Node& node, std::initializer_list<Edge> others) {
    const dvec3 given = edgeOf(node).vector;
    dvec3 made = given;
    for (const Edge& other : others) {
        made -= other.vector * (glm::dot(other.vector, made) / glm::dot(other.vector, other.vector));
    }
    for (const Edge& other : others) {
        const double cosine =
            glm::dot(given, other.vector) / (glm::length(given) * glm::length(other.vector));
        // An edge of no length makes this NaN, and has its problem already.
        if (!(std::abs(cosine) > kPerpendicular)) continue;
        const std::string remedy = glm::length(made) > kParallel * glm::length(given)
                                       ? fmt::format("the nearest that is perpendicular is {}", written(made))
                                       : "write one that points another way";
        const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) / units::deg.si;
        node.refuse(fmt::format("\"{}\" is not perpendicular to \"{}\", but at {:.4g} degrees; {}",
                                node.key(), other.node.key(), angle, remedy),
                    {other.node});
    }
    return {node, made};
}

double radiusOf(const Node& node) {
    const double radius = node["radius"].number();
    requireLength(node["radius"], radius, "\"radius\"");
    return radius;
}

Plane planeOf(const Node& node) {
    return {node["point"].vector(), unitDirection(node["normal"])};
}

Box boxOf(const Node& node) {
    const Edge u = edgeOf(node["u"]);
    const Edge v = perpendicularEdge(node["v"], {u});
    const Edge w = perpendicularEdge(node["w"], {u, v});
    return {node["center"].vector(), u.vector, v.vector, w.vector};
}

// The two ends of an axis, which must be apart.
std::array<dvec3, 2> axisOf(const Node& node, std::string_view from, std::string_view to) {
    const Node start = node[from];
    const Node end = node[to];
    if (glm::distance(start.vector(), end.vector()) < kSmallestSize) {
        end.refuse(
            fmt::format("\"{}\" and \"{}\" are the same point; write points at least 1e-9 m (1 nm) apart",
                        from, to),
            {start});
    }
    return {start.vector(), end.vector()};
}

Cylinder cylinderOf(const Node& node) {
    const auto [base, top] = axisOf(node, "base", "top");
    return {base, top, radiusOf(node), node["capped"].flag()};
}

Cone coneOf(const Node& node) {
    const auto [base, apex] = axisOf(node, "base", "apex");
    return {base, apex, radiusOf(node), node["capped"].flag()};
}

Triangle triangleOf(const Node& node) {
    const Node vertices = node["vertices"];
    const std::vector<Node> corners = vertices.elements();
    const Triangle triangle{{corners[0].vector(), corners[1].vector(), corners[2].vector()}};
    const dvec3 a = triangle.vertices[1] - triangle.vertices[0];
    const dvec3 b = triangle.vertices[2] - triangle.vertices[0];
    const dvec3 c = triangle.vertices[2] - triangle.vertices[1];
    const double longest = std::max({glm::length(a), glm::length(b), glm::length(c)});
    requireLength(vertices, longest, "the longest side");
    if (longest >= kSmallestSize && glm::length(glm::cross(a, b)) < kParallel * longest * longest) {
        vertices.refuse("the vertices lie on one line; write three points that span an area");
    }
    return triangle;
}

}  // namespace

std::string written(const dvec3& vector) {
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", vector.x, vector.y, vector.z);
}

dvec3 unitDirection(const Node& node) {
    const dvec3 vector = node.vector();
    const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
    if (largest == 0.0) {
        node.refuse(fmt::format(
            "\"{}\" is [0, 0, 0], which points nowhere; write a direction such as [0, 1, 0]", node.key()));
        return dvec3(0.0);
    }
    return glm::normalize(vector / largest);  // scaled first: squares of any finite numbers stay finite
}

bool refuseParallel(const Node& node, const dvec3& direction, const Node& other, const dvec3& axis,
                    std::string_view what) {
    if (direction == dvec3(0.0) || axis == dvec3(0.0)) return false;  // has its problem already
    if (glm::length(glm::cross(direction, axis)) >= kParallel) return false;
    const dvec3 across = std::abs(axis.y) < 0.9 ? dvec3(0.0, 1.0, 0.0) : dvec3(1.0, 0.0, 0.0);
    node.refuse(fmt::format("{}; write another direction, such as {}", what, written(across)), {other});
    return true;
}

Rectangle rectangleOf(const Node& node) {
    const Edge u = edgeOf(node["u"]);
    const Edge v = perpendicularEdge(node["v"], {u});
    return {node["center"].vector(), u.vector, v.vector};
}

Disc discOf(const Node& node) {
    const Node inner = node["inner_radius"];
    const double radius = radiusOf(node);
    if (inner.number() >= radius) {
        inner.refuse(fmt::format("\"inner_radius\" is {}; write less than the radius, which is {}",
                                 inner.number(), radius),
                     {node["radius"]});
    }
    return {node["center"].vector(), unitDirection(node["normal"]), radius, inner.number()};
}

Sphere sphereOf(const Node& node) {
    return {node["center"].vector(), radiusOf(node)};
}

Shape shapeOf(const Node& object) {
    const std::string type = object["type"].text();
    if (type == "plane") return planeOf(object);
    if (type == "rectangle") return rectangleOf(object);
    if (type == "disc") return discOf(object);
    if (type == "sphere") return sphereOf(object);
    if (type == "box") return boxOf(object);
    if (type == "cylinder") return cylinderOf(object);
    if (type == "cone") return coneOf(object);
    assert(type == "triangle");
    return triangleOf(object);
}

}  // namespace fringe::scene
