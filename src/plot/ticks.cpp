#include "plot/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fringe::plot {

std::string Ticks::label(double value) const {
    constexpr int kMostDecimals = 5;
    constexpr double kLargest = 1e6;
    if (decimals > kMostDecimals || std::abs(values.empty() ? 0.0 : values.back()) >= kLargest)
        return fmt::format("{:g}", value);
    return fmt::format("{:.{}f}", value, decimals);
}

Ticks ticksBetween(double first, double last, int most) {
    assert(first < last && most > 0);
    const double least = (last - first) / most;
    const double power = std::floor(std::log10(least));
    double step = std::pow(10.0, power);
    int decimals = static_cast<int>(std::max(0.0, -power));
    for (const double factor : {2.0, 5.0, 10.0}) {
        if (step >= least) break;
        step = factor * std::pow(10.0, power);
        if (factor == 10.0) decimals = std::max(0, decimals - 1);
    }
    Ticks ticks{{}, decimals};
    constexpr double kRounding = 1e-9;  // of a step
    const double end = std::floor(last / step + kRounding);
    for (double i = std::ceil(first / step - kRounding); i <= end; ++i)
        ticks.values.push_back(i == 0.0 ? 0.0 : i * step);  // never -0
    return ticks;
}

}  // namespace fringe::plot
