// Round numbers for an axis.
#pragma once

#include <string>
#include <vector>

namespace fringe::plot {

struct Ticks {
    std::vector<double> values;
    int decimals;

    // As many decimals as tell one tick from the next; powers of ten where the numbers are very large or
    // small.
    std::string label(double value) const;
};

// Multiples of 1, 2 or 5 times a power of ten within the range, at most `most` + 1 of them. Precondition:
// first < last.
Ticks ticksBetween(double first, double last, int most);

}  // namespace fringe::plot
