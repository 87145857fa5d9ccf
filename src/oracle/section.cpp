#include "oracle/section.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "oracle/quadrature.hpp"

namespace fringe::oracle {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

// Fresnel's integral and its derivative at evenly spaced places, summed up by Gauss's rule.
class FresnelTable {
public:
    static constexpr double kEnd = 8.0;

    FresnelTable() {
        Complex sum = 0.0;
        for (std::size_t i = 0; i <= kSteps; ++i) {
            const double w = static_cast<double>(i) * kStep;
            values_.push_back(sum);
            slopes_.push_back(std::polar(1.0, 0.5 * pi * w * w));
            forNodes(w, w + kStep, 1,
                     [&](double t, double weight) { sum += weight * std::polar(1.0, 0.5 * pi * t * t); });
        }
    }

    // Hermite's cubic: its error is step^4 / 384 times the fourth derivative, (pi w)^3 < 2e4.
    Complex at(double w) const {
        const double place = w / kStep;
        const auto i = static_cast<std::size_t>(place);
        const double t = place - static_cast<double>(i);
        const double s = 1.0 - t;
        return s * s * (1.0 + 2.0 * t) * values_[i] + t * t * (1.0 + 2.0 * s) * values_[i + 1] +
               kStep * s * t * (s * slopes_[i] - t * slopes_[i + 1]);
    }

private:
    static constexpr std::size_t kSteps = 8193;
    static constexpr double kStep = kEnd / 8192.0;
    std::vector<Complex> values_, slopes_;
};

}  // namespace

Complex fresnelIntegral(double w) {
    static const FresnelTable table;
    const double size = std::abs(w);
    Complex value;
    if (size <= FresnelTable::kEnd) {
        value = table.at(size);
    } else {
        // Integration by parts of the rest, five times; the next would add 945 / (pi^6 w^11) < 2e-10.
        const Complex perStep(0.0, -1.0 / (pi * size * size));
        const Complex series =
            1.0 + perStep * (1.0 + 3.0 * perStep * (1.0 + 5.0 * perStep * (1.0 + 7.0 * perStep)));
        const Complex edge = std::polar(1.0, 0.5 * pi * size * size) / Complex(0.0, pi * size);
        value = Complex(0.5, 0.5) + edge * series;
    }
    return w < 0.0 ? -value : value;
}

Complex evenSection(double half, const Travel& travel, double wavelength) {
    const double foot = travel.foot;
    const double curvature = travel.curvature;
    const double convergence = travel.convergence;
    const double left = curvature - convergence;
    // Near the focus no quadratic phase is left to speak of, and the integral is as good as Fourier's.
    if (std::abs(left) < 1e-3 * curvature) {
        const auto way = [&](double y) {
            return 0.5 * curvature * (y - foot) * (y - foot) - 0.5 * convergence * y * y;
        };
        const double steepest = curvature * std::abs(foot) + std::abs(left) * half;
        const auto turns = static_cast<std::size_t>(2.0 * half * steepest / wavelength);
        Complex sum = 0.0;
        forNodes(-half, half, turns + 1, [&](double y, double weight) {
            sum += weight * std::polar(1.0, 2.0 * pi * way(y) / wavelength);
        });
        return sum;
    }
    // The square completed: left (y - middle)^2 / 2 and a constant way.
    const double middle = curvature * foot / left;
    const double constant = -0.5 * curvature * convergence * foot * foot / left;
    const double scale = std::sqrt(2.0 * std::abs(left) / wavelength);
    Complex value = fresnelIntegral(scale * (half - middle)) - fresnelIntegral(scale * (-half - middle));
    if (left < 0.0) value = std::conj(value);
    return value / scale * std::polar(1.0, 2.0 * pi * constant / wavelength);
}

// The integral of exp(-p y^2 + q y - r) is sqrt(pi / p) exp(q^2 / (4 p) - r), for complex numbers too.
Complex gaussianSection(double radius, const Travel& travel, double wavelength) {
    const auto& [foot, curvature, convergence] = travel;
    const Complex turn(0.0, pi / wavelength);
    const Complex p = 1.0 / (radius * radius) - turn * (curvature - convergence);
    const Complex q = -2.0 * turn * curvature * foot;
    const Complex r = -turn * curvature * foot * foot;
    return std::sqrt(pi / p) * std::exp(q * q / (4.0 * p) - r);
}

}  // namespace fringe::oracle
