#include "qualify/shape_measure.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace fringe::qualify {
namespace {

using glm::cross;
using glm::dot;
using glm::dvec3;
using glm::length;
using glm::normalize;
using oracle::Ray;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Where a point lies: `off` the surface, and how far from the surface's `rim`, negative beyond it. `off` is
// negative inside a solid, and within the infinite wall of an open cylinder or cone; it is a convex function
// of the point, and of a flat sheet the distance from its plane.
struct Place {
    double off;
    double rim;
};

Place placeAt(const scene::Plane& plane, const dvec3& point) {
    return {std::abs(dot(point - plane.point, normalize(plane.normal))), kInfinity};
}

Place placeAt(const scene::Rectangle& rectangle, const dvec3& point) {
    const dvec3 local = point - rectangle.center;
    const double u = length(rectangle.u), v = length(rectangle.v);
    return {std::abs(dot(local, normalize(cross(rectangle.u, rectangle.v)))),
            std::min(u - std::abs(dot(local, rectangle.u)) / u, v - std::abs(dot(local, rectangle.v)) / v)};
}

Place placeAt(const scene::Disc& disc, const dvec3& point) {
    const dvec3 local = point - disc.center, normal = normalize(disc.normal);
    const double off = dot(local, normal), radius = length(local - off * normal);
    const double fromHole = disc.innerRadius > 0.0 ? radius - disc.innerRadius : kInfinity;
    return {std::abs(off), std::min(disc.radius - radius, fromHole)};
}

Place placeAt(const scene::Triangle& triangle, const dvec3& point) {
    const auto& corner = triangle.vertices;
    const dvec3 normal = normalize(cross(corner[1] - corner[0], corner[2] - corner[0]));
    double rim = kInfinity;
    for (int i = 0; i < 3; ++i) {
        const dvec3 edge = normalize(corner[(i + 1) % 3] - corner[i]);
        rim = std::min(rim, dot(cross(edge, point - corner[i]), normal));
    }
    return {std::abs(dot(point - corner[0], normal)), rim};
}

Place placeAt(const scene::Sphere& sphere, const dvec3& point) {
    return {length(point - sphere.center) - sphere.radius, kInfinity};
}

Place placeAt(const scene::Box& box, const dvec3& point) {
    double off = -kInfinity;
    for (const dvec3& half : {box.u, box.v, box.w})
        off = std::max(off, std::abs(dot(point - box.center, half)) / length(half) - length(half));
    return {off, kInfinity};
}

// `wall`: off the infinite wall. Caps close a solid, else they are where the wall ends.
Place between(double wall, double z, double height, bool capped) {
    const double beyond = std::max(-z, z - height);
    return capped ? Place{std::max(wall, beyond), kInfinity} : Place{wall, -beyond};
}

Place placeAt(const scene::Cylinder& cylinder, const dvec3& point) {
    const double height = length(cylinder.top - cylinder.base);
    const dvec3 axis = (cylinder.top - cylinder.base) / height, local = point - cylinder.base;
    const double z = dot(local, axis);
    return between(length(local - z * axis) - cylinder.radius, z, height, cylinder.capped);
}

Place placeAt(const scene::Cone& cone, const dvec3& point) {
    const double height = length(cone.base - cone.apex);
    const dvec3 axis = (cone.base - cone.apex) / height, local = point - cone.apex;
    const double z = dot(local, axis), slope = cone.radius / height;
    const double wall = (length(local - z * axis) - slope * z) / std::sqrt(1.0 + slope * slope);
    return between(wall, z, height, cone.capped);
}

Place placeAt(const scene::Shape& shape, const dvec3& point) {
    return std::visit([&](const auto& s) { return placeAt(s, point); }, shape);
}

// The least of a convex function of the place along a ray from `start` to `end`: golden sections.
double leastAlong(const scene::Shape& shape, const Ray& ray, double start, double end) {
    constexpr double kGolden = 0.6180339887498949;
    const auto off = [&](double t) { return placeAt(shape, ray.at(t)).off; };
    double low = start, high = end;
    double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    double atA = off(a), atB = off(b);
    for (int i = 0; i < 80; ++i) {
        if (atA < atB) {
            high = b;
            b = a;
            atB = atA;
            a = high - kGolden * (high - low);
            atA = off(a);
        } else {
            low = a;
            a = b;
            atA = atB;
            b = low + kGolden * (high - low);
            atB = off(b);
        }
    }
    return std::min({atA, atB, off(start), off(end)});
}

// How far along the ray, either way, from where it meets a sheet to where it is beyond the rim; at most
// `most`.
double reach(const scene::Shape& shape, const Ray& ray, double meeting, double most) {
    double nearest = most;
    for (const double way : {-1.0, 1.0}) {
        double inside = 0.0, outside = nearest;
        if (placeAt(shape, ray.at(meeting + way * outside)).rim > 0.0) continue;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (inside + outside);
            (placeAt(shape, ray.at(meeting + way * middle)).rim > 0.0 ? inside : outside) = middle;
        }
        nearest = outside;
    }
    return nearest;
}

