#include "oracle/slit_color.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oracle/exact_pattern.hpp"
#include "oracle/quadrature.hpp"

namespace fringe::oracle {
namespace {

constexpr double kWeightsPerNm = 20.0;  // the colour-matching functions are linear between nanometres

}  // namespace

SlitColor::SlitColor(SlitLight light) : light_(std::move(light)) {
    const auto color = [this](double wavelength_nm) {
        return filmResponse(wavelength_nm) / light_.propagatingShare(wavelength_nm);
    };
    if (!light_.spectrum.density.empty()) {
        const auto last = static_cast<int>((kLast_nm - kFirst_nm) * kWeightsPerNm);
        for (int i = 0; i <= last; ++i) {
            const double wavelength_nm = kFirst_nm + i / kWeightsPerNm;
            weights_.push_back(curveAt(light_.spectrum.density, wavelength_nm) * color(wavelength_nm));
        }
    }
    for (const SpectralSample& sample : sampled({{}, light_.spectrum.lines}))
        lines_.push_back({1e-3 * sample.wavelength_nm, sample.power * color(sample.wavelength_nm)});
}

Xyz SlitColor::weight(double wavelength_nm) const {
    const double place = (wavelength_nm - kFirst_nm) * kWeightsPerNm;
    const auto i = std::min(static_cast<std::size_t>(std::max(place, 0.0)), weights_.size() - 2);
    const double next = place - static_cast<double>(i);
    return (1.0 - next) * weights_[i] + next * weights_[i + 1];
}

double SlitColor::density(double u, double wavelength_um) const {
    const double turns = light_.period_um * u / wavelength_um;
    double array = arrayPattern(turns - std::nearbyint(turns), light_.count);
    if (std::abs(u) < light_.undeviatedUpTo) array -= slitPattern(light_.count * turns);
    return light_.count * light_.width_um / wavelength_um * slitPattern(light_.width_um * u / wavelength_um) *
           array;
}

Xyz SlitColor::at(double u) const {
    Xyz sum(0.0);
    for (const Line& line : lines_) sum += density(u, line.wavelength_um) * line.color;
    if (weights_.empty()) return sum;
    // In steps of the wavenumber: there the array factor is a sum of waves, the finest of count - 1 turns to
    // an order, and even steps, five to four of its turns, integrate it exactly beside a smooth spectrum.
    const double first = 1e3 / kLast_nm, range = 1e3 / kFirst_nm - first;
    const double waves = light_.count * light_.period_um * std::abs(u) * range;
    const double steps = std::max(1600.0, std::ceil(1.25 * waves));
    for (double i = 0.5; i < steps; i += 1.0) {
        const double wavelength_um = 1.0 / (first + range * i / steps);
        const double nanometres = 1e3 * wavelength_um * wavelength_um * range / steps;
        sum += nanometres * density(u, wavelength_um) * weight(1e3 * wavelength_um);
    }
    return sum;
}

// The spectrum has light where it begins and ends. There an order begins and ends within the width that the
// slits give it, and one rule across would miss that: pieces from a zero of the order's own pattern to
// others.
std::vector<double> SlitColor::pieces(double from, double to) const {
    std::vector<double> ends{from, to};
    if (weights_.empty()) return ends;
    for (const double edge_um : {1e-3 * kFirst_nm, 1e-3 * kLast_nm}) {
        const double perOrder = edge_um / light_.period_um, zero = perOrder / light_.count;
        if (zero > to - from) continue;  // as wide as the window: no edge
        for (double order = std::ceil(from / perOrder - 0.5); order <= to / perOrder + 0.5; order += 1.0) {
            if (order == 0.0) continue;
            for (const double zeros : {-16.0, -4.0, -1.0, 0.0, 1.0, 4.0, 16.0}) {
                const double end = order * perOrder + zeros * zero;
                if (end > from && end < to) ends.push_back(end);
            }
        }
    }
    std::sort(ends.begin(), ends.end());
    return ends;
}

// Fringes of the shortest wave.
double SlitColor::finestIn(double width) const {
    return width * light_.count * light_.period_um / (1e-3 * kFirst_nm);
}

// Features of the spectrum, some 30 nm wide and in the first order, or fringes of a line.
double SlitColor::featuresIn(double width) const {
    return std::max(width * light_.period_um / 0.03, lines_.empty() ? 0.0 : finestIn(width));
}

// What lies far within a feature is straight, its mean its middle to 2e-5, unless the slits are so many that
// the spectrum's knots show.
bool SlitColor::isNarrow(double width) const {
    return featuresIn(width) < 0.02 && finestIn(width) < 0.1;
}

Xyz SlitColor::mean(double u, double width) const {
    if (isNarrow(width)) return at(u);
    const double features = featuresIn(width);
    const std::vector<double> ends = pieces(u - 0.5 * width, u + 0.5 * width);
    Xyz sum(0.0);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double share = (ends[i + 1] - ends[i]) / width;
        forNodes(ends[i], ends[i + 1], static_cast<std::size_t>(std::ceil(features * share)),
                 [&](double at_, double weight) { sum += weight * at(at_); });
    }
    return sum / width;
}

}  // namespace fringe::oracle
