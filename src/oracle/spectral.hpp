// Spectra as sums over wavelengths, and what the film makes of each wavelength: CIE XYZ, where a surface that
// sends out 1 W/(m^2 sr) of D65 has Y = 1.
#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <vector>

#include "optics/spectrum.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

using Xyz = glm::dvec3;
using scene::Rgb;

inline constexpr double kFirst_nm = 380.0;
inline constexpr double kLast_nm = 780.0;

// One wavelength and the watts it stands for.
struct SpectralSample {
    double wavelength_nm;
    double power;
};

// Linear between the knots, 0 outside them.
double curveAt(const optics::Curve& curve, double wavelength_nm);

// The spectrum as a sum: its density by the trapezoidal rule in `steps` steps over the visible range, a line
// without width as one sample, another as `lineSteps` of them over four standard deviations to either side.
// What is not visible is left out.
std::vector<SpectralSample> sampled(const optics::Spectrum& spectrum, std::size_t steps = 400,
                                    std::size_t lineSteps = 64);

// What the film holds for 1 W/(m^2 sr) at a wavelength.
using Response = Xyz (*)(double wavelength_nm);

// Of a film in colour.
Xyz filmResponse(double wavelength_nm);

// Of a film of radiance: (0, 1, 0) at every wavelength.
Xyz radiantResponse(double wavelength_nm);

// One visible watt of CIE D65.
const optics::Spectrum& d65();

// XYZ of the primaries of IEC 61966-2-1, by columns: (1, 1, 1) is what the film makes of D65.
const glm::dmat3& xyzFromRgb();

}  // namespace fringe::oracle
