// Tables whose entries are coefficients of cubic B-splines, made from the transform of what they hold.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "optics/integrals.hpp"

namespace fringe::optics {

// What lags of 0, 1, ... count for in a table of `size` points: 1 / sinc^4(lag / size), as the cubic
// B-spline's transform divides, times the transform of a Gaussian over which the table is an average, of the
// standard deviation `width` in turns from a pixel to the next.
inline std::vector<float> lagWeights(std::uint32_t lags, std::uint32_t size, double width) {
    std::vector<float> weights(lags);
    for (std::uint32_t lag = 0; lag < lags; ++lag) {
        weights[lag] = static_cast<float>(std::pow(sinc(double(lag) / size), -4) *
                                          std::exp(-2.0 * std::pow(std::numbers::pi * width * lag, 2)));
    }
    return weights;
}

}  // namespace fringe::optics
