// A section of a beam that has travelled: the sum of the waves from a line across it, with the quadratic
// phases of their ways (J. Goodman, "Introduction to Fourier Optics", 4.2).
#pragma once

#include <complex>

namespace fringe::oracle {

// Integral of exp(i pi t^2 / 2) from 0 to w: Fresnel's C + i S. Absolute error below 1e-9.
std::complex<double> fresnelIntegral(double w);

// How far the waves have come, along one dimension of the beam: the way from y to a point is longer than the
// shortest one by curvature (y - foot)^2 / 2 - convergence y^2 / 2.
struct Travel {
    double foot;         // metres: from where the shortest way starts, without a lens
    double curvature;    // 1 / metres, > 0: of the ways to the point
    double convergence;  // 1 / metres: of the wavefront that a lens has made
};

// Integral of exp(2 pi i way / wavelength) over |y| < half. Metres.
std::complex<double> evenSection(double half, const Travel& travel, double wavelength);

// The same over all y, weighted with exp(-(y / radius)^2).
std::complex<double> gaussianSection(double radius, const Travel& travel, double wavelength);

}  // namespace fringe::oracle
