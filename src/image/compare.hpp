// How far two pictures are apart, in the linear values they hold.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "image/image.hpp"

namespace fringe::image {

// Two pictures that cannot be compared; the message states both sizes, or what each shows.
class MismatchError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct ChannelDifference {
    double maxAbs = 0.0;  // largest |a - b|
    double rmse = 0.0;    // root of the mean of (a - b)^2
};

// A value that is not finite differs from any other by infinity, and not at all from its equal
// (NaN equals NaN here).
struct Difference {
    Quantity quantity = Quantity::color;      // of both pictures
    std::vector<ChannelDifference> channels;  // red, green, blue; of another quantity its own
    ChannelDifference overall;                // over all values of all channels
    double psnr = 0.0;                        // dB, for a peak of 1; infinite for equal pictures
    std::uint32_t maxX = 0, maxY = 0;         // the first pixel, row by row, with the overall maxAbs
    std::uint64_t beyond = 0;     // pixels with a channel beyond the tolerance, or marked in one only
    double beyondFraction = 0.0;  // of all pixels
    std::uint64_t nonFiniteMismatches = 0;  // pixels marked nonFinite in one picture only
};

// Compare a and b; tolerance >= 0 applies to |a - b| of each channel. Throws MismatchError.
Difference compare(const Picture& a, const Picture& b, double tolerance);

}  // namespace fringe::image
