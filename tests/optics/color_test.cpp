#include "optics/color.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>
#include <random>

#include "optics/curve_file.hpp"
#include "optics/sources.hpp"

namespace fringe::optics {
namespace {

using glm::dvec3;

const Curve kWhite = constantCurve(1.0);

void expectNear(dvec3 actual, dvec3 expected, double tolerance) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
    EXPECT_NEAR(actual.z, expected.z, tolerance);
}

dvec3 srgb(const Spectrum& spectrum, const Curve& reflectance) {
    return linearSrgbFromXyz() * xyzPerWatt(spectrum, reflectance);
}

Spectrum d65() {
    return namedSpectrum("D65").value();
}

// The sum over small steps that stands for the integral: the error of the middle rule is second order, 1e-8.
dvec3 bruteForce(const Spectrum& spectrum, const Curve& reflectance) {
    constexpr int kSteps = 400'000;
    dvec3 sum(0.0);
    for (int i = 0; i < kSteps; ++i) {
        const double l_nm = 380.0 + 400.0 * (i + 0.5) / kSteps;
        double power = valueAt(spectrum.density, l_nm);
        for (const Line& line : spectrum.lines) {
            const double x = (l_nm - line.wavelength / units::nm) / (line.width / units::nm);
            power += line.power / (line.width / units::nm) * 2.0 *
                     std::sqrt(std::numbers::ln2 / std::numbers::pi) *
                     std::exp(-4.0 * std::numbers::ln2 * x * x);
        }
        sum += power * valueAt(reflectance, l_nm) * colorMatching(l_nm) * (400.0 / kSteps);
    }
    return sum;
}

TEST(ColorMatching, HasThePublishedSums) {
    // 5 nm steps from 380 to 780 nm: 21.371524, 21.371327, 21.371540 (CIE 15, in the six decimals of older
    // tables).
    dvec3 sum(0.0);
    for (int l_nm = 380; l_nm <= 780; l_nm += 5) sum += colorMatching(l_nm);
    expectNear(sum, {21.371524, 21.371327, 21.371540}, 2e-5);
}

TEST(ColorMatching, IsLinearBetweenNanometresAndZeroOutside) {
    expectNear(colorMatching(555.0), {0.5120501, 1.0, 0.005749999}, 1e-9);
    expectNear(colorMatching(480.25), 0.75 * colorMatching(480.0) + 0.25 * colorMatching(481.0), 1e-15);
    EXPECT_EQ(colorMatching(379.999), dvec3(0.0));
    EXPECT_EQ(colorMatching(780.001), dvec3(0.0));
    EXPECT_GT(colorMatching(380.0).y, 0.0);
    EXPECT_GT(colorMatching(780.0).y, 0.0);
}

TEST(ColorMatching, FollowsTheSpectralLocus) {
    // CIE 15, chromaticities of the spectral stimuli, five decimals.
    const struct {
        double l_nm, x, y;
    } stimuli[] = {{400.0, 0.17334, 0.00480}, {450.0, 0.15664, 0.01771}, {480.0, 0.09129, 0.13270},
                   {500.0, 0.00817, 0.53842}, {520.0, 0.07430, 0.83380}, {550.0, 0.30160, 0.69231},
                   {580.0, 0.51249, 0.48659}, {600.0, 0.62704, 0.37249}, {700.0, 0.73469, 0.26531}};
    for (const auto& [l_nm, x, y] : stimuli) {
        const dvec3 xyz = colorMatching(l_nm);
        EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), x, 6e-6) << l_nm;
        EXPECT_NEAR(xyz.y / (xyz.x + xyz.y + xyz.z), y, 6e-6) << l_nm;
    }
}

TEST(Film, WhiteIsD65) {
    EXPECT_NEAR(xyzPerWatt(d65(), kWhite).y, 1.0, 1e-14);
    // CIE 15: 0.95047 and 1.08883, as sums over 5 nm; the integral of what is linear in between has 2.5e-4
    // less Z, whose matching function is narrow.
    expectNear(xyzPerWatt(d65(), kWhite), {0.95047, 1.0, 1.08883}, 3e-4);
    for (const double grey : {0.0, 0.2, 1.0}) {
        const dvec3 rgb = srgb(d65(), constantCurve(grey));
        expectNear(rgb, dvec3(grey), 1e-12);
    }
}

