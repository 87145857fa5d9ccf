// Spectra as sums, and the film's scale against published figures.
#include "oracle/spectral.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace fringe::oracle {
namespace {

using namespace units;

double power(const std::vector<SpectralSample>& samples) {
    double sum = 0.0;
    for (const SpectralSample& sample : samples) sum += sample.power;
    return sum;
}

TEST(Spectral, CurvesAreLinearBetweenTheirKnots) {
    const optics::Curve curve{{400.0, 1.0}, {500.0, 3.0}, {510.0, 0.0}};
    EXPECT_DOUBLE_EQ(curveAt(curve, 400.0), 1.0);
    EXPECT_DOUBLE_EQ(curveAt(curve, 425.0), 1.5);
    EXPECT_DOUBLE_EQ(curveAt(curve, 507.5), 0.75);
    EXPECT_EQ(curveAt(curve, 399.9), 0.0);
    EXPECT_EQ(curveAt(curve, 510.1), 0.0);
    EXPECT_EQ(curveAt({}, 500.0), 0.0);
}

TEST(Spectral, SamplesAddUpToThePower) {
    EXPECT_NEAR(power(sampled({{{380.0, 0.002}, {780.0, 0.003}}, {}})), 1.0, 1e-13);
    EXPECT_DOUBLE_EQ(power(sampled({{}, {{589.0 * nm, 0.7, 0.0 * nm}, {800.0 * nm, 9.0, 0.0 * nm}}})), 0.7);
    // The tails beyond four standard deviations hold 6.3e-5.
    EXPECT_NEAR(power(sampled({{}, {{589.0 * nm, 0.7, 2.0 * nm}}})), 0.7, 0.7 * 7e-5);
    // Half of a line at the end of the visible range is visible.
    EXPECT_NEAR(power(sampled({{}, {{780.0 * nm, 1.0, 2.0 * nm}}})), 0.5, 7e-5);
}

TEST(Spectral, ALineIsAGaussianOfItsFullWidthAtHalfMaximum) {
    double half = 0.0;
    double variance = 0.0;
    for (const SpectralSample& sample : sampled({{}, {{500.0 * nm, 1.0, 4.0 * nm}}}, 400, 4000)) {
        const double off_nm = sample.wavelength_nm - 500.0;
        if (std::abs(off_nm) < 2.0) half += sample.power;
        variance += sample.power * off_nm * off_nm;
    }
    EXPECT_NEAR(half, std::erf(std::sqrt(std::log(2.0))), 1e-3) << "between the points of half the maximum";
    EXPECT_NEAR(variance, 16.0 / (8.0 * std::log(2.0)), 4e-3);  // tails beyond four deviations: 1.1e-3 of it
}

// CIE 15: chromaticity of D65, x 0.31272, y 0.32903 from the tables of 5 nm.
TEST(Spectral, DaylightIsWhite) {
    Xyz white(0.0);
    for (const SpectralSample& sample : sampled(d65()))
        white += sample.power * filmResponse(sample.wavelength_nm);
    EXPECT_NEAR(white.y, 1.0, 1e-14);
    EXPECT_NEAR(white.x / (white.x + white.y + white.z), 0.31272, 5e-5);
    EXPECT_NEAR(white.y / (white.x + white.y + white.z), 0.32903, 5e-5);
    EXPECT_LT(glm::length(xyzFromRgb() * Rgb(1.0) - white), 1e-14);
}

// IEC 61966-2-1 prints four digits for its white, 0.3127 and 0.3290.
TEST(Spectral, PrimariesAreThoseOfSrgb) {
    const glm::dmat3 published =
        glm::transpose(glm::dmat3(0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505));
    for (int i = 0; i < 3; ++i) EXPECT_LT(glm::length(xyzFromRgb()[i] - published[i]), 1e-3) << i;
}

}  // namespace
}  // namespace fringe::oracle
