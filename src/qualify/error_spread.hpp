// How far floats are from the truth: units in the last place, and the largest and any percentile of many
// errors.
#pragma once

#include <cstdint>
#include <vector>

namespace fringe::qualify {

// |value - truth| in units of the last place that a float of the truth's size has.
double ulpsBetween(float value, double truth);

// Errors >= 0, counted by size in bins of 1/64 of an octave: any number of them in a megabyte.
class ErrorSpread {
public:
    ErrorSpread();

    void add(double error);
    void add(const ErrorSpread& other);

    std::uint64_t count() const { return count_; }
    double largest() const { return largest_; }

    // The error that `share` (0..1) of all do not exceed, or up to 1/64 more. 0 where there are none.
    double percentile(double share) const;

private:
    std::vector<std::uint64_t> bins_;
    std::uint64_t count_ = 0;
    double largest_ = 0.0;
};

}  // namespace fringe::qualify