TEST(Film, MatrixIsThatOfTheStandardWithOurWhite) {
    // IEC 61966-2-1 has four decimals and a white of four decimals, which moves single entries by up
    // to 4.5e-4.
    const glm::dmat3 standard{{0.4124, 0.2126, 0.0193}, {0.3576, 0.7152, 0.1192}, {0.1805, 0.0722, 0.9505}};
    const glm::dmat3 ours = xyzFromLinearSrgb();
    for (int column = 0; column < 3; ++column) expectNear(ours[column], standard[column], 5e-4);
    const glm::dmat3 product = linearSrgbFromXyz() * ours;
    for (int column = 0; column < 3; ++column) expectNear(product[column], glm::dmat3(1.0)[column], 1e-14);
}

TEST(Film, IlluminantEIsPink) {
    // With the 5 nm table and the rounded matrix of the standard: 1.20478, 0.94832, 0.90869 for Y = 1. Our
    // white and finer table change it by less than 5e-4.
    const dvec3 rgb = srgb(namedSpectrum("E").value(), kWhite);
    const double y = xyzPerWatt(namedSpectrum("E").value(), kWhite).y;
    expectNear(rgb / y, {1.20478, 0.94832, 0.90869}, 5e-4);
}

TEST(Film, LuminousEfficacyIsThatOfDaylight) {
    // 683.002 lm/W times sum of D65 ybar over sum of D65, from the 5 nm tables of CIE 15 as they are printed
    // for every 20 nm: a coarse sum by hand, to 1 %.
    const double d65_20nm[] = {49.98,  82.75,  93.43,  104.86, 117.81, 115.92, 109.35,
                               104.79, 104.41, 100.00, 95.79,  90.01,  87.70,  83.70,
                               80.21,  78.28,  71.61,  61.60,  75.09,  46.42,  63.38};
    const double ybar_20nm[] = {0.0000, 0.0004, 0.0040, 0.0230, 0.0600, 0.1390, 0.3230,
                                0.7100, 0.9540, 0.9950, 0.8700, 0.6310, 0.3810, 0.1750,
                                0.0610, 0.0170, 0.0041, 0.0010, 0.0002, 0.0001, 0.0000};
    double light = 0.0;
    double power = 0.0;
    for (std::size_t i = 0; i < std::size(ybar_20nm); ++i) {
        light += d65_20nm[i] * ybar_20nm[i];
        power += d65_20nm[i] * (i == 0 || i + 1 == std::size(ybar_20nm) ? 0.5 : 1.0);
    }
    EXPECT_NEAR(luminousEfficacyOfD65(), 683.002 * light / power, 0.01 * luminousEfficacyOfD65());
    // A monochromatic watt at 555 nm has 683.002 lm.
    const dvec3 green = xyzPerWatt(laser(555.0 * units::nm, {}), kWhite);
    EXPECT_NEAR(green.y * luminousEfficacyOfD65(), 683.002, 1e-9);
}

TEST(XyzPerWatt, IsTheIntegralOverSpectrumAndReflectance) {
    const Curve paint{{390.3, 0.2}, {455.5, 0.9}, {520.0, 0.1}, {611.1, 0.4}, {770.0, 0.8}};
    const Spectrum light = normalised({{{350.0, 1.0}, {500.7, 3.0}, {640.0, 0.5}, {900.0, 2.0}},
                                       {{500.0 * units::nm, 80.0, 0.7 * units::nm},
                                        {612.0 * units::nm, 50.0, 12.0 * units::nm},
                                        {770.0 * units::nm, 9.0, 2.0 * units::nm}}});
    const double scale = bruteForce(d65(), kWhite).y;
    expectNear(xyzPerWatt(light, paint), bruteForce(light, paint) / scale, 1e-6);
}

