// The far field of an even strip.
#pragma once

#include <cmath>
#include <numbers>

namespace fringe::oracle {

// sin(pi x)/(pi x).
inline double sinc(double x) {
    const double y = std::numbers::pi * x;
    return std::abs(y) < 1e-8 ? 1.0 : std::sin(y) / y;
}

}  // namespace fringe::oracle
