#include "optics/spectrum.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "optics/quadrature.hpp"

namespace fringe::optics {
namespace {

// The wavelengths of knots, ascending, without repetitions.
std::vector<double> ascending(std::vector<double> wavelengths_nm) {
    std::sort(wavelengths_nm.begin(), wavelengths_nm.end());
    wavelengths_nm.erase(std::unique(wavelengths_nm.begin(), wavelengths_nm.end()), wavelengths_nm.end());
    return wavelengths_nm;
}

double sum(const std::vector<Node>& nodes) {
    double total = 0.0;
    for (const Node& node : nodes) total += node.weight;
    return total;
}

// The product of two curves within the visible range, to 1e-6 of its peak.
Curve product(const Curve& a, const Curve& b) {
    if (a.empty() || b.empty()) return {};
    const double from_nm = std::max({a.front().wavelength_nm, b.front().wavelength_nm, kShortestVisible_nm});
    const double to_nm = std::min({a.back().wavelength_nm, b.back().wavelength_nm, kLongestVisible_nm});
    if (!(from_nm < to_nm)) return {};

    std::vector<double> breaks{from_nm, to_nm};
    for (const Curve* curve : {&a, &b}) {
        for (const Knot& knot : *curve) {
            if (knot.wavelength_nm > from_nm && knot.wavelength_nm < to_nm)
                breaks.push_back(knot.wavelength_nm);
        }
    }
    breaks = ascending(std::move(breaks));
    double peak = 0.0;
    for (const double wavelength_nm : breaks)
        peak = std::max(peak, std::abs(valueAt(a, wavelength_nm) * valueAt(b, wavelength_nm)));

    // Between knots the product is a parabola, which n chords leave by up to (change of a)(change of b)/(4
    // n^2). Steps are as narrow as numbers allow and are not divided.
    constexpr double kTolerance = 1e-6;
    constexpr double kNarrowest_nm = 1e-6;
    Curve result;
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        const double left = breaks[i - 1];
        const double right = breaks[i];
        const double bend =
            std::abs((valueAt(a, right) - valueAt(a, left)) * (valueAt(b, right) - valueAt(b, left))) / 4.0;
        const double chords = right - left > kNarrowest_nm && peak > 0.0
                                  ? std::max(1.0, std::ceil(std::sqrt(bend / (kTolerance * peak))))
                                  : 1.0;
        for (double k = 0.0; k < chords; ++k) {
            const double wavelength_nm = left + (right - left) * (k / chords);
            result.push_back({wavelength_nm, valueAt(a, wavelength_nm) * valueAt(b, wavelength_nm)});
        }
    }
    result.push_back({to_nm, valueAt(a, to_nm) * valueAt(b, to_nm)});
    return result;
}

}  // namespace

double valueAt(const Curve& curve, double wavelength_nm) {
    if (curve.empty() || wavelength_nm < curve.front().wavelength_nm ||
        wavelength_nm > curve.back().wavelength_nm)
        return 0.0;
    const auto above =
        std::upper_bound(curve.begin(), curve.end(), wavelength_nm,
                         [](double value, const Knot& knot) { return value < knot.wavelength_nm; });
    if (above == curve.end()) return curve.back().value;
    const Knot& a = *(above - 1);
    const Knot& b = *above;
    const double t = (wavelength_nm - a.wavelength_nm) / (b.wavelength_nm - a.wavelength_nm);
    return a.value + t * (b.value - a.value);
}

Curve constantCurve(double value) {
    return {{kShortestVisible_nm, value}, {kLongestVisible_nm, value}};
}

bool isConstant(const Curve& curve) {
    if (curve.empty() || curve.front().wavelength_nm > kShortestVisible_nm ||
        curve.back().wavelength_nm < kLongestVisible_nm)
        return false;
    const double value = valueAt(curve, kShortestVisible_nm);
    return valueAt(curve, kLongestVisible_nm) == value &&
           std::all_of(curve.begin(), curve.end(), [&](const Knot& knot) {
               return knot.value == value || knot.wavelength_nm < kShortestVisible_nm ||
                      knot.wavelength_nm > kLongestVisible_nm;
           });
}

double visiblePower(const Spectrum& spectrum) {
    const Curve everything = constantCurve(1.0);
    double power = sum(densityNodes(spectrum.density, everything));
    for (const Line& line : spectrum.lines) power += sum(lineNodes(line, everything));
    return power;
}

Spectrum normalised(Spectrum spectrum) {
    const double power = visiblePower(spectrum);
    assert(power > 0.0);
    for (Knot& knot : spectrum.density) knot.value /= power;
    for (Line& line : spectrum.lines) line.power /= power;
    return spectrum;
}

Spectrum weightedSum(std::span<const WeightedSpectrum> parts) {
    double first_nm = std::numeric_limits<double>::infinity();
    double last_nm = -first_nm;
    for (const auto& [weight, spectrum] : parts) {
        if (spectrum.density.empty()) continue;
        first_nm = std::min(first_nm, spectrum.density.front().wavelength_nm);
        last_nm = std::max(last_nm, spectrum.density.back().wavelength_nm);
    }

    std::vector<double> wavelengths_nm;
    Spectrum total;
    for (const auto& [weight, spectrum] : parts) {
        for (const Knot& knot : spectrum.density) wavelengths_nm.push_back(knot.wavelength_nm);
        for (Line line : spectrum.lines) {
            line.power *= weight;
            total.lines.push_back(line);
        }
        if (spectrum.density.empty()) continue;
        const Knot& front = spectrum.density.front();
        const Knot& back = spectrum.density.back();
        if (front.value != 0.0 && front.wavelength_nm > first_nm)
            wavelengths_nm.push_back(std::nextafter(front.wavelength_nm, first_nm));
        if (back.value != 0.0 && back.wavelength_nm < last_nm)
            wavelengths_nm.push_back(std::nextafter(back.wavelength_nm, last_nm));
    }
    for (const double wavelength_nm : ascending(std::move(wavelengths_nm))) {
        double value = 0.0;
        for (const auto& [weight, spectrum] : parts)
            value += weight * valueAt(spectrum.density, wavelength_nm);
        total.density.push_back({wavelength_nm, value});
    }
    return total;
}

Spectrum filtered(const Spectrum& spectrum, const Curve& filter) {
    Spectrum passed{product(spectrum.density, filter), {}};
    for (Line line : spectrum.lines) {
        // The part of the line that is outside the visible range stays out of both sums.
        const double before = sum(lineNodes({line.wavelength, 1.0, line.width}, constantCurve(1.0)));
        if (before <= 0.0) continue;
        line.power *= sum(lineNodes({line.wavelength, 1.0, line.width}, filter)) / before;
        passed.lines.push_back(line);
    }
    return passed;
}

}  // namespace fringe::optics
