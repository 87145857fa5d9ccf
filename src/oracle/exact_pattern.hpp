// Far fields of apertures relative to their peaks, in double precision at given numbers: what the shaders'
// patterns are judged by.
#pragma once

#include <complex>
#include <glm/vec2.hpp>
#include <span>

namespace fringe::oracle {

// (sin(pi x)/(pi x))^2.
double slitPattern(double x);

// Turns past the nearest whole number, for `u` and `high` that are floats: 24 bits each, so that their
// product is exact. The rounding left is 1e-16 turns.
double turnsPast(double u, double high, double low);

// (sin(count pi t)/(count sin(pi t)))^2 at t turns past a whole number, |t| <= 1/2.
double arrayPattern(double turns, double count);

// (2 J1(pi x)/(pi x))^2 of a disc, and of one with a hole that is `inner` < 1 of it across.
double discPattern(double x, double inner = 0.0);

// |A|^2/|A(0)|^2 of a polygon around the origin, of which every corner can be seen from there, at `f` turns
// per unit of length. The triangles that the origin makes with each edge are added up, the integral over one
// being twice its area times the second divided difference of exp between its corners' phases (C. Hermite, A.
// Genocchi).
double polygonPattern(std::span<const glm::dvec2> vertices, const glm::dvec2& f);

}  // namespace fringe::oracle
