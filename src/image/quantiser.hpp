// Linear values to code values, by table. One power per channel would take longer than the rest of writing a
// picture, so the formula is inverted: the values at which the code changes are computed once (the
// thresholds), and a piecewise linear guess finds the code to within the one comparison that then settles it.
// tests/image/develop_test.cpp proves the result equal to the formula on both sides of every threshold.
// Internal to the image library.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "image/color_space.hpp"

namespace fringe::image {

class Quantiser {
public:
    // For codes 0..maxCode of a concave curve from 0..1 to 0..1.
    Quantiser(std::uint32_t maxCode, const TransferFunction& curve);

    // floor(maxCode * encode(clamp(linear, 0, 1)) + 1/2); any double, NaN gives 0.
    std::uint32_t operator()(double linear) const {
        const double value = std::min(std::max(lowest_, linear), 1.0);  // a NaN compares false: lowest_
        const auto rounded = static_cast<float>(value);
        const Chord& chord = chords_[bucket(rounded) - firstBucket_];
        const auto guess = static_cast<std::int32_t>(chord.offset + chord.slope * rounded);
        return static_cast<std::uint32_t>(
            guess + (value >= thresholds_[static_cast<std::size_t>(guess) + 1] ? 1 : 0));
    }

private:
    // 128 guesses per octave: no chord is more than 0.14 codes of 65535 below its arc.
    static constexpr int kMantissaBits = 7;

    struct Chord {
        float offset, slope;
    };

    // Positive floats ordered by their leading bits: exponent and kMantissaBits of mantissa.
    static std::uint32_t bucket(float value) {
        return std::bit_cast<std::uint32_t>(value) >> (23 - kMantissaBits);
    }
    static double bucketStart(std::uint32_t index) {
        return std::bit_cast<float>(index << (23 - kMantissaBits));
    }

    std::vector<double> thresholds_;  // [k]: from this value on the code is k; infinite past the last
    double lowest_;                   // a power of two at which the code is still 0
    std::uint32_t firstBucket_;
    std::vector<Chord> chords_;
};

}  // namespace fringe::image
