#include "optics/sources.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "optics/curve_file.hpp"
#include "spectra_tables.hpp"

namespace fringe::optics {
namespace {

enum class Kind { equalEnergy, illuminantA, density, lines };

struct Source {
    std::string_view name;
    Kind kind;
    std::string_view table;
};

constexpr std::array<Source, 12> kSources{{
    {"A", Kind::illuminantA, {}},
    {"D50", Kind::density, spectra::d50},
    {"D65", Kind::density, spectra::d65},
    {"E", Kind::equalEnergy, {}},
    {"F2", Kind::density, spectra::f2},
    {"F7", Kind::density, spectra::f7},
    {"F11", Kind::density, spectra::f11},
    {"LED-B3", Kind::density, spectra::ledB3},
    {"hydrogen", Kind::lines, spectra::hydrogen},
    {"mercury", Kind::lines, spectra::mercury},
    {"neon", Kind::lines, spectra::neon},
    {"sodium", Kind::lines, spectra::sodium},
}};

constexpr auto kNames = [] {
    std::array<std::string_view, kSources.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = kSources[i].name;
    return names;
}();

Spectrum tabulated(std::string_view table) {
    Spectrum spectrum;
    for (const TableRow& row : readTable(table, 2))
        spectrum.density.push_back({row.values[0], row.values[1]});
    return spectrum;
}

Spectrum lineList(std::string_view table) {
    Spectrum spectrum;
    for (const TableRow& row : readTable(table, 2))
        spectrum.lines.push_back({row.values[0] * units::nm, row.values[1], {}});
    return spectrum;
}

// Planck's law with the second radiation constant c2, at every whole nanometre: closer knots would change the
// density by less than 2e-4 of it at 2500 K. Everything is relative to the longest wavelength, so that
// nothing overflows for cold bodies.
Spectrum hotBody(double kelvin, double c2_nmK) {
    const double longest = c2_nmK / (kLongestVisible_nm * kelvin);
    Spectrum spectrum;
    for (double wavelength_nm = kShortestVisible_nm; wavelength_nm <= kLongestVisible_nm; ++wavelength_nm) {
        const double exponent = c2_nmK / (wavelength_nm * kelvin);
        spectrum.density.push_back({wavelength_nm, std::pow(kLongestVisible_nm / wavelength_nm, 5.0) *
                                                       std::exp(longest - exponent) * std::expm1(-longest) /
                                                       std::expm1(-exponent)});
    }
    return normalised(std::move(spectrum));
}

}  // namespace

std::optional<Spectrum> namedSpectrum(std::string_view name) {
    const auto source = std::find_if(kSources.begin(), kSources.end(),
                                     [&](const Source& candidate) { return candidate.name == name; });
    if (source == kSources.end()) return {};
    switch (source->kind) {
        case Kind::equalEnergy:
            return normalised({constantCurve(1.0), {}});
        case Kind::illuminantA:
            // CIE 15 defines it by c2 = 1.435e-2 m K and 2848 K, which is 2855.5 K on today's scale.
            return hotBody(2848.0, 1.435e7);
        case Kind::density:
            return normalised(tabulated(source->table));
        case Kind::lines:
            return normalised(lineList(source->table));
    }
    assert(false);
    return {};
}

std::span<const std::string_view> namedSpectra() {
    return kNames;
}

Spectrum planck(double kelvin) {
    assert(kelvin > 0.0);
    return hotBody(kelvin, 1.438776877e7);
}

Spectrum led(units::Length peak, units::Length fullWidth) {
    assert(fullWidth.si > 0.0);
    // Chords of a twentieth of the deviation leave a Gaussian by 3e-4 of its peak; 6 deviations from the peak
    // it is 2e-8 high.
    constexpr double kDeviations = 6.0;
    constexpr double kStepsPerDeviation = 20.0;
    const double peak_nm = peak / units::nm;
    const double deviation_nm = fullWidth / units::nm / (2.0 * std::sqrt(2.0 * std::numbers::ln2));
    const double from_nm = std::max(kShortestVisible_nm, peak_nm - kDeviations * deviation_nm);
    const double to_nm = std::min(kLongestVisible_nm, peak_nm + kDeviations * deviation_nm);
    assert(from_nm < to_nm);
    const double steps = std::ceil((to_nm - from_nm) / deviation_nm * kStepsPerDeviation);
    Spectrum spectrum;
    for (double i = 0.0; i <= steps; ++i) {
        const double wavelength_nm = from_nm + (to_nm - from_nm) * (i / steps);
        const double x = (wavelength_nm - peak_nm) / deviation_nm;
        spectrum.density.push_back({wavelength_nm, std::exp(-0.5 * x * x)});
    }
    return normalised(std::move(spectrum));
}

Spectrum laser(units::Length wavelength, units::Length linewidth) {
    return normalised({{}, {{wavelength, 1.0, linewidth}}});
}

}  // namespace fringe::optics
