// Developing against the formula that its header states, and the laws of gamut mapping.
#include "image/develop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "image/pictures.hpp"

namespace fringe::image {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::array<int, 3> developed(const Pixel& pixel, const Development& development, int maxCode = 255) {
    std::array<std::uint8_t, 3> rgb8{};
    std::array<std::uint16_t, 3> rgb16{};
    if (maxCode == 255) develop8(development, {&pixel, 1}, rgb8);
    else develop16(development, {&pixel, 1}, rgb16);
    if (maxCode == 255) return {rgb8[0], rgb8[1], rgb8[2]};
    return {rgb16[0], rgb16[1], rgb16[2]};
}

Pixel filmIn(ColorSpace space, const glm::dvec3& rgb) {
    const glm::vec3 xyz = xyzFromLinear(space) * rgb;
    return {xyz.x, xyz.y, xyz.z, false};
}

class Develop : public testing::TestWithParam<ColorSpace> {};
INSTANTIATE_TEST_SUITE_P(Space, Develop,
                         testing::Values(ColorSpace::srgb, ColorSpace::displayP3, ColorSpace::rec2020));

// The formula in long double. The program's product of matrix and colour has three terms, together below 8,
// with a rounding each in the inverse, the scaling, the product and the sum: 8 x 6 x 2^-53 = 6e-15, which
// decides only where the formula's value is that close to a step between codes; the curve's slope is at most
// 13. One code either way is then right.
TEST_P(Develop, ColorsOfTheGamutFollowTheFormula) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> inside(0.0, 1.0);
    const TransferFunction curve = transferFunction(GetParam());
    const glm::dmat3 matrix = linearFromXyz(GetParam());
    for (const double exposure : {0.0, 1.0, -3.3}) {
        int exact = 0;
        for (int i = 0; i < 20000; ++i) {
            const glm::dvec3 wanted(inside(random), inside(random) * inside(random), inside(random));
            const Pixel pixel = filmIn(GetParam(), wanted * std::exp2(-exposure));
            for (const int maxCode : {255, 65535}) {
                const auto codes = developed(pixel, {GetParam(), exposure}, maxCode);
                for (int c = 0; c < 3; ++c) {
                    const long double linear = (static_cast<long double>(matrix[0][c]) * pixel.x +
                                                static_cast<long double>(matrix[1][c]) * pixel.y +
                                                static_cast<long double>(matrix[2][c]) * pixel.z) *
                                               std::exp2(exposure);
                    if (linear < 0.0L || linear > 1.0L) continue;  // by the rounding of the film's floats
                    const double unrounded = maxCode * curve.encode(static_cast<double>(linear)) + 0.5;
                    const double slack = maxCode * 13.0 * 6e-15 + 1e-11;
                    EXPECT_LE(std::floor(unrounded - slack), codes[static_cast<std::size_t>(c)]);
                    EXPECT_GE(std::floor(unrounded + slack), codes[static_cast<std::size_t>(c)]);
                    exact += std::floor(unrounded - slack) == std::floor(unrounded + slack) ? 1 : 0;
                }
            }
        }
        EXPECT_GT(exact, 119'000) << "the slack must hardly ever matter";
    }
}

TEST_P(Develop, GreysHaveThreeEqualChannels) {
    const glm::dvec3 white = displayWhite();
    for (int i = 0; i <= 255; ++i) {
        const glm::vec3 grey = white * transferFunction(GetParam()).decode(i / 255.0);
        EXPECT_EQ(developed({grey.x, grey.y, grey.z, false}, {GetParam()}), (std::array<int, 3>{i, i, i}));
    }
}

// Red of each space is (1, 0, 0) in it, and beyond the gamut of the smaller ones.
TEST(DevelopSpaces, PrimariesAreWhatTheyAreCalled) {
    const Pixel red = filmIn(ColorSpace::displayP3, {1.0, 0.0, 0.0});
    EXPECT_EQ(developed(red, {ColorSpace::displayP3}), (std::array<int, 3>{255, 0, 0}));
    const auto [r, g, b] = developed(red, {ColorSpace::srgb});
    EXPECT_EQ(r, 255);
    EXPECT_GT(std::min(g, b), 0) << "towards grey until it fits";
    EXPECT_EQ(developed(filmIn(ColorSpace::srgb, {0.0, 0.0, 1.0}), {}), (std::array<int, 3>{0, 0, 255}));
}

TEST(DevelopValues, AStopDoubles) {
    EXPECT_EQ(developed(filmOf(glm::dvec3(0.25, 0.25, 0.25)), {.exposure = 1.0}),
              (std::array<int, 3>{188, 188, 188}));
}

TEST(DevelopValues, WhiteBalanceMakesItsLightWhite) {
    const glm::dvec3 lamp(1.09850, 1.0, 0.35585);  // illuminant A
    const Pixel paper{1.09850F * 0.5F, 0.5F, 0.35585F * 0.5F, false};
    const auto tinted = developed(paper, {});
    EXPECT_GT(tinted[0], tinted[2] + 50);
    EXPECT_EQ(developed(paper, {.whiteBalance = adaptation(lamp, displayWhite()).value()}),
              (std::array<int, 3>{188, 188, 188}));
}

TEST(DevelopValues, WhatIsNoColorHasADefinedCode) {
    const std::array<int, 3> black{0, 0, 0}, white{255, 255, 255}, grey{188, 188, 188};
    EXPECT_EQ(developed({0.0F, kNan, 0.0F, false}, {}), black);
    EXPECT_EQ(developed({kInfinity, kInfinity, kInfinity, false}, {}), white);
    EXPECT_EQ(developed({-kInfinity, -kInfinity, -kInfinity, false}, {}), black);
    EXPECT_EQ(developed({0.5F, -0.5F, 0.5F, false}, {}), black);
    EXPECT_EQ(developed({kInfinity, 0.5F, 0.5F, false}, {}), grey);
    EXPECT_EQ(developed({kNan, 0.5F, 0.5F, false}, {}), grey);
    EXPECT_EQ(developed({0.0F, 0.0F, 0.0F, false}, {.exposure = 2000.0}), black);  // 0 times infinity
    EXPECT_EQ(developed({0.9F, 1.0F, kInfinity, true}, {}), black);
}

TEST(DevelopValues, ChannelsKeepTheirOrder) {
    std::array<std::uint8_t, 6> rgb{};
    develop8({}, std::vector<Pixel>{filmOf(glm::dvec3(1.0, 0.5, 0.0)), filmOf(glm::dvec3(0.0, 0.5, 1.0))},
             rgb);
    EXPECT_EQ(rgb, (std::array<std::uint8_t, 6>{255, 188, 0, 0, 188, 255}));
}

// ---- tone curves ----------------------------------------------------------------------------------

TEST(ToneCurves, HaveTheValuesOfTheirFormulas) {
    EXPECT_EQ(toned(ToneCurve::linear, 3.5), 3.5);
    EXPECT_DOUBLE_EQ(toned(ToneCurve::reinhard, 1.0), 0.5 * (1.0 + 1.0 / 256.0));
    EXPECT_DOUBLE_EQ(toned(ToneCurve::reinhard, 4.0), 4.0 * (1.0 + 4.0 / 256.0) / 5.0);
    EXPECT_DOUBLE_EQ(toned(ToneCurve::filmic, 1.0), 2.54 / 3.16);
}

TEST(ToneCurves, AscendFromBlackToWhiteWithoutAStep) {
    for (const ToneCurve curve : {ToneCurve::reinhard, ToneCurve::filmic}) {
        EXPECT_EQ(toned(curve, 0.0), 0.0);
        EXPECT_EQ(toned(curve, std::numeric_limits<double>::infinity()), 1.0);
        double before = 0.0;
        for (double luminance = 0.0; luminance < 40.0; luminance += 0.001) {
            const double here = toned(curve, luminance);
            EXPECT_GE(here, before);
            EXPECT_LT(here - before, 0.004);  // no slope of either is above 3
            before = here;
        }
        EXPECT_EQ(before, 1.0);
    }
}

// The luminance is the curve's, the chromaticity the film's.
TEST(ToneCurves, KeepTheChromaticity) {
    const glm::dvec3 film(3.0, 2.0, 1.0);
    for (const ToneCurve curve : {ToneCurve::reinhard, ToneCurve::filmic}) {
        const DisplayColor color = toned(curve, DisplayColor{film, 2.1});
        EXPECT_DOUBLE_EQ(color.luminance, toned(curve, 2.1));
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(color.rgb[i] / color.luminance, film[i] / 2.1, 1e-15);
    }
    EXPECT_EQ(toned(ToneCurve::reinhard, DisplayColor{glm::dvec3(0.0), 0.0}).luminance, 0.0);
}

TEST(ToneCurves, KeepApartWhatIsBrighterThanWhite) {
    const auto codeAt = [](double luminance, ToneCurve curve) {
        return developed(filmOf(glm::dvec3(luminance)), {.toneCurve = curve})[0];
    };
    EXPECT_EQ(codeAt(2.0, ToneCurve::linear), codeAt(4.0, ToneCurve::linear));
    for (const ToneCurve curve : {ToneCurve::reinhard, ToneCurve::filmic}) {
        EXPECT_LT(codeAt(2.0, curve), codeAt(4.0, curve));
        EXPECT_LT(codeAt(4.0, curve), 255);
        EXPECT_EQ(codeAt(16.0, curve), 255);
    }
}

// ---- gamut mapping ------------------------------------------------------------------------------

const glm::dvec3 kWeights = glm::transpose(xyzFromLinear(ColorSpace::srgb))[1];  // luminance of linear sRGB

DisplayColor colorOf(const glm::dvec3& rgb) {
    return {rgb, glm::dot(kWeights, rgb)};
}

// Colours all around the gamut, some far out; light exists, so the luminance is above 0.
std::vector<DisplayColor> colorsOutside() {
    std::mt19937 random(11);
    std::normal_distribution<double> channel(0.4, 0.8);
    std::vector<DisplayColor> colors;
    while (colors.size() < 20000) {
        const DisplayColor color = colorOf({channel(random), channel(random), channel(random)});
        const auto [low, high] = std::minmax({color.rgb.x, color.rgb.y, color.rgb.z});
        if (color.luminance > 0.0 && (low < 0.0 || high > 1.0)) colors.push_back(color);
    }
    return colors;
}

// 1e-15 where a value near 1 is rounded a few times; the share is a quotient of such values.
constexpr double kRounding = 4e-15;

TEST(GamutMapping, LeavesColorsOfTheGamutAlone) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> channel(0.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const DisplayColor color = colorOf({channel(random), channel(random), channel(random)});
        EXPECT_LT(glm::length(intoGamut(color) - color.rgb), 1e-15);
    }
}

