#include "oracle/ways.hpp"

#include <cmath>
#include <numbers>

namespace fringe::oracle {

using Complex = std::complex<double>;

Ways::Ways(double shortestWavelength) : step_(shortestWavelength / 16.0) {}

void Ways::add(double length, double weight) {
    const auto bin = static_cast<std::int64_t>(std::llround(length / step_));
    if (moments_.empty()) first_ = bin;
    if (bin < first_) {
        moments_.insert(moments_.begin(), static_cast<std::size_t>(first_ - bin), Moments{});
        first_ = bin;
    }
    const auto at = static_cast<std::size_t>(bin - first_);
    if (at >= moments_.size()) moments_.resize(at + 1, Moments{});
    const double past = length / step_ - static_cast<double>(bin);
    for (double& moment : moments_[at]) {
        moment += weight;
        weight *= past;
    }
}

Complex Ways::wave(double wavelength) const {
    const double perStep = 2.0 * std::numbers::pi * step_ / wavelength;
    const Complex turn = std::polar(1.0, perStep);
    Complex wave = std::polar(1.0, perStep * static_cast<double>(first_));
    std::array<Complex, kMoments> sums{};
    for (const Moments& moments : moments_) {
        for (std::size_t k = 0; k < kMoments; ++k) sums[k] += moments[k] * wave;
        wave *= turn;
    }
    Complex sum = 0.0;
    Complex factor = 1.0;  // (i perStep)^k / k!
    for (std::size_t k = 0; k < kMoments; ++k) {
        sum += factor * sums[k];
        factor *= Complex(0.0, perStep / static_cast<double>(k + 1));
    }
    return sum;
}

}  // namespace fringe::oracle
