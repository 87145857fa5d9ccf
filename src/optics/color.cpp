#include "optics/color.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <glm/matrix.hpp>

#include "optics/curve_file.hpp"
#include "optics/quadrature.hpp"
#include "optics/sources.hpp"
#include "spectra_tables.hpp"

namespace fringe::optics {
namespace {

using glm::dmat3;
using glm::dvec3;

constexpr std::size_t kWavelengths =
    static_cast<std::size_t>(kLongestVisible_nm - kShortestVisible_nm) + 1;  // 1 nm apart

const std::array<dvec3, kWavelengths>& observer() {
    static const std::array<dvec3, kWavelengths> table = [] {
        std::array<dvec3, kWavelengths> values;
        const std::vector<TableRow> rows = readTable(spectra::cie1931, 4);
        assert(rows.size() == kWavelengths && rows.front().values[0] == kShortestVisible_nm);
        for (std::size_t i = 0; i < kWavelengths; ++i)
            values[i] = {rows[i].values[1], rows[i].values[2], rows[i].values[3]};
        return values;
    }();
    return table;
}

// int spectrum reflectance cmf
dvec3 unscaledXyz(const Spectrum& spectrum, const Curve& reflectance) {
    dvec3 xyz(0.0);
    for (const Node& node : densityNodes(spectrum.density, reflectance))
        xyz += node.weight * colorMatching(node.wavelength_nm);
    for (const Line& line : spectrum.lines) {
        for (const Node& node : lineNodes(line, reflectance))
            xyz += node.weight * colorMatching(node.wavelength_nm);
    }
    return xyz;
}

// One visible watt of D65.
dvec3 unscaledWhite() {
    static const dvec3 white = unscaledXyz(*namedSpectrum("D65"), constantCurve(1.0));
    return white;
}

// What a colour of this chromaticity and Y = 1 is in XYZ.
dvec3 xyzOf(double x, double y) {
    return {x / y, 1.0, (1.0 - x - y) / y};
}

}  // namespace

dvec3 colorMatching(double wavelength_nm) {
    if (!(wavelength_nm >= kShortestVisible_nm && wavelength_nm <= kLongestVisible_nm)) return dvec3(0.0);
    const auto& table = observer();
    const double position = wavelength_nm - kShortestVisible_nm;
    const std::size_t below = std::min(static_cast<std::size_t>(position), kWavelengths - 2);
    const double t = position - static_cast<double>(below);
    return table[below] + t * (table[below + 1] - table[below]);
}

double luminousEfficacyOfD65() {
    return kMaximumLuminousEfficacy * unscaledWhite().y;
}

dvec3 xyzPerWatt(const Spectrum& spectrum, const Curve& reflectance) {
    return unscaledXyz(spectrum, reflectance) / unscaledWhite().y;
}

dmat3 xyzFromLinearSrgb() {
    const dmat3 primaries(xyzOf(0.64, 0.33), xyzOf(0.30, 0.60), xyzOf(0.15, 0.06));
    const dvec3 luminances = glm::inverse(primaries) * (unscaledWhite() / unscaledWhite().y);
    return dmat3(luminances.r * primaries[0], luminances.g * primaries[1], luminances.b * primaries[2]);
}

dmat3 linearSrgbFromXyz() {
    return glm::inverse(xyzFromLinearSrgb());
}

Curve reflectanceCurve(dvec3 linearSrgb) {
    if (linearSrgb.r == linearSrgb.g && linearSrgb.g == linearSrgb.b) return constantCurve(linearSrgb.r);
    static const std::vector<TableRow> primaries = readTable(spectra::primaries, 4);
    Curve curve;
    curve.reserve(primaries.size());
    for (const TableRow& row : primaries)
        curve.push_back({row.values[0], linearSrgb.r * row.values[1] + linearSrgb.g * row.values[2] +
                                            linearSrgb.b * row.values[3]});
    return curve;
}

}  // namespace fringe::optics
