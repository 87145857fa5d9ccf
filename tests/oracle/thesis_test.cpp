// The formulas of the thesis: worked values, zeros, maxima and the 0/0 of the listing.
#include "oracle/thesis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "oracle/axes.hpp"
#include "scenes.hpp"

namespace fringe::oracle {
namespace {

using namespace units;
using scene::Faults;
using scene::Rgb;
using scene::Slits;

TEST(ThesisIntensity, SingleSlitHasItsZeros) {
    const Slits slit{1, 3.0 * um, 3.0 * um};
    for (int channel = 0; channel < 3; ++channel) {
        for (int order = 1; order <= 4; ++order) {
            const double sine = order * kPrintedWavelengths[channel] / 3e-6;
            EXPECT_LT(limitIntensity(sine, slit)[channel], 1e-30);  // (a rounding of the phase / the phase)^2
        }
    }
}

TEST(ThesisIntensity, SlitArraysHaveTheirZerosBetweenTheOrders) {
    for (const unsigned count : {2U, 3U, 4U, 5U}) {
        const Slits slits{count, 1.0 * um, 2.0 * um};
        for (unsigned zero = 1; zero < 2 * count; ++zero) {
            if (zero % count == 0) continue;  // an order
            const double sine = zero * kPrintedWavelengths[1] / (count * 2e-6);
            EXPECT_LT(limitIntensity(sine, slits)[1], 1e-28) << count << " slits, zero " << zero;
        }
    }
}

// Slits nearly as wide as their period keep the first orders below the clamp.
TEST(ThesisIntensity, OrdersGrowWithTheSquareOfTheSlits) {
    for (int channel = 0; channel < 3; ++channel) {
        const double sine = kPrintedWavelengths[channel] / 2e-6;
        const double oneSlit = std::pow(std::sin(std::numbers::pi * 0.95) / (std::numbers::pi * 0.95), 2);
        for (const unsigned count : {1U, 2U, 5U, 15U}) {
            const Slits slits{count, 1.9 * um, 2.0 * um};
            EXPECT_NEAR(limitIntensity(sine, slits)[channel], count * count * oneSlit, 1e-13);
        }
    }
}

TEST(ThesisIntensity, IsTheFieldOfTheSlitsSquared) {
    const Slits slits{7, 0.6 * um, 8.3 * um};
    for (double sine = 0.013; sine < 1.0; sine += 0.0171) {
        const Rgb value = limitIntensity(sine, slits);
        for (int channel = 0; channel < 3; ++channel) {
            // Each slit integrated by the midpoint rule: 400 points give 1e-5 at up to 1.4 turns across a
            // slit.
            std::complex<double> field = 0.0;
            for (int slit = 0; slit < 7; ++slit) {
                for (int i = 0; i < 400; ++i) {
                    const double place = slit * 8.3e-6 + (i + 0.5) / 400.0 * 0.6e-6;
                    field += std::polar(1.0 / 400.0,
                                        2.0 * std::numbers::pi * place * sine / kPrintedWavelengths[channel]);
                }
            }
            EXPECT_NEAR(value[channel], std::min(std::norm(field), 1.0), 1e-4);
        }
    }
}

TEST(ThesisIntensity, EqualsThePrintedQuotientWhereThatIsFinite) {
    for (const unsigned count : {1U, 2U, 5U, 50U}) {
        const Slits slits{count, 1.0 * um, 2.0 * um};
        for (double sine = 0.01; sine < 1.0; sine += 0.00317) {
            const Rgb expected = printedIntensity(sine, slits);
            // The quotient loses digits where its divisor is small: 1e-10 allows for sin(xi/2) of about 1e-4.
            EXPECT_LT(glm::length(limitIntensity(sine, slits) - expected), 1e-10);
        }
    }
}

TEST(ThesisIntensity, StraightAheadIsTheLimitOrNaN) {
    for (const unsigned count : {1U, 2U, 5U}) {
        const Slits slits{count, 6.0 * um, 8.3 * um};
        EXPECT_EQ(limitIntensity(0.0, slits), Rgb(1.0));
        EXPECT_LT(glm::length(limitIntensity(1e-12, slits) - Rgb(1.0)), 1e-12);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_TRUE(std::isnan(printedIntensity(0.0, slits)[channel]));
        EXPECT_EQ(printedIntensity(1e-6, slits).r, count == 1 ? limitIntensity(1e-6, slits).r : 1.0);
    }
}

TEST(ThesisGrating, WorkedValue) {
    // An independent calculation in double precision, printed to eight digits.
    const Rgb value = gratingValue(gratingAt(dvec3(0.0), kZ, kY), {0.35, 0.05, 1.0});
    EXPECT_NEAR(value.r, 0.09150882, 5e-9);
    EXPECT_NEAR(value.g, 0.62566743, 5e-9);
    EXPECT_NEAR(value.b, 0.96, 5e-9);
    const Rgb printed = gratingValue(gratingAt(dvec3(0.0), kZ, kY, Faults::asPrinted), {0.35, 0.05, 1.0});
    EXPECT_LT(glm::length(printed - value), 1e-11);
}

TEST(ThesisGrating, StaysInItsBandAndInFrontOfItself) {
    scene::ThesisGrating grating = gratingAt(dvec3(0.0), kZ, kY);  // 0.5 m wide
    EXPECT_EQ(gratingValue(grating, {0.0, 0.0, -1.0}), Rgb(0.0));
    EXPECT_EQ(gratingValue(grating, {1.0, 0.0, 0.0}), Rgb(0.0));
    EXPECT_EQ(gratingValue(grating, {0.0, 0.0, 0.0}), Rgb(0.0));
    EXPECT_EQ(gratingValue(grating, {0.0, 0.2501, 1.0}), Rgb(0.0));
    EXPECT_EQ(gratingValue(grating, {0.0, 0.25, 1.0}), Rgb(0.0));    // the circle's edge
    EXPECT_EQ(gratingValue(grating, {0.0, 0.125, 1.0}), Rgb(0.75));  // 1 - (1/2)^2
    grating.attenuated = false;
    EXPECT_EQ(gratingValue(grating, {0.0, 0.25, 1.0}), Rgb(1.0));
    EXPECT_EQ(gratingValue(grating, {0.0, -0.25, 1.0}), Rgb(1.0));
}

// The deviation is taken in the plane across the slits: a point higher up on the wall has the same pattern.
TEST(ThesisGrating, LooksAlikeAlongTheSlits) {
    scene::ThesisGrating grating = gratingAt(dvec3(0.0), kZ, kY);
    grating.attenuated = false;
    const Rgb level = gratingValue(grating, {0.4, 0.0, 1.0});
    EXPECT_LT(glm::length(gratingValue(grating, {0.4, 0.2, 1.0}) - level), 1e-12);
    EXPECT_LT(glm::length(gratingValue(grating, {-0.4, -0.2, 1.0}) - level), 1e-12);
    EXPECT_LT(glm::length(gratingValue(grating, {0.8, 0.0, 2.0}) - level), 1e-12) << "no fall-off";
}

TEST(ThesisGrating, StraightAheadIsNaNAsPrinted) {
    EXPECT_EQ(gratingValue(gratingAt(dvec3(0.0), kZ, kY), {0.0, 0.0, 1.0}), Rgb(1.0));
    const Rgb printed = gratingValue(gratingAt(dvec3(0.0), kZ, kY, Faults::asPrinted), {0.0, 0.0, 1.0});
    EXPECT_TRUE(std::isnan(printed.r) && std::isnan(printed.g) && std::isnan(printed.b));
}

TEST(ThesisDisc, DependsOnTheViewRaysRadialPart) {
    const scene::Disc disc{dvec3(0.0), kZ, 0.06, 0.0125};
    const scene::ThesisDisc material{{4, 6.0 * um, 8.3 * um}, 0.6, Faults::limit};
    const dvec3 view = glm::normalize(dvec3(0.1, 0.2, -1.0));
    // On the x axis the radial part is x: the listing's plane holds x and z alone.
    const Rgb expected = limitIntensity(0.1 / std::hypot(0.1, 1.0), material.slits);
    EXPECT_LT(glm::length(discPattern(material, disc, {0.04, 0.0, 0.0}, view) - expected), 1e-11);
    EXPECT_LT(glm::length(discPattern(material, disc, {-0.02, 0.0, 0.0}, view) - expected), 1e-11);
    // Where the view ray has no radial part lies the main maximum, and the string of artifacts.
    const dvec3 across(0.02, 0.0, 0.0);
    EXPECT_EQ(discPattern(material, disc, across, {0.0, 0.6, -0.8}), Rgb(1.0));
    scene::ThesisDisc printed = material;
    printed.faults = Faults::asPrinted;
    EXPECT_TRUE(std::isnan(discPattern(printed, disc, across, {0.0, 0.0, -1.0}).r));
    EXPECT_TRUE(std::isnan(discPattern(printed, disc, dvec3(0.0), view).r));
    EXPECT_EQ(discPattern(material, disc, dvec3(0.0), view), Rgb(1.0));
}

}  // namespace
}  // namespace fringe::oracle
