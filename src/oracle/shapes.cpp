#include "oracle/shapes.hpp"

#include <cmath>
#include <limits>

namespace fringe::oracle {
namespace {

using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;

using MaybeHit = std::optional<Hit>;

// Keeps the nearest of the hits offered, leaving out those behind the ray's origin.
class Nearest {
public:
    void offer(double distance, const dvec3& normal) {
        if (distance > 0.0 && (!hit_ || distance < hit_->distance)) hit_ = Hit{distance, normal};
    }
    const MaybeHit& hit() const { return hit_; }

private:
    MaybeHit hit_;
};

MaybeHit hitPlane(const Ray& ray, const dvec3& point, const dvec3& normal) {
    const double approach = dot(ray.direction, normal);
    if (approach == 0.0) return {};  // parallel
    const double distance = dot(point - ray.origin, normal) / approach;
    return distance > 0.0 ? MaybeHit(Hit{distance, normal}) : MaybeHit();
}

MaybeHit hit(const Ray& ray, const scene::Plane& plane) {
    return hitPlane(ray, plane.point, plane.normal);
}

MaybeHit hit(const Ray& ray, const scene::Rectangle& rectangle) {
    const auto& [center, u, v] = rectangle;
    const MaybeHit found = hitPlane(ray, center, normalize(cross(u, v)));
    if (!found) return {};
    const dvec3 inPlane = ray.at(found->distance) - center;
    const bool inside = std::abs(dot(inPlane, u)) <= dot(u, u) && std::abs(dot(inPlane, v)) <= dot(v, v);
    return inside ? found : MaybeHit();
}

MaybeHit hit(const Ray& ray, const scene::Disc& disc) {
    const MaybeHit found = hitPlane(ray, disc.center, disc.normal);
    if (!found) return {};
    const double fromCenter = length(ray.at(found->distance) - disc.center);
    return disc.innerRadius <= fromCenter && fromCenter <= disc.radius ? found : MaybeHit();
}

MaybeHit hit(const Ray& ray, const scene::Triangle& triangle) {
    const auto& corner = triangle.vertices;
    const dvec3 normal = normalize(cross(corner[1] - corner[0], corner[2] - corner[0]));
    const MaybeHit found = hitPlane(ray, corner[0], normal);
    if (!found) return {};
    const dvec3 point = ray.at(found->distance);
    for (int i = 0; i < 3; ++i) {
        const dvec3 edge = corner[(i + 1) % 3] - corner[i];
        if (dot(cross(edge, point - corner[i]), normal) < 0.0) return {};  // to the right of this edge
    }
    return found;
}

// Half the chord comes from the distance at which the ray passes the centre: no difference of large squares.
MaybeHit hit(const Ray& ray, const scene::Sphere& sphere) {
    const dvec3 toCenter = sphere.center - ray.origin;
    const double closest = dot(toCenter, ray.direction);
    const dvec3 miss = toCenter - closest * ray.direction;
    const double squaredHalfChord = sphere.radius * sphere.radius - dot(miss, miss);
    if (squaredHalfChord < 0.0) return {};
    Nearest nearest;
    for (const double side : {-1.0, 1.0}) {
        const double distance = closest + side * std::sqrt(squaredHalfChord);
        nearest.offer(distance, (ray.at(distance) - sphere.center) / sphere.radius);
    }
    return nearest.hit();
}

// The part of the ray between each pair of opposite faces; what all three share is inside.
MaybeHit hit(const Ray& ray, const scene::Box& box) {
    double entry = -std::numeric_limits<double>::infinity();
    double exit = std::numeric_limits<double>::infinity();
    dvec3 entryNormal(0.0);
    dvec3 exitNormal(0.0);
    for (const dvec3& halfEdge : {box.u, box.v, box.w}) {
        const double half = length(halfEdge);
        const dvec3 axis = halfEdge / half;
        const double speed = dot(ray.direction, axis);
        const double start = dot(ray.origin - box.center, axis);
        if (speed == 0.0) {
            if (std::abs(start) > half) return {};
            continue;
        }
        const double ahead = speed > 0.0 ? 1.0 : -1.0;
        const double in = (-ahead * half - start) / speed;
        const double out = (ahead * half - start) / speed;
        if (in > entry) {
            entry = in;
            entryNormal = -ahead * axis;
        }
        if (out < exit) {
            exit = out;
            exitNormal = ahead * axis;
        }
    }
    if (entry > exit) return {};
    Nearest nearest;
    nearest.offer(entry, entryNormal);
    nearest.offer(exit, exitNormal);
    return nearest.hit();
}

void offerCap(Nearest& nearest, const Ray& ray, const dvec3& center, const dvec3& outward, double radius) {
    if (const MaybeHit cap = hit(ray, scene::Disc{center, outward, radius, 0.0}))
        nearest.offer(cap->distance, outward);
}

// Seen along the axis the wall is a circle, which the ray crosses as it crosses a sphere.
MaybeHit hit(const Ray& ray, const scene::Cylinder& cylinder) {
    const double height = length(cylinder.top - cylinder.base);
    const dvec3 axis = (cylinder.top - cylinder.base) / height;
    const auto acrossAxis = [&](const dvec3& v) { return v - dot(v, axis) * axis; };

    Nearest nearest;
    const dvec3 across = acrossAxis(ray.direction);
    const dvec3 start = acrossAxis(ray.origin - cylinder.base);
    const double speed = length(across);
    if (speed > 0.0) {
        const double closest = -dot(start, across) / (speed * speed);
        const dvec3 miss = start + closest * across;
        const double squaredHalfChord = cylinder.radius * cylinder.radius - dot(miss, miss);
        for (const double side : {-1.0, 1.0}) {
            if (squaredHalfChord < 0.0) break;
            const double distance = closest + side * std::sqrt(squaredHalfChord) / speed;
            const dvec3 fromBase = ray.at(distance) - cylinder.base;
            const double along = dot(fromBase, axis);
            if (0.0 <= along && along <= height) nearest.offer(distance, normalize(acrossAxis(fromBase)));
        }
    }
    if (cylinder.capped) {
        offerCap(nearest, ray, cylinder.base, -axis, cylinder.radius);
        offerCap(nearest, ray, cylinder.top, axis, cylinder.radius);
    }
    return nearest.hit();
}

// With w a point relative to the apex, wAxis its part along the axis (towards the base) and wAcross the rest,
// the wall is |wAcross|^2 = (slope wAxis)^2, a quadratic a t^2 + 2 b t + c = 0 along the ray.
MaybeHit hit(const Ray& ray, const scene::Cone& cone) {
    const double height = length(cone.base - cone.apex);
    const dvec3 axis = (cone.base - cone.apex) / height;
    const double squaredSlope = (cone.radius / height) * (cone.radius / height);
    // The quadratic form whose zeros are the wall, and half its gradient, which points outwards.
    const auto gradient = [&](const dvec3& w) { return w - (1.0 + squaredSlope) * dot(w, axis) * axis; };

    const dvec3 start = ray.origin - cone.apex;
    const double a = dot(ray.direction, gradient(ray.direction));
    const double b = dot(ray.direction, gradient(start));
    const double c = dot(start, gradient(start));
    const double discriminant = b * b - a * c;

    Nearest nearest;
    if (discriminant >= 0.0) {
        // The root of larger size first; the other from the product of the roots, which does not cancel. A
        // zero divisor makes an infinite or NaN root, which the test of `along` refuses.
        const double q = -(b + std::copysign(std::sqrt(discriminant), b));
        for (const double distance : {q / a, c / q}) {
            const dvec3 w = ray.at(distance) - cone.apex;
            const double along = dot(w, axis);
            if (0.0 < along && along <= height) nearest.offer(distance, normalize(gradient(w)));
        }
    }
    if (cone.capped) offerCap(nearest, ray, cone.base, axis, cone.radius);
    return nearest.hit();
}

}  // namespace

std::optional<Hit> intersect(const Ray& ray, const scene::Shape& shape) {
    return std::visit([&ray](const auto& s) { return hit(ray, s); }, shape);
}

}  // namespace fringe::oracle
