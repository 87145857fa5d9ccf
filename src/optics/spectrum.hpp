// Spectra: what lamps send out and what surfaces reflect, over the visible range.
// Wavelengths are those in standard air, as in the CIE's tables and in laboratory practice (sodium: 589.0 and
// 589.6 nm); in vacuum they are longer by 0.028 %. A power in watts is always that of the visible range; what
// lies outside is neither seen nor simulated.
#pragma once

#include <span>
#include <vector>

#include "units/units.hpp"

namespace fringe::optics {

// The range of the colour-matching functions that is used (CIE 1931, 1 nm table).
inline constexpr double kShortestVisible_nm = 380.0;
inline constexpr double kLongestVisible_nm = 780.0;
inline constexpr units::Length kShortestVisible = kShortestVisible_nm * units::nm;
inline constexpr units::Length kLongestVisible = kLongestVisible_nm * units::nm;

struct Knot {
    double wavelength_nm;
    double value;

    bool operator==(const Knot&) const = default;
};

// Linear between its knots, which ascend strictly; 0 outside them.
using Curve = std::vector<Knot>;

// A narrow line, Gaussian in wavelength.
struct Line {
    units::Length wavelength;
    double power;         // relative to the other lines and to the area under the density
    units::Length width;  // full width at half maximum; 0 for a line without width

    bool operator==(const Line&) const = default;
};

// Spectral power: a density per nanometre and any number of lines. `normalised` spectra hold one watt of
// visible power.
struct Spectrum {
    Curve density;
    std::vector<Line> lines;

    bool operator==(const Spectrum&) const = default;
};

struct WeightedSpectrum {
    double weight;
    Spectrum spectrum;
};

// ---- curves --------------------------------------------------------------------------------------

// O(log knots).
double valueAt(const Curve& curve, double wavelength_nm);

// `value` all over the visible range.
Curve constantCurve(double value);

// Whether the curve has one and the same value, bit for bit, all over the visible range.
bool isConstant(const Curve& curve);

// ---- spectra -------------------------------------------------------------------------------------

// The power within the visible range: the exact area under the density and the part of each line that lies
// inside.
double visiblePower(const Spectrum& spectrum);

// The same spectrum with a visible power of 1. Precondition: it has visible power.
Spectrum normalised(Spectrum spectrum);

// The sum of weight * spectrum. Where one density ends above 0 within another, two knots next to each other
// hold the step.
Spectrum weightedSum(std::span<const WeightedSpectrum> parts);

// The light that passes a filter, or that a surface of this reflectance sends back, within the visible range.
// The density is within 1e-6 of its peak of the product of both curves. A line keeps its shape, and its power
// is exact.
Spectrum filtered(const Spectrum& spectrum, const Curve& filter);

}  // namespace fringe::optics