dvec3 halfEdge(const dvec3& dual) {
    return dual / dot(dual, dual);
}

}  // namespace

ShapeMeasure::ShapeMeasure(scene::Shape shape, const dvec3& origin, double size)
    : shape_(shape), origin_(origin), size_(size) {}

ShapeMeasure ShapeMeasure::ofPlane(const dvec3& point, const dvec3& normal) {
    return {scene::Plane{point, normal}, point, 0.0};
}

ShapeMeasure ShapeMeasure::ofRectangle(const dvec3& center, const dvec3& uDual, const dvec3& vDual) {
    const dvec3 u = halfEdge(uDual), v = halfEdge(vDual);
    return {scene::Rectangle{center, u, v}, center, std::max(length(u), length(v))};
}

ShapeMeasure ShapeMeasure::ofDisc(const dvec3& center, const dvec3& normal, double innerRadiusSquared,
                                  double radiusSquared) {
    const double radius = std::sqrt(radiusSquared);
    return {scene::Disc{center, normal, radius, std::sqrt(innerRadiusSquared)}, center, radius};
}

ShapeMeasure ShapeMeasure::ofTriangle(const dvec3& vertex, const dvec3& edge1, const dvec3& edge2) {
    return {scene::Triangle{{vertex, vertex + edge1, vertex + edge2}}, vertex,
            std::max(length(edge1), length(edge2))};
}

ShapeMeasure ShapeMeasure::ofSphere(const dvec3& center, double radius) {
    return {scene::Sphere{center, radius}, center, radius};
}

ShapeMeasure ShapeMeasure::ofBox(const dvec3& center, const dvec3& uDual, const dvec3& vDual,
                                 const dvec3& wDual) {
    const dvec3 u = halfEdge(uDual), v = halfEdge(vDual), w = halfEdge(wDual);
    return {scene::Box{center, u, v, w}, center, std::max({length(u), length(v), length(w)})};
}

ShapeMeasure ShapeMeasure::ofCylinder(const dvec3& base, const dvec3& axis, double height, double radius,
                                      bool capped) {
    return {scene::Cylinder{base, base + height * axis, radius, capped}, base, std::max(height, radius)};
}

ShapeMeasure ShapeMeasure::ofCone(const dvec3& apex, const dvec3& axis, double height, double slope,
                                  bool capped) {
    const double radius = slope * height;
    return {scene::Cone{apex + height * axis, apex, radius, capped}, apex, std::max(height, radius)};
}

double ShapeMeasure::distance(const Ray& ray) const {
    const auto hit = oracle::intersect(ray, shape_);
    return hit ? hit->distance : -1.0;
}

bool ShapeMeasure::isSolid() const {
    if (const auto* cylinder = std::get_if<scene::Cylinder>(&shape_)) return cylinder->capped;
    if (const auto* cone = std::get_if<scene::Cone>(&shape_)) return cone->capped;
    return std::holds_alternative<scene::Sphere>(shape_) || std::holds_alternative<scene::Box>(shape_);
}

double ShapeMeasure::missed(const Ray& ray, double got, double expected, double scale) const {
    const double end = got > 0.0 ? got : 2.0 * scale;
    const double first = placeAt(shape_, ray.origin).off;
    if (isSolid()) {
        // Until the hit the ray is wholly outside or, if it began there, wholly inside.
        const double deepest = std::max(-leastAlong(shape_, ray, 0.0, end), 0.0);
        const double highest = std::max({first, placeAt(shape_, ray.at(end)).off, 0.0});
        return std::min(deepest, highest);
    }
    if (expected <= 0.0 || (got > 0.0 && got < expected)) return 0.0;
    // A shift across a sheet moves the place where a slanted ray meets it much further, until beyond the rim.
    const double step = 1e-6 * scale;
    const double slope = std::abs(placeAt(shape_, ray.at(expected + step)).off) / step;
    const double least = std::min({placeAt(shape_, ray.at(expected)).rim, std::abs(first),
                                   slope * reach(shape_, ray, expected, 4.0 * size_ + scale)});
    if (std::holds_alternative<scene::Cylinder>(shape_) || std::holds_alternative<scene::Cone>(shape_)) {
        const double within = -leastAlong(shape_, ray, got > 0.0 ? expected : 0.0, end);
        return std::min(least, std::max(within, 0.0));
    }
    return got > 0.0 ? 0.0 : least;  // a flat sheet is met once
}

double ShapeMeasure::shift(const Ray& ray, double got, double expected) const {
    const double scale = std::max({length(ray.origin - origin_), got, expected, size_});
    double off = 0.0;
    if (got > 0.0) {
        const Place place = placeAt(shape_, ray.at(got));
        off = std::max(std::abs(place.off), -place.rim);
    }
    const bool agree = got > 0.0 ? std::abs(got - expected) <= 1e-7 * scale : expected <= 0.0;
    if (!agree) off = std::max(off, missed(ray, got, expected, scale));
    return off / scale;
}

}  // namespace fringe::qualify
