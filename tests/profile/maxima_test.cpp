// Maxima of curves whose maxima are known.
#include "profile/maxima.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace fringe::profile {
namespace {

using std::numbers::pi;

double sincSquared(double x) {
    if (x == 0.0) return 1.0;
    const double ratio = std::sin(pi * x) / (pi * x);
    return ratio * ratio;
}

double gaussian(double x, double sigma) {
    return std::exp(-0.5 * x * x / (sigma * sigma));
}

std::vector<double> sampled(std::size_t count, const std::function<double(double)>& curve) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(curve(static_cast<double>(i)));
    return values;
}

std::vector<Maximum> maximaOf(const std::vector<double>& values, Threshold threshold) {
    return findMaxima(values, std::vector<Threshold>(values.size(), threshold));
}

TEST(Maxima, OneLiesBetweenTheSamplesWithItsWidth) {
    for (const double place : {50.0, 50.3, 50.5, 50.77}) {
        const auto maxima =
            maximaOf(sampled(101, [&](double x) { return 3.0 * gaussian(x - place, 4.0); }), {});
        ASSERT_EQ(maxima.size(), 1U) << place;
        // Linear between samples: the chord's error is h^2/8 of the second derivative, and even about the
        // place.
        EXPECT_NEAR(maxima[0].place, place, 1e-3);
        EXPECT_NEAR(maxima[0].width, 4.0 * std::sqrt(8.0 * std::log(2.0)), 0.08);
        EXPECT_LT(maxima[0].asymmetry,
                  5e-3);  // a parabola's top is off by up to 1/(12 sigma^2) of the offset
        EXPECT_NEAR(maxima[0].value, 3.0, 3.0 * 0.5 * 0.25 / 16.0);
    }
}

TEST(Maxima, AsymmetryTellsOfASlope) {
    // Half as steep again to the right: the middle of what is above half height is (6 - 4)/2 of 1.18 from the
    // top.
    const auto maxima =
        maximaOf(sampled(101, [](double x) { return gaussian(x - 50.0, x < 50.0 ? 4.0 : 6.0); }), {});
    ASSERT_EQ(maxima.size(), 1U);
    EXPECT_GT(maxima[0].asymmetry, 0.5);
    EXPECT_GT(maxima[0].place, 50.5);
}

// Two equal lines at Rayleigh's distance have a dip of 8/pi^2 between them; at three quarters of it the dip
// is less than 5 % of the height.
TEST(Maxima, TwoLinesAreToldApartAtRayleighsDistance) {
    const double width = 20.0;
    const auto lines = [&](double distance) {
        return sampled(300, [=](double x) {
            return sincSquared((x - 150.0) / width) + sincSquared((x - 150.0 - distance) / width);
        });
    };
    const auto apart = maximaOf(lines(width), {.least = 0.3, .separation = 0.9 * width});
    ASSERT_EQ(apart.size(), 2U);
    EXPECT_NEAR(apart[0].place + apart[1].place, 300.0 + width, 0.05);  // each is pulled as far as the other
    EXPECT_EQ(maximaOf(lines(0.75 * width), {.least = 0.3, .separation = 0.0}).size(), 1U);
}

TEST(Maxima, SideLobesAreNone) {
    const auto values = sampled(401, [](double x) { return sincSquared((x - 200.2) / 20.0); });
    EXPECT_EQ(maximaOf(values, {.least = 0.01, .separation = 18.0}).size(), 1U);
    EXPECT_EQ(maximaOf(values, {.least = 0.01, .separation = 0.0}).size(), 5U);  // two on either side
}

TEST(Maxima, ABeamsFootprintIsOneWithAllItsRipples) {
    const auto values = sampled(401, [](double x) {
        const double from = x - 200.0;
        return std::abs(from) > 80.0 ? 0.0 : 1.0 + 0.2 * std::cos(0.4 * from) + 0.001 * from;
    });
    const auto maxima = maximaOf(values, {.least = 0.02, .separation = 160.0});
    ASSERT_EQ(maxima.size(), 1U);
    EXPECT_NEAR(maxima[0].place, 200.0, 8.0);  // pulled by the slope: 80^2 0.001/(3 (1 - 0.5)) and ripples
    EXPECT_NEAR(maxima[0].width, 160.0, 1.5);
    EXPECT_GT(maximaOf(values, {.least = 0.02, .separation = 0.0}).size(), 5U);
}

TEST(Maxima, WeakOnesAreLeftOutWhereTheyWouldBeNoise) {
    const auto values =
        sampled(201, [](double x) { return gaussian(x - 60.0, 5.0) + 0.01 * gaussian(x - 150.0, 5.0); });
    EXPECT_EQ(maximaOf(values, {.least = 0.02, .separation = 0.0}).size(), 1U);
    EXPECT_EQ(maximaOf(values, {.least = 0.005, .separation = 0.0}).size(), 2U);
}

TEST(Maxima, AreNotAtTheEndsAndInTheMiddleOfAPlateau) {
    EXPECT_TRUE(maximaOf({3.0, 2.0, 1.0, 2.0, 3.0}, {}).empty());
    EXPECT_TRUE(maximaOf({1.0, 1.0, 1.0}, {}).empty());
    EXPECT_TRUE(maximaOf({0.0, 1.0}, {}).empty());
    const auto plateau = maximaOf({0.0, 1.0, 2.0, 2.0, 2.0, 1.0, 0.0}, {});
    ASSERT_EQ(plateau.size(), 1U);
    EXPECT_EQ(plateau[0].top, 3U);
    EXPECT_NEAR(plateau[0].place, 3.0, 1e-12);
}

}  // namespace
}  // namespace fringe::profile
