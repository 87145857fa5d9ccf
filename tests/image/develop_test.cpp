// develop8 and develop16 against the formula that their header states, evaluated as it stands.
#include "image/develop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace fringe::image {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::uint32_t formula(float value, double exposure, std::uint32_t maxCode) {
    const double scaled = static_cast<double>(value) * std::exp2(exposure);
    const double shown = std::isnan(scaled) ? 0.0 : std::clamp(scaled, 0.0, 1.0);
    return static_cast<std::uint32_t>(std::floor(maxCode * encodeSrgb(shown) + 0.5));
}

std::uint32_t developed(float value, double exposure, std::uint32_t maxCode) {
    const Pixel pixel{value, 0.0F, 0.0F, false};
    if (maxCode == 255) {
        std::array<std::uint8_t, 3> rgb{};
        develop8({&pixel, 1}, exposure, rgb);
        return rgb[0];
    }
    std::array<std::uint16_t, 3> rgb{};
    develop16({&pixel, 1}, exposure, rgb);
    return rgb[0];
}

class Develop : public testing::TestWithParam<std::uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Depth, Develop, testing::Values(255U, 65535U));

// The formula rises with the value, so at exposure 0 agreement on the floats around every value at which
// the code changes is, with the next test, agreement on all floats. Other exposures move the thresholds.
TEST_P(Develop, EqualsTheFormulaAroundEveryThreshold) {
    const std::uint32_t maxCode = GetParam();
    for (const double exposure : {0.0, 1.0, -3.0, 0.3, -2.71}) {
        for (std::uint32_t code = 1; code <= maxCode; ++code) {
            const double threshold = decodeSrgb((code - 0.5) / maxCode) / std::exp2(exposure);
            const auto centre = std::bit_cast<std::uint32_t>(static_cast<float>(threshold));
            for (std::uint32_t bits = centre - 2; bits <= centre + 2; ++bits) {
                const auto value = std::bit_cast<float>(bits);
                ASSERT_EQ(developed(value, exposure, maxCode), formula(value, exposure, maxCode))
                    << value << " at exposure " << exposure;
            }
        }
    }
}

// One float in 2039, of all signs and sizes: every chord of the guess is met dozens of times.
TEST_P(Develop, EqualsTheFormulaOverAllFloats) {
    constexpr std::uint32_t step = 2039;
    for (std::uint64_t bits = 0; bits <= 0xFFFFFFFFU; bits += step) {
        const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        ASSERT_EQ(developed(value, 0.0, GetParam()), formula(value, 0.0, GetParam())) << value;
    }
}

TEST_P(Develop, ValuesThatAreNoColourHaveADefinedCode) {
    const std::uint32_t maxCode = GetParam();
    EXPECT_EQ(developed(kNan, 0.0, maxCode), 0U);
    EXPECT_EQ(developed(kInfinity, 0.0, maxCode), maxCode);
    EXPECT_EQ(developed(-kInfinity, 0.0, maxCode), 0U);
    EXPECT_EQ(developed(-1.0F, 0.0, maxCode), 0U);
    EXPECT_EQ(developed(-0.0F, 0.0, maxCode), 0U);
    EXPECT_EQ(developed(0.0F, 2000.0, maxCode), 0U);  // 2^2000 is infinite, and 0 times that is NaN
}

// IEC 61966-2-1 evaluated by hand: 0.18 -> 0.461356, 0.5 -> 0.735357, 0.0031308 -> 0.04045.
TEST(DevelopValues, KnownCodes) {
    EXPECT_EQ(developed(1.0F, 0.0, 255), 255U);
    EXPECT_EQ(developed(0.18F, 0.0, 255), 118U);
    EXPECT_EQ(developed(0.5F, 0.0, 255), 188U);
    EXPECT_EQ(developed(0.0031308F, 0.0, 255), 10U);
    EXPECT_EQ(developed(0.18F, 0.0, 65535), 30235U);
    EXPECT_EQ(developed(0.25F, 1.0, 255), 188U);  // a stop doubles
}

TEST(DevelopValues, ChannelsKeepTheirOrderAndMarkedPixelsAreBlack) {
    const std::vector<Pixel> pixels = {{1.0F, 0.5F, 0.0F, false}, {1.0F, kInfinity, kNan, true}};
    std::array<std::uint8_t, 6> rgb{};
    develop8(pixels, 0.0, rgb);
    EXPECT_EQ(rgb, (std::array<std::uint8_t, 6>{255, 188, 0, 0, 0, 0}));
}

// 1e-15 is a few roundings of a value up to 1. At the breakpoints, which the standard rounds to 0.0031308 and
// 0.04045, its two branches are 2.9e-8 apart.
TEST(TransferFunction, DecodeInvertsEncode) {
    for (int i = 0; i <= 4096; ++i) {
        const double encoded = i / 4096.0;
        EXPECT_NEAR(encodeSrgb(decodeSrgb(encoded)), encoded, 1e-15) << encoded;
    }
    EXPECT_NEAR(encodeSrgb(decodeSrgb(0.04045)), 0.04045, 3e-8);
}

}  // namespace
}  // namespace fringe::image
