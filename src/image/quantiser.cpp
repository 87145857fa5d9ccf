#include "image/quantiser.hpp"

#include <cmath>
#include <limits>

namespace fringe::image {

Quantiser::Quantiser(std::uint32_t maxCode, const TransferFunction& curve) {
    thresholds_.push_back(0.0);
    for (std::uint32_t k = 1; k <= maxCode; ++k) thresholds_.push_back(curve.decode((k - 0.5) / maxCode));
    thresholds_.push_back(std::numeric_limits<double>::infinity());

    lowest_ = std::exp2(std::floor(std::log2(thresholds_[1])));
    firstBucket_ = bucket(static_cast<float>(lowest_));

    // The curve is concave, so a chord is nowhere above it; the margin covers the chord's float rounding.
    constexpr double margin = 1.0 / 64.0;
    const auto code = [&](double linear) { return maxCode * curve.encode(linear) + 0.5 - margin; };
    for (std::uint32_t index = firstBucket_; bucketStart(index) < 1.0; ++index) {
        const double start = bucketStart(index), end = bucketStart(index + 1);
        const double slope = (code(end) - code(start)) / (end - start);
        chords_.push_back({static_cast<float>(code(start) - slope * start), static_cast<float>(slope)});
    }
    chords_.push_back({static_cast<float>(code(1.0)), 0.0F});  // the value 1 itself
}

}  // namespace fringe::image
