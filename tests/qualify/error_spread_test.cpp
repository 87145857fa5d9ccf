// Errors as the report counts them.
#include "qualify/error_spread.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "qualify/draw.hpp"

namespace fringe::qualify {
namespace {

TEST(Ulps, AreThoseOfAFloatOfTheTruthsSize) {
    EXPECT_EQ(ulpsBetween(1.0F, 1.0), 0.0);
    EXPECT_EQ(ulpsBetween(std::nextafter(1.0F, 2.0F), 1.0), 1.0);
    EXPECT_EQ(ulpsBetween(1.0F, 1.0 + 0x1p-24), 0.5);
    EXPECT_EQ(ulpsBetween(-8.0F, -8.0 - 0x1p-20), 1.0);
    // The spacing of denormal numbers, and of 0.
    constexpr float kLeast = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(ulpsBetween(3.0F * kLeast, 0.0), 3.0);
    EXPECT_EQ(ulpsBetween(0.0F, double{2.0F * kLeast}), 2.0);
}

TEST(ErrorSpread, PercentilesAreAtMostASixtyFourthTooLarge) {
    ErrorSpread spread;
    EXPECT_EQ(spread.percentile(0.999), 0.0);
    for (int i = 1; i <= 10'000; ++i) spread.add(i * 1e-9);
    EXPECT_EQ(spread.count(), 10'000U);
    EXPECT_EQ(spread.largest(), 1e-5);
    for (const double share : {0.001, 0.5, 0.999}) {
        const double exact = share * 1e-5;
        EXPECT_GE(spread.percentile(share), exact) << share;
        EXPECT_LE(spread.percentile(share), exact * (1.0 + 1.0 / 64.0) + 1e-15) << share;
    }
    EXPECT_EQ(spread.percentile(1.0), 1e-5);
}

TEST(ErrorSpread, CountsNothingAsNothing) {
    ErrorSpread spread;
    for (int i = 0; i < 1000; ++i) spread.add(0.0);
    spread.add(1e-300);
    EXPECT_EQ(spread.percentile(0.999), 0.0);
    EXPECT_EQ(spread.largest(), 1e-300);
}

TEST(ErrorSpread, OfTwoThreadsIsThatOfOne) {
    ErrorSpread all, one, other;
    for (int i = 0; i < 5000; ++i) {
        const double error = Draw(7, static_cast<std::uint64_t>(i)).magnitude(1e-12, 1.0);
        all.add(error);
        (i % 3 == 0 ? one : other).add(error);
    }
    one.add(other);
    EXPECT_EQ(one.count(), all.count());
    EXPECT_EQ(one.largest(), all.largest());
    for (const double share : {0.1, 0.9, 0.999}) EXPECT_EQ(one.percentile(share), all.percentile(share));
}

TEST(Draw, DependsOnSeedAndNumberAlone) {
    const auto three = [](Draw draw) { return std::array{draw.bits(), draw.bits(), draw.bits()}; };
    EXPECT_EQ(three({1, 5}), three({1, 5}));
    EXPECT_NE(three({1, 5}), three({2, 5}));
    EXPECT_NE(three({1, 5}), three({1, 6}));
}

}  // namespace
}  // namespace fringe::qualify
