// Rays, and the smallest distance that counts as one.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace fringe::oracle {

using glm::dvec3;

struct Ray {
    dvec3 origin;
    dvec3 direction;  // unit

    dvec3 at(double distance) const { return origin + distance * direction; }
};

// Metres within which two points near `point` count as the same. A billionth of the coordinates, or a
// nanometre in scenes smaller than a metre: a million times the rounding of a double, so hit points are
// surely on one side of it, and below the size of anything a scene can resolve.
inline double clearance(const dvec3& point) {
    return 1e-9 * std::max({1.0, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
}

// Where something that goes from `point`, on a surface with normal `normal`, towards `direction` (any length)
// starts: lifted off the surface on the side it goes to, so that rounding cannot make it meet the same
// surface again.
inline dvec3 liftOff(const dvec3& point, const dvec3& normal, const dvec3& direction) {
    const double side = glm::dot(direction, normal) < 0.0 ? -1.0 : 1.0;
    return point + side * clearance(point) * normal;
}

}  // namespace fringe::oracle
