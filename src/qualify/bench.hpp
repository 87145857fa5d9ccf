// What all benchmarks share: what they are told, and what repeated timings come to.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

namespace fringe::qualify {

// The value that `share` (0..1) of all do not exceed; between two neighbours in proportion. Of one or more,
// ascending.
double quantile(const std::vector<double>& sorted, double share);

// The median, and half the distance between the quartiles.
struct Spread {
    double median = 0.0;
    double half = 0.0;
};

// Of one value or more.
Spread spreadOf(std::vector<double> values);

// Of times to others that were taken in the same rounds.
Spread ratioOf(const std::vector<double>& times, const std::vector<double>& others);

// What a benchmark was told, and whom it tells.
struct BenchControl {
    int rounds = 7;                                          // timings of each setting
    const std::atomic<bool>& cancelled;                      // polled about every 50 ms
    std::function<void(double)> onProgress = [](double) {};  // share of the case that is done
};

}  // namespace fringe::qualify
