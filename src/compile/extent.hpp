// Where a shape lies in the scene: the intervals that it covers, and the plane of a flat one.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "scene/scene.hpp"

namespace fringe::compile {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// In metres along a direction. Empty if low > high.
struct Interval {
    double low, high;
};

inline Interval around(double middle, double extent) {
    return {middle - extent, middle + extent};
}
inline Interval join(Interval a, Interval b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

// How far from 0 an interval's points lie, at least and at most.
inline double nearest(Interval interval) {
    return std::max({interval.low, -interval.high, 0.0});
}
inline double farthest(Interval interval) {
    return std::max(std::abs(interval.low), std::abs(interval.high));
}

// What a shape covers along the unit vector `along`, exact.
Interval extentAlong(const scene::Shape& shape, glm::dvec3 along);

// The same counted from a point.
Interval extentFrom(glm::dvec3 origin, const scene::Shape& shape, glm::dvec3 along);

// Of a flat shape; `normal` is a unit vector.
struct FlatPlane {
    glm::dvec3 point, normal;
};
std::optional<FlatPlane> planeOf(const scene::Shape& shape);

}  // namespace fringe::compile
