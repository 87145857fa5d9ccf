#include "qualify/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace fringe::qualify {

std::vector<std::size_t> paretoFront(std::span<const Costs> costs) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < costs.size(); ++i)
        if (!std::isnan(costs[i].time) && !std::isnan(costs[i].error)) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(costs[a].time, costs[a].error, a) < std::tie(costs[b].time, costs[b].error, b);
    });
    // Whoever takes longer than all before must be more exact than all of them.
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (costs[i].error >= least && !front.empty()) continue;
        least = costs[i].error;
        front.push_back(i);
    }
    return front;
}

}  // namespace fringe::qualify
