// Colour: from spectra to CIE XYZ and linear sRGB, and from RGB reflectances to spectra.
// The film's scale: light of illuminant D65 with a radiance of 1 W/(m^2 sr) has Y = 1, and is R = G = B = 1.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "optics/spectrum.hpp"

namespace fringe::optics {

// The colour-matching functions of the CIE 1931 standard observer (2 degrees, 1 nm table), linear between
// whole nanometres; 0 outside the visible range. O(1).
glm::dvec3 colorMatching(double wavelength_nm);

// Lumens per watt where y is 1, with the y function of 1931 (CIE 18.2).
inline constexpr double kMaximumLuminousEfficacy = 683.002;

// Lumens per visible watt of D65. A film value Y is a luminance of Y times this in cd/m^2.
double luminousEfficacyOfD65();

// XYZ in the film's scale of 1 W/(m^2 sr) of this spectrum (as far as it is normalised) from a surface of
// this reflectance:  k int spectrum reflectance cmf.  Exact for densities; to 1e-9 for lines.
glm::dvec3 xyzPerWatt(const Spectrum& spectrum, const Curve& reflectance);

// The primaries of sRGB (IEC 61966-2-1) and, as its white, D65 of our own tables: so D65 is R = G = B
// exactly.
glm::dmat3 xyzFromLinearSrgb();
glm::dmat3 linearSrgbFromXyz();

// A smooth reflectance that has this linear sRGB colour under D65: r R + g G + b B with three curves that are
// 0 or more and have the sum 1 (Mallett and Yuksel, "Spectral Primary Decomposition for Rendering with sRGB
// Reflectance", EGSR 2019; the curves are ours, docs/spectral_primaries.py). Linear in the colour, nowhere
// outside the range of its three values, and constant for greys.
Curve reflectanceCurve(glm::dvec3 linearSrgb);

}  // namespace fringe::optics
