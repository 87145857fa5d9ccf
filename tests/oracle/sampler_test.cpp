// The sample pattern: a true permutation, unbiased, even, and independent from dimension to dimension.
#include "oracle/sampler.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace fringe::oracle {
namespace {

TEST(Sampler, PermutationsVisitEveryNumberOnce) {
    for (const std::uint32_t count : {1U, 2U, 3U, 5U, 16U, 17U, 1000U}) {
        std::vector<int> visits(count, 0);
        for (std::uint32_t i = 0; i < count; ++i) ++visits.at(permuted(i, count, 7));
        EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
}

TEST(Sampler, ASingleSampleTakesTheMiddle) {
    const Sampler sampler(3, 5, 0, 1);
    EXPECT_EQ(sampler.pair(0), glm::dvec2(0.5));
    EXPECT_EQ(onUnitDisc(sampler.pair(1)), glm::dvec2(0.0));
}

TEST(Sampler, DependsOnSeedPixelAndDimension) {
    const glm::dvec2 point = Sampler(1, 1, 0, 2).pair(1);
    EXPECT_EQ(point, Sampler(1, 1, 0, 2).pair(1));
    EXPECT_NE(point, Sampler(2, 1, 0, 2).pair(1));
    EXPECT_NE(point, Sampler(1, 2, 0, 2).pair(1));
    EXPECT_NE(point, Sampler(1, 1, 0, 2).pair(2));
}

// Two samples per pixel are far too few to be even, so their mean shows bias alone: 5 standard errors of the
// mean of 20000 independent pixels; a product of two uniform numbers has mean 1/4 and variance 7/144, less
// for the two samples.
TEST(Sampler, IsUnbiasedFromPixelToPixel) {
    constexpr int kPixels = 20'000;
    double within = 0.0;
    double across = 0.0;
    for (int pixel = 0; pixel < kPixels; ++pixel) {
        for (std::uint32_t i = 0; i < 2; ++i) {
            const Sampler sampler(0, pixel, i, 2);
            const glm::dvec2 a = sampler.pair(0);
            within += 0.5 * a.x * a.y / kPixels;
            across += 0.5 * a.x * sampler.pair(1).y / kPixels;
        }
    }
    const double limit = 5.0 * std::sqrt(7.0 / 144.0 / kPixels);
    EXPECT_NEAR(within, 0.25, limit);
    EXPECT_NEAR(across, 0.25, limit);
}

// In one pixel 256 points integrate x y ten times as well as 256 random ones would (standard error 0.014),
// and a function of two dimensions, whose points are independent, about as well as those.
TEST(Sampler, IsEvenWithinAPixel) {
    constexpr std::uint32_t kCount = 256;
    double squaredWithin = 0.0;
    double squaredAcross = 0.0;
    for (int pixel = 0; pixel < 50; ++pixel) {
        double within = 0.0;
        double across = 0.0;
        for (std::uint32_t i = 0; i < kCount; ++i) {
            const Sampler sampler(9, pixel, i, kCount);
            const glm::dvec2 a = sampler.pair(0);
            within += a.x * a.y / kCount;
            across += a.x * sampler.pair(1).x / kCount;
        }
        squaredWithin += std::pow(within - 0.25, 2) / 50;
        squaredAcross += std::pow(across - 0.25, 2) / 50;
    }
    EXPECT_LT(std::sqrt(squaredWithin), 0.0014);
    EXPECT_LT(std::sqrt(squaredAcross), 0.014);
}

// A quarter of the area within half the radius, and a quarter of it in each quadrant: 5 standard errors.
TEST(Sampler, DiscIsEvenlyFilled) {
    constexpr int kPoints = 4096;
    int inner = 0;
    int quadrant = 0;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        const glm::dvec2 point = onUnitDisc(Sampler(0, 0, i, kPoints).pair(0));
        EXPECT_LE(glm::length(point), 1.0 + 1e-15);
        inner += glm::length(point) < 0.5 ? 1 : 0;
        quadrant += point.x > 0.0 && point.y > 0.0 ? 1 : 0;
    }
    const double limit = 5.0 * std::sqrt(kPoints * 0.25 * 0.75);
    EXPECT_NEAR(inner, 0.25 * kPoints, limit);
    EXPECT_NEAR(quadrant, 0.25 * kPoints, limit);
}

}  // namespace
}  // namespace fringe::oracle
