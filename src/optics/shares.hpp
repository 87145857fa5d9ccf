// propagatingShare() by kind of aperture, for energy.cpp.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "optics/aperture.hpp"

namespace fringe::optics {

// Light that comes in: its wavelength in metres and its direction cosines.
struct Incidence {
    double wavelength;
    glm::dvec2 direction;
};

// How far, in direction cosines, the propagating directions reach from the undeviated one towards the unit
// vector (x, y).
inline double reach(const Incidence& in, glm::dvec2 towards) {
    const double along = glm::dot(in.direction, towards);
    return std::sqrt(1.0 - glm::dot(in.direction, in.direction) + along * along) - along;
}

double shareOf(const Slits& slits, const Incidence& in);
double shareOf(const CircularAperture& circle, const Incidence& in);
double shareOf(const RectangularAperture& rectangle, const Incidence& in);
double shareOf(const PolygonalAperture& polygon, const Incidence& in);
double shareOf(const LatticeAperture& lattice, const Incidence& in);
double shareOf(const MaskAperture& mask, const Incidence& in);

// Above this many wavelengths across, quadrature over all directions takes longer than a frame.
inline constexpr double kLargestExtent = 60.0;

// By quadrature over the propagating directions: 1e-8, in time that grows as the square of `extent`, the
// aperture's largest diameter in metres.
double shareByQuadrature(const Aperture& aperture, double extent, const Incidence& in);

// What the other cells of a lattice add to the share of one, for cells and distances of many wavelengths;
// `extent` is a cell's largest diameter in metres.
double shareOfNeighbours(const LatticeAperture& lattice, double extent, const Incidence& in);

}  // namespace fringe::optics
