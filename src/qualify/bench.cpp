#include "qualify/bench.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fringe::qualify {

double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

Spread spreadOf(std::vector<double> values) {
    assert(!values.empty());
    std::sort(values.begin(), values.end());
    return {quantile(values, 0.5), 0.5 * (quantile(values, 0.75) - quantile(values, 0.25))};
}

Spread ratioOf(const std::vector<double>& times, const std::vector<double>& others) {
    assert(times.size() == others.size());
    std::vector<double> ratios;
    for (std::size_t i = 0; i < times.size(); ++i) ratios.push_back(times[i] / others[i]);
    return spreadOf(std::move(ratios));
}

}  // namespace fringe::qualify
