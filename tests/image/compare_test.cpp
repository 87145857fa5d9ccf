#include "image/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/pictures.hpp"

namespace fringe::image {
namespace {

TEST(Compare, EqualPicturesHaveNoDifference) {
    const Picture picture = testColors(7, 5);
    const Difference difference = compare(picture, picture, 0.0);
    EXPECT_EQ(difference.overall.maxAbs, 0.0);
    EXPECT_EQ(difference.overall.rmse, 0.0);
    EXPECT_EQ(difference.beyond, 0U);
    EXPECT_EQ(difference.psnr, std::numeric_limits<double>::infinity());
}

// Two of 20 pixels differ, by amounts that floats hold exactly, so the expected numbers are exact as well.
TEST(Compare, NumbersOfAKnownDifference) {
    Picture a{5, 4, Quantity::color, std::vector<RgbPixel>(20)}, b = a;
    b.pixels[7].g = 0.5F;     // x 2, y 1
    b.pixels[13].b = -0.25F;  // x 3, y 2
    b.pixels[13].r = 0.25F;
    const Difference difference = compare(a, b, 0.25);
    EXPECT_EQ(difference.channels[0].maxAbs, 0.25);
    EXPECT_EQ(difference.channels[1].maxAbs, 0.5);
    EXPECT_EQ(difference.channels[2].maxAbs, 0.25);
    EXPECT_DOUBLE_EQ(difference.channels[1].rmse, std::sqrt(0.25 / 20.0));
    EXPECT_EQ(difference.overall.maxAbs, 0.5);
    EXPECT_DOUBLE_EQ(difference.overall.rmse, std::sqrt((0.25 + 0.0625 + 0.0625) / 60.0));
    EXPECT_DOUBLE_EQ(difference.psnr, 10.0 * std::log10(60.0 / 0.375));
    EXPECT_EQ(difference.maxX, 2U);
    EXPECT_EQ(difference.maxY, 1U);
    EXPECT_EQ(difference.beyond, 1U);  // 0.25 is not beyond 0.25
    EXPECT_EQ(difference.beyondFraction, 1.0 / 20.0);
    EXPECT_EQ(compare(a, b, 0.2).beyond, 2U);
}

TEST(Compare, AMarkInOnePictureOnlyIsBeyondAnyTolerance) {
    Picture a{2, 1, Quantity::color, std::vector<RgbPixel>(2)}, b = a;
    a.pixels[0].nonFinite = b.pixels[0].nonFinite = true;
    b.pixels[1].nonFinite = true;
    const Difference difference = compare(a, b, 1.0);
    EXPECT_EQ(difference.nonFiniteMismatches, 1U);
    EXPECT_EQ(difference.beyond, 1U);
    EXPECT_EQ(difference.overall.maxAbs, 0.0);
}

TEST(Compare, ValuesThatAreNotFiniteDifferFromAllButTheirEqual) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const Picture a{1, 1, Quantity::color, {{nan, infinity, 0.0F, false}}};
    EXPECT_EQ(compare(a, a, 0.0).overall.maxAbs, 0.0);
    const Picture b{1, 1, Quantity::color, {{0.0F, infinity, 0.0F, false}}};
    const Difference difference = compare(a, b, 1e9);
    EXPECT_EQ(difference.channels[0].maxAbs, infinity);
    EXPECT_EQ(difference.channels[1].maxAbs, 0.0);
    EXPECT_EQ(difference.psnr, -infinity);
    EXPECT_EQ(difference.beyond, 1U);
}

TEST(Compare, DifferentSizesAreRefusedWithBoth) {
    try {
        compare(testColors(3, 2), testColors(2, 3), 0.0);
        FAIL() << "compared";
    } catch (const MismatchError& error) {
        EXPECT_STREQ(error.what(), "the pictures have 3x2 and 2x3 pixels; they must be of one size");
    }
}

TEST(Compare, AQuantityHasOneChannel) {
    Picture a{2, 1, Quantity::luminance, {{1.0F, 1.0F, 1.0F, false}, {40.0F, 40.0F, 40.0F, false}}}, b = a;
    b.pixels[1] = {43.0F, 43.0F, 43.0F, false};
    const Difference difference = compare(a, b, 0.0);
    EXPECT_EQ(difference.quantity, Quantity::luminance);
    ASSERT_EQ(difference.channels.size(), 1U);
    EXPECT_EQ(difference.channels[0].maxAbs, 3.0);
    EXPECT_DOUBLE_EQ(difference.channels[0].rmse, 3.0 / std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(difference.overall.rmse, 3.0 / std::sqrt(2.0));
    EXPECT_EQ(difference.beyond, 1U);
}

TEST(Compare, DifferentQuantitiesAreRefusedWithBoth) {
    const Picture color{1, 1, Quantity::color, std::vector<RgbPixel>(1)};
    const Picture radiance{1, 1, Quantity::radiance, std::vector<RgbPixel>(1)};
    try {
        compare(color, radiance, 0.0);
        FAIL() << "compared";
    } catch (const MismatchError& error) {
        EXPECT_STREQ(error.what(), "one picture shows color, the other radiance");
    }
}

}  // namespace
}  // namespace fringe::image