TEST(XyzPerWatt, OfALineIsTheMatchingFunctions) {
    const double scale = luminousEfficacyOfD65() / 683.002;
    const Curve ramp{{380.0, 0.0}, {780.0, 1.0}};
    expectNear(xyzPerWatt(laser(589.25 * units::nm, {}), ramp),
               colorMatching(589.25) * (209.25 / 400.0) / scale, 1e-12);
    // A line narrower than the table's step, between two of its wavelengths, is the same within a straight
    // piece.
    expectNear(xyzPerWatt(laser(589.5 * units::nm, 1e-3 * units::nm), kWhite),
               xyzPerWatt(laser(589.5 * units::nm, {}), kWhite), 1e-8);
}

TEST(XyzPerWatt, OfFilteredLightIsThatOfTheFilteredSurface) {
    const Curve red = reflectanceCurve({0.9, 0.1, 0.05});
    const Spectrum lamp = namedSpectrum("F11").value();
    expectNear(xyzPerWatt(filtered(lamp, red), kWhite), xyzPerWatt(lamp, red), 3e-6);
    const Spectrum line = laser(600.0 * units::nm, {});
    expectNear(xyzPerWatt(filtered(line, red), kWhite), xyzPerWatt(line, red), 1e-12);
}

TEST(Reflectance, HasItsColourUnderD65) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 50; ++i) {
        const dvec3 rgb(unit(random), unit(random), unit(random));
        expectNear(srgb(d65(), reflectanceCurve(rgb)), rgb, 1e-7);  // the table has nine decimals
    }
    for (const dvec3 rgb : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), dvec3(1, 1, 0)})
        expectNear(srgb(d65(), reflectanceCurve(rgb)), rgb, 1e-7);
}

TEST(Reflectance, OfGreyIsConstant) {
    for (const double grey : {0.0, 0.1, 0.73, 1.0}) {
        const Curve curve = reflectanceCurve(dvec3(grey));
        EXPECT_TRUE(isConstant(curve));
        EXPECT_EQ(valueAt(curve, 512.3), grey);
    }
    EXPECT_FALSE(isConstant(reflectanceCurve({0.5, 0.5, 0.6})));
}

TEST(Reflectance, IsLinearAndConservesEnergy) {
    const Curve red = reflectanceCurve({1, 0, 0});
    const Curve green = reflectanceCurve({0, 1, 0});
    const Curve blue = reflectanceCurve({0, 0, 1});
    const Curve mixed = reflectanceCurve({0.8, 0.3, 0.45});
    ASSERT_EQ(red.front().wavelength_nm, kShortestVisible_nm);
    ASSERT_EQ(red.back().wavelength_nm, kLongestVisible_nm);
    for (double l_nm = 380.0; l_nm <= 780.0; l_nm += 0.7) {
        const double r = valueAt(red, l_nm);
        const double g = valueAt(green, l_nm);
        const double b = valueAt(blue, l_nm);
        for (const double value : {r, g, b}) {
            EXPECT_GE(value, 0.0) << l_nm;
            EXPECT_LE(value, 1.0) << l_nm;
        }
        EXPECT_NEAR(r + g + b, 1.0, 1e-14) << l_nm;
        EXPECT_NEAR(valueAt(mixed, l_nm), 0.8 * r + 0.3 * g + 0.45 * b, 1e-14) << l_nm;
        EXPECT_GE(valueAt(mixed, l_nm), 0.3 - 1e-14) << l_nm;
        EXPECT_LE(valueAt(mixed, l_nm), 0.8 + 1e-14) << l_nm;
    }
}

TEST(Reflectance, IsSmooth) {
    // The least sum of squared differences that is possible is 0.3729 (docs/spectral_primaries.py); three box
    // functions would have 4.
    double roughness = 0.0;
    for (const dvec3 rgb : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)}) {
        const Curve curve = reflectanceCurve(rgb);
        for (std::size_t i = 1; i < curve.size(); ++i)
            roughness += std::pow(curve[i].value - curve[i - 1].value, 2.0);
    }
    EXPECT_LT(roughness, 0.373);
}

}  // namespace
}  // namespace fringe::optics
