// The table of code values against the formula that it stands for, evaluated as it stands.
#include "image/quantiser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

namespace fringe::image {
namespace {

class Quantising : public testing::TestWithParam<std::tuple<ColorSpace, std::uint32_t>> {
protected:
    std::uint32_t formula(double value) const {
        const double shown = std::isnan(value) ? 0.0 : std::clamp(value, 0.0, 1.0);
        return static_cast<std::uint32_t>(std::floor(maxCode_ * curve_.encode(shown) + 0.5));
    }

    TransferFunction curve_ = transferFunction(std::get<0>(GetParam()));
    std::uint32_t maxCode_ = std::get<1>(GetParam());
    Quantiser quantise_{maxCode_, curve_};
};
INSTANTIATE_TEST_SUITE_P(Depth, Quantising,
                         testing::Combine(testing::Values(ColorSpace::srgb, ColorSpace::rec2020),
                                          testing::Values(255U, 65535U)));

// The formula rises with the value, so agreement on the doubles around every value at which the code changes
// is, with the next test, agreement on all. Around the thresholds themselves, where the table and the formula
// round independently, the inverse of the curve errs by less than 1e-15.
TEST_P(Quantising, EqualsTheFormulaAroundEveryThreshold) {
    for (std::uint32_t code = 1; code <= maxCode_; ++code) {
        const double threshold = curve_.decode((code - 0.5) / maxCode_);
        for (const double step : {-1e-7, -1e-11, -4e-15, 4e-15, 1e-11, 1e-7}) {
            const double value = threshold * (1.0 + step) + (step < 0.0 ? -4e-16 : 4e-16);
            ASSERT_EQ(quantise_(value), formula(value)) << value;
        }
        const auto centre = std::bit_cast<std::uint32_t>(static_cast<float>(threshold));
        for (std::uint32_t bits = centre - 2; bits <= centre + 2; ++bits) {
            const auto value = std::bit_cast<float>(bits);
            ASSERT_EQ(quantise_(value), formula(value)) << value;
        }
    }
}

// One float in 2039, of all signs and sizes: every chord of the guess is met dozens of times.
TEST_P(Quantising, EqualsTheFormulaOverAllFloats) {
    constexpr std::uint32_t step = 2039;
    for (std::uint64_t bits = 0; bits <= 0xFFFFFFFFU; bits += step) {
        const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        ASSERT_EQ(quantise_(value), formula(value)) << value;
    }
}

TEST_P(Quantising, WhatIsOutOfRangeHasADefinedCode) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(quantise_(std::numeric_limits<double>::quiet_NaN()), 0U);
    EXPECT_EQ(quantise_(infinity), maxCode_);
    EXPECT_EQ(quantise_(-infinity), 0U);
    EXPECT_EQ(quantise_(-1.0), 0U);
    EXPECT_EQ(quantise_(-0.0), 0U);
}

// IEC 61966-2-1 evaluated by hand: 0.18 -> 0.461356, 0.5 -> 0.735357, 0.0031308 -> 0.04045.
TEST(QuantisedValues, KnownCodesOfSrgb) {
    const Quantiser eight(255, transferFunction(ColorSpace::srgb));
    const Quantiser sixteen(65535, transferFunction(ColorSpace::displayP3));
    EXPECT_EQ(eight(1.0), 255U);
    EXPECT_EQ(eight(0.18), 118U);
    EXPECT_EQ(eight(0.5), 188U);
    EXPECT_EQ(eight(0.0031308), 10U);
    EXPECT_EQ(sixteen(0.18), 30235U);
}

}  // namespace
}  // namespace fringe::image