TEST(GamutMapping, ResultsFitAndTouchTheGamutsSurface) {
    for (const DisplayColor& color : colorsOutside()) {
        const glm::dvec3 mapped = intoGamut(color);
        const auto [low, high] = std::minmax({mapped.x, mapped.y, mapped.z});
        EXPECT_GE(low, -kRounding);
        EXPECT_LE(high, 1.0 + kRounding);
        EXPECT_LT(std::min(std::abs(low), std::abs(high - 1.0)), kRounding)
            << "no more chroma lost than need be";
    }
}

TEST(GamutMapping, KeepsLuminanceUpToWhite) {
    for (const DisplayColor& color : colorsOutside())
        EXPECT_NEAR(glm::dot(kWeights, intoGamut(color)), std::min(color.luminance, 1.0), kRounding);
}

// Chroma is what the colour has beside its grey; it shrinks and does not turn. A channel clipped by itself
// would turn it, as the next test shows.
TEST(GamutMapping, StaysOnTheLineToGrey) {
    for (const DisplayColor& color : colorsOutside()) {
        if (color.luminance >= 1.0) continue;
        const glm::dvec3 chroma = color.rgb - color.luminance, kept = intoGamut(color) - color.luminance;
        EXPECT_LT(glm::length(glm::cross(chroma, kept)), kRounding * glm::length(chroma));
        EXPECT_GE(glm::dot(chroma, kept), 0.0);
        EXPECT_LE(glm::length(kept), glm::length(chroma) * (1.0 + kRounding));
    }
}

