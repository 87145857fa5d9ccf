#include "oracle/spectral.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "illuminant_tables.hpp"
#include "optics/color.hpp"

namespace fringe::oracle {
namespace {

using units::nm;

double powerOf(const optics::Spectrum& spectrum) {
    double power = 0.0;
    for (const SpectralSample& sample : sampled(spectrum)) power += sample.power;
    return power;
}

// The "wavelength_nm,value" lines of a table; comments and column names do not start with a number.
optics::Curve parsed(std::string_view table) {
    optics::Curve curve;
    std::istringstream text{std::string(table)};
    for (std::string line; std::getline(text, line);) {
        std::istringstream fields(line);
        optics::Knot knot{};
        char comma = 0;
        if (fields >> knot.wavelength_nm >> comma >> knot.value) curve.push_back(knot);
    }
    return curve;
}

void addLine(std::vector<SpectralSample>& samples, const optics::Line& line, std::size_t lineSteps) {
    const double middle_nm = line.wavelength / nm;
    const double deviation_nm = line.width / nm / (2.0 * std::sqrt(2.0 * std::numbers::ln2));
    const auto add = [&](double wavelength_nm, double power) {
        if (kFirst_nm <= wavelength_nm && wavelength_nm <= kLast_nm)
            samples.push_back({wavelength_nm, power});
    };
    if (deviation_nm == 0.0) {
        add(middle_nm, line.power);
        return;
    }
    // The sum of evenly spaced values of a Gaussian is its integral to better than the tails left out, 6e-5.
    constexpr double kReach = 4.0;
    const double step = 2.0 * kReach / static_cast<double>(lineSteps);
    const double peak = step / std::sqrt(2.0 * std::numbers::pi);
    for (std::size_t i = 0; i < lineSteps; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * step - kReach;
        add(middle_nm + x * deviation_nm, line.power * peak * std::exp(-0.5 * x * x));
    }
}

// The inverse of the luminous power of D65, in the unit of its Y.
double perLuminousPower() {
    double y = 0.0;
    for (const SpectralSample& sample : sampled(d65()))
        y += sample.power * optics::colorMatching(sample.wavelength_nm).y;
    return 1.0 / y;
}

}  // namespace

double curveAt(const optics::Curve& curve, double wavelength_nm) {
    const auto above = std::lower_bound(
        curve.begin(), curve.end(), wavelength_nm,
        [](const optics::Knot& knot, double wanted_nm) { return knot.wavelength_nm < wanted_nm; });
    if (above == curve.end()) return 0.0;
    if (above->wavelength_nm == wavelength_nm) return above->value;
    if (above == curve.begin()) return 0.0;
    const optics::Knot& below = *(above - 1);
    const double share = (wavelength_nm - below.wavelength_nm) / (above->wavelength_nm - below.wavelength_nm);
    return below.value + share * (above->value - below.value);
}

std::vector<SpectralSample> sampled(const optics::Spectrum& spectrum, std::size_t steps,
                                    std::size_t lineSteps) {
    std::vector<SpectralSample> samples;
    if (!spectrum.density.empty()) {
        const double step_nm = (kLast_nm - kFirst_nm) / static_cast<double>(steps);
        for (std::size_t i = 0; i <= steps; ++i) {
            const double wavelength_nm = kFirst_nm + step_nm * static_cast<double>(i);
            const double weight = i == 0 || i == steps ? 0.5 : 1.0;
            samples.push_back({wavelength_nm, weight * step_nm * curveAt(spectrum.density, wavelength_nm)});
        }
    }
    for (const optics::Line& line : spectrum.lines) addLine(samples, line, lineSteps);
    return samples;
}

Xyz filmResponse(double wavelength_nm) {
    static const double scale = perLuminousPower();
    return scale * optics::colorMatching(wavelength_nm);
}

Xyz radiantResponse(double /*wavelength_nm*/) {
    return {0.0, 1.0, 0.0};
}

const optics::Spectrum& d65() {
    static const optics::Spectrum spectrum = [] {
        optics::Spectrum made{parsed(kD65Table), {}};
        const double power = powerOf(made);
        for (optics::Knot& knot : made.density) knot.value /= power;
        return made;
    }();
    return spectrum;
}

const glm::dmat3& xyzFromRgb() {
    static const glm::dmat3 matrix = [] {
        const auto primary = [](double x, double y) { return Xyz(x / y, 1.0, (1.0 - x - y) / y); };
        const glm::dmat3 primaries(primary(0.64, 0.33), primary(0.30, 0.60), primary(0.15, 0.06));
        Xyz white(0.0);
        for (const SpectralSample& sample : sampled(d65()))
            white += sample.power * filmResponse(sample.wavelength_nm);
        const glm::dvec3 luminances = glm::inverse(primaries) * white;
        return glm::dmat3(luminances.r * primaries[0], luminances.g * primaries[1],
                          luminances.b * primaries[2]);
    }();
    return matrix;
}

}  // namespace fringe::oracle
