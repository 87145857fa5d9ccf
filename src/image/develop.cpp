// One power per channel would take longer than the rest of writing a picture, so the formula is inverted:
// the values at which the code changes are computed once (the thresholds), and a piecewise linear guess
// finds the code to within the one comparison that then settles it. tests/image/develop_test.cpp proves
// the result equal to the formula on both sides of every threshold.
#include "image/develop.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace fringe::image {

namespace {

// 128 guesses per octave: no chord is more than 0.14 codes of 65535 below its arc.
constexpr int kMantissaBits = 7;

class Quantiser {
public:
    explicit Quantiser(std::uint32_t maxCode);

    // The code of a linear value; any double, NaN too.
    std::uint32_t operator()(double linear) const {
        const double value = std::min(std::max(lowest_, linear), 1.0);  // a NaN compares false: lowest_
        const auto rounded = static_cast<float>(value);
        const Chord& chord = chords_[bucket(rounded) - firstBucket_];
        const auto guess = static_cast<std::int32_t>(chord.offset + chord.slope * rounded);
        return static_cast<std::uint32_t>(
            guess + (value >= thresholds_[static_cast<std::size_t>(guess) + 1] ? 1 : 0));
    }

private:
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

Quantiser::Quantiser(std::uint32_t maxCode) {
    thresholds_.push_back(0.0);
    for (std::uint32_t k = 1; k <= maxCode; ++k) thresholds_.push_back(decodeSrgb((k - 0.5) / maxCode));
    thresholds_.push_back(std::numeric_limits<double>::infinity());

    lowest_ = std::exp2(std::floor(std::log2(thresholds_[1])));
    firstBucket_ = bucket(static_cast<float>(lowest_));

    // The curve is concave, so a chord is nowhere above it; the margin covers the chord's float rounding.
    constexpr double margin = 1.0 / 64.0;
    const auto curve = [&](double linear) { return maxCode * encodeSrgb(linear) + 0.5 - margin; };
    for (std::uint32_t index = firstBucket_; bucketStart(index) < 1.0; ++index) {
        const double start = bucketStart(index), end = bucketStart(index + 1);
        const double slope = (curve(end) - curve(start)) / (end - start);
        chords_.push_back({static_cast<float>(curve(start) - slope * start), static_cast<float>(slope)});
    }
    chords_.push_back({static_cast<float>(curve(1.0)), 0.0F});  // the value 1 itself
}

template <class Code>
void develop(const Quantiser& quantise, std::span<const Pixel> pixels, double exposure, std::span<Code> rgb) {
    assert(rgb.size() == 3 * pixels.size());
    const double scale = std::exp2(exposure);
    Code* out = rgb.data();
    for (const Pixel& pixel : pixels) {
        const double shown = pixel.nonFinite ? 0.0 : scale;
        *out++ = static_cast<Code>(quantise(pixel.r * shown));
        *out++ = static_cast<Code>(quantise(pixel.g * shown));
        *out++ = static_cast<Code>(quantise(pixel.b * shown));
    }
}

}  // namespace

double encodeSrgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double decodeSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

void develop8(std::span<const Pixel> pixels, double exposure, std::span<std::uint8_t> rgb) {
    static const Quantiser quantise(255);
    develop(quantise, pixels, exposure, rgb);
}

void develop16(std::span<const Pixel> pixels, double exposure, std::span<std::uint16_t> rgb) {
    static const Quantiser quantise(65535);
    develop(quantise, pixels, exposure, rgb);
}

}  // namespace fringe::image