TEST(GamutMapping, ClipsNoChannel) {
    const glm::dvec3 orange = intoGamut(colorOf({1.6, 0.4, 0.1}));
    EXPECT_GT(orange.y, 0.4);  // clipping would leave 1, 0.4, 0.1: less light and a yellower hue
    EXPECT_GT(orange.z, 0.1);
    // The order of the channels and the place of the middle one between the others is the hue of HSV.
    EXPECT_NEAR((orange.y - orange.z) / (orange.x - orange.z), 0.3 / 1.5, kRounding);
}

// More exposure: never darker, never more saturated past the limit, no step, white in the end.
TEST(GamutMapping, BrighteningGoesToWhiteWithoutAStep) {
    for (const glm::dvec3 direction :
         {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(1.3, 0.2, -0.1), glm::dvec3(-0.4, 0.9, 0.3)}) {
        glm::dvec3 before = intoGamut(colorOf(std::exp2(-10.0) * direction));
        double saturationBefore = 1.0;
        for (double stops = -10.0; stops <= 6.0; stops += 1.0 / 256.0) {
            const glm::dvec3 now = intoGamut(colorOf(std::exp2(stops) * direction));
            EXPECT_GE(glm::dot(kWeights, now), glm::dot(kWeights, before) - kRounding);
            // A 256th of a stop is a factor of 1.0027, so the colour moves by that share of it at most, and
            // the chroma that has to go by as much of its length (up to 5 times the luminance) again.
            EXPECT_LT(glm::length(now - before), 6.0 * 0.0028);
            const double saturation = std::max({now.x, now.y, now.z}) - std::min({now.x, now.y, now.z});
            const double relative = saturation / std::max({now.x, now.y, now.z});
            EXPECT_LE(relative, saturationBefore + kRounding);
            saturationBefore = relative;
            before = now;
        }
        EXPECT_EQ(before, glm::dvec3(1.0));
    }
}

}  // namespace
}  // namespace fringe::image
