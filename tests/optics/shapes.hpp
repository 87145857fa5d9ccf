// Openings that several tests use.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

#include "optics/aperture.hpp"

namespace fringe::optics {

// Vertices on a circle, the first on +x.
inline PolygonalAperture regularPolygon(int vertices, double circumradius) {
    PolygonalAperture polygon;
    for (int i = 0; i < vertices; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / vertices;
        polygon.vertices.emplace_back(circumradius * std::cos(angle), circumradius * std::sin(angle));
    }
    return polygon;
}

// An L of 4 x 4 um with bars of 1 um, its inner corner not convex; its centroid at 0.
inline PolygonalAperture ell() {
    constexpr double kCentroid_um = (4.0 * 0.5 + 3.0 * 2.5) / 7.0;  // of two bars, 4 and 3 um^2
    PolygonalAperture polygon{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}};
    for (glm::dvec2& vertex : polygon.vertices) vertex = 1e-6 * (vertex - glm::dvec2(kCentroid_um));
    return polygon;
}

}  // namespace fringe::optics
