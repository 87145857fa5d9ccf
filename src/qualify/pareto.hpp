// Which ways of doing something are worth taking, when each has two costs.
#pragma once

#include <span>
#include <vector>

namespace fringe::qualify {

struct Costs {
    double time;
    double error;
};

// Those that no other beats: no other has less of one cost and no more of the other. In the order of their
// time, as indices; of equal ones the first alone. Costs that are no number are never among them.
std::vector<std::size_t> paretoFront(std::span<const Costs> costs);

}  // namespace fringe::qualify
