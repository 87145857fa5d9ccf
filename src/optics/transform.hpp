// The far field of an aperture: the Fourier transform of its transmission of amplitude.
#pragma once

#include <complex>
#include <glm/vec2.hpp>

#include "optics/aperture.hpp"

namespace fringe::optics {

// What passes of light of irradiance 1: the integral of the squared transmission over the plane, in m^2.
// Slits have no length: theirs is in m, per length along them.
double area(const Aperture& aperture);

// A(f), the integral of T(x) exp(-2 pi i f.x) over the plane, in m^2 (slits: in m, at f.y = 0). `f_per_m` is
// (alpha_out - alpha_in, beta_out - beta_in) / wavelength (M. Born, E. Wolf, "Principles of Optics", 7th ed.,
// 8.5). Closed forms, but for the mask: there the sum over all pixels, slow (see MaskSpectrum).
// Error below 1e-13 of A(0), plus 1e-15 |f.x| for the rounding of phases.
std::complex<double> transform(const Aperture& aperture, glm::dvec2 f_per_m);

// Integrals over an opening about its centroid, in m^2 and m^4.
struct Moments {
    double area;
    double xx;
    double xy;
    double yy;
};
Moments moments(const Cell& cell);

// Counter-clockwise, centred.
PolygonalAperture asPolygon(const RectangularAperture& rectangle);

}  // namespace fringe::optics
