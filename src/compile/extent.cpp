#include "compile/extent.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace fringe::compile {
namespace {

using glm::dot;
using glm::dvec3;

// A disc reaches r sin(angle between its axis and the direction) to either side.
Interval discInterval(dvec3 center, dvec3 axis, double radius, dvec3 along) {
    const double cosine = dot(axis, along);
    return around(dot(center, along), radius * std::sqrt(std::max(0.0, 1.0 - cosine * cosine)));
}

struct IntervalAlong {
    dvec3 along;  // unit

    Interval operator()(const scene::Plane& s) const {
        const bool parallel = glm::length(glm::cross(s.normal, along)) == 0.0;
        return around(dot(s.point, along), parallel ? 0.0 : kInfinity);
    }
    Interval operator()(const scene::Rectangle& s) const {
        return around(dot(s.center, along), std::abs(dot(s.u, along)) + std::abs(dot(s.v, along)));
    }
    Interval operator()(const scene::Disc& s) const {
        return discInterval(s.center, s.normal, s.radius, along);
    }
    Interval operator()(const scene::Sphere& s) const { return around(dot(s.center, along), s.radius); }
    Interval operator()(const scene::Box& s) const {
        return around(dot(s.center, along),
                      std::abs(dot(s.u, along)) + std::abs(dot(s.v, along)) + std::abs(dot(s.w, along)));
    }
    Interval operator()(const scene::Cylinder& s) const {
        const dvec3 axis = glm::normalize(s.top - s.base);
        return join(discInterval(s.base, axis, s.radius, along), discInterval(s.top, axis, s.radius, along));
    }
    Interval operator()(const scene::Cone& s) const {
        const dvec3 axis = glm::normalize(s.base - s.apex);
        return join(discInterval(s.base, axis, s.radius, along), around(dot(s.apex, along), 0.0));
    }
    Interval operator()(const scene::Triangle& s) const {
        Interval all = around(dot(s.vertices[0], along), 0.0);
        for (const dvec3& vertex : s.vertices) all = join(all, around(dot(vertex, along), 0.0));
        return all;
    }
};

}  // namespace

Interval extentAlong(const scene::Shape& shape, dvec3 along) {
    return std::visit(IntervalAlong{along}, shape);
}

Interval extentFrom(dvec3 origin, const scene::Shape& shape, dvec3 along) {
    const Interval all = extentAlong(shape, along);
    const double at = glm::dot(origin, along);
    return {all.low - at, all.high - at};
}

std::optional<FlatPlane> planeOf(const scene::Shape& shape) {
    if (const auto* s = std::get_if<scene::Plane>(&shape)) return FlatPlane{s->point, s->normal};
    if (const auto* s = std::get_if<scene::Rectangle>(&shape)) {
        return FlatPlane{s->center, glm::normalize(glm::cross(s->u, s->v))};
    }
    if (const auto* s = std::get_if<scene::Disc>(&shape)) return FlatPlane{s->center, s->normal};
    if (const auto* s = std::get_if<scene::Triangle>(&shape)) {
        return FlatPlane{s->vertices[0], glm::normalize(glm::cross(s->vertices[1] - s->vertices[0],
                                                                   s->vertices[2] - s->vertices[0]))};
    }
    return std::nullopt;
}

}  // namespace fringe::compile
