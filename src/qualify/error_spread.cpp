#include "qualify/error_spread.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace fringe::qualify {
namespace {

// The exponent and six bits of the fraction of a positive double.
constexpr int kDropped = 52 - 6;
constexpr std::size_t kBins = std::size_t{1} << (63 - kDropped);

}  // namespace

double ulpsBetween(float value, double truth) {
    constexpr int kLeastExponent = std::numeric_limits<float>::min_exponent - 1;
    const int exponent = truth == 0.0 ? kLeastExponent : std::max(std::ilogb(truth), kLeastExponent);
    return std::abs(double{value} - truth) / std::ldexp(1.0, exponent - 23);
}

ErrorSpread::ErrorSpread() : bins_(kBins) {}

void ErrorSpread::add(double error) {
    assert(error >= 0.0);
    ++bins_[std::bit_cast<std::uint64_t>(error) >> kDropped];
    ++count_;
    largest_ = std::max(largest_, error);
}

void ErrorSpread::add(const ErrorSpread& other) {
    for (std::size_t i = 0; i < kBins; ++i) bins_[i] += other.bins_[i];
    count_ += other.count_;
    largest_ = std::max(largest_, other.largest_);
}

double ErrorSpread::percentile(double share) const {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
        sum += bins_[i];
        if (sum < wanted || bins_[i] == 0) continue;
        if (i == 0) return 0.0;  // 0, and less than any error can be
        return std::min(largest_, std::bit_cast<double>((std::uint64_t{i} + 1) << kDropped));
    }
    return largest_;
}

}  // namespace fringe::qualify
