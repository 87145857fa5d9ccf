#include "scene/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace fringe::scene {
namespace {

using glm::dvec2;

// Sine of the angle between sides that lie on one line but for the rounding of their lengths.
constexpr double kStraight = 1e-12;

double cross(const dvec2& a, const dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

bool within(const dvec2& point, const dvec2& a, const dvec2& b) {
    return point.x >= std::min(a.x, b.x) && point.x <= std::max(a.x, b.x) && point.y >= std::min(a.y, b.y) &&
           point.y <= std::max(a.y, b.y);
}

// Whether the segments ab and cd have a point in common.
bool meet(const dvec2& a, const dvec2& b, const dvec2& c, const dvec2& d) {
    const double cSide = cross(b - a, c - a);
    const double dSide = cross(b - a, d - a);
    const double aSide = cross(d - c, a - c);
    const double bSide = cross(d - c, b - c);
    const auto opposite = [](double p, double q) { return (p > 0.0 && q < 0.0) || (p < 0.0 && q > 0.0); };
    if (opposite(cSide, dSide) && opposite(aSide, bSide)) return true;
    return (cSide == 0.0 && within(c, a, b)) || (dSide == 0.0 && within(d, a, b)) ||
           (aSide == 0.0 && within(a, c, d)) || (bSide == 0.0 && within(b, c, d));
}

}  // namespace

Polygon regularPolygon(std::uint32_t sides, double diameter, double rotation) {
    Polygon polygon;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = rotation + 2.0 * std::numbers::pi * i / sides;
        polygon.push_back(0.5 * diameter * dvec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

double signedArea(const Polygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    return 0.5 * twice;
}

dvec2 centroid(const Polygon& polygon) {
    dvec2 sum(0.0);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec2 a = polygon[i] - polygon[0];
        const dvec2 b = polygon[(i + 1) % polygon.size()] - polygon[0];
        sum += (a + b) * cross(a, b);
    }
    return polygon[0] + sum / (6.0 * signedArea(polygon));
}

std::optional<std::pair<std::size_t, std::size_t>> crossing(const Polygon& polygon) {
    const std::size_t count = polygon.size();
    const auto vertex = [&](std::size_t i) { return polygon[i % count]; };
    for (std::size_t i = 0; i < count; ++i) {
        const dvec2 side = vertex(i + 1) - vertex(i);
        const dvec2 next = vertex(i + 2) - vertex(i + 1);
        const bool straight =
            std::abs(cross(side, next)) <= kStraight * glm::length(side) * glm::length(next);
        if (straight && glm::dot(side, next) <= 0.0) return {{i, (i + 1) % count}};
        for (std::size_t j = i + 2; j < count; ++j) {
            if (i == 0 && j + 1 == count) continue;  // neighbours across the end
            if (meet(vertex(i), vertex(i + 1), vertex(j), vertex(j + 1))) return {{i, j}};
        }
    }
    return std::nullopt;
}

// Copies of one shape cannot lie inside each other, so their borders cross if they overlap.
bool overlaps(const Polygon& polygon, const dvec2& shift) {
    const std::size_t count = polygon.size();
    const auto vertex = [&](std::size_t i) { return (1.0 - kTouch) * polygon[i % count]; };
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
            if (meet(vertex(i), vertex(i + 1), vertex(j) + shift, vertex(j + 1) + shift)) return true;
        }
    }
    return false;
}

}  // namespace fringe::scene
