// Sections of beams against tables and against their sums of waves.
#include "oracle/section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/quadrature.hpp"

namespace fringe::oracle {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double kGreenWave = 550e-9;

// Enough panels for each to hold less than a turn.
Complex summed(double half, const Travel& travel, double radius) {
    Complex sum = 0.0;
    forNodes(-half, half, 20'000, [&](double y, double weight) {
        const double way =
            0.5 * travel.curvature * (y - travel.foot) * (y - travel.foot) - 0.5 * travel.convergence * y * y;
        sum += weight * std::exp(-y * y / (radius * radius)) * std::polar(1.0, 2.0 * pi * way / kGreenWave);
    });
    return sum;
}

TEST(GaussRule, IsExactForPolynomials) {
    double sum = 0.0;
    forNodes(0.0, 2.0, 1, [&](double x, double weight) { sum += weight * std::pow(x, 23); });
    EXPECT_NEAR(sum, std::pow(2.0, 24) / 24.0, 1e-8);  // 1e-14 of it
}

// M. Abramowitz, I. Stegun, "Handbook of Mathematical Functions", table 7.7.
TEST(FresnelIntegral, HasItsPublishedValues) {
    const auto expectAt = [](double w, double c, double s) {
        EXPECT_NEAR(fresnelIntegral(w).real(), c, 1e-7) << w;
        EXPECT_NEAR(fresnelIntegral(w).imag(), s, 1e-7) << w;
        EXPECT_EQ(fresnelIntegral(-w), -fresnelIntegral(w));
    };
    expectAt(0.5, 0.4923442, 0.0647324);
    expectAt(1.0, 0.7798934, 0.4382591);
    expectAt(2.0, 0.4882534, 0.3434157);
    expectAt(5.0, 0.5636312, 0.4991914);
}

TEST(FresnelIntegral, IsTheSumOfItsWaves) {
    for (const double w : {0.0, 0.001, 3.3, 7.999, 8.001, 12.0, 40.0}) {
        Complex sum = 0.0;
        forNodes(0.0, w, 2000,
                 [&](double t, double weight) { sum += weight * std::polar(1.0, 0.5 * pi * t * t); });
        EXPECT_LT(std::abs(fresnelIntegral(w) - sum), 1e-9) << w;
    }
}

// Parallel, focused beyond, on and before the point, and just beside the focus, where the formula changes.
TEST(Section, OfAnEvenBeam) {
    for (const double convergence : {0.0, 0.4, 0.9985, 0.9995, 1.0, 1.0015, 2.5}) {
        for (const double foot : {0.0, 0.7e-3, -1.1e-3, 5e-3}) {
            const Travel travel{foot, 1.0, convergence};
            const Complex expected = summed(1e-3, travel, 1e3);
            // 1e-9 of Fresnel's integral at a scale of up to 1 / 1.4e-2 m^-1 beside the focus.
            EXPECT_LT(std::abs(evenSection(1e-3, travel, kGreenWave) - expected), 5e-11)
                << convergence << ' ' << foot;
        }
    }
}

TEST(Section, OfAGaussianBeam) {
    for (const double convergence : {0.0, 0.4, 1.0, 2.5}) {
        for (const double foot : {0.0, 0.7e-3, 3e-3}) {
            const Travel travel{foot, 1.0, convergence};
            const Complex expected = summed(6e-3, travel, 1e-3);  // exp(-36) at its ends
            EXPECT_LT(std::abs(gaussianSection(1e-3, travel, kGreenWave) - expected), 1e-13)
                << convergence << ' ' << foot;
        }
    }
}

// The intensity behind slits as high as 2 half, narrow against a wavelength, from the Rayleigh-Sommerfeld
// integral of the first kind (J. Goodman, "Introduction to Fourier Optics", 3.5) with its own ways and
// obliquity; 1 behind endless ones.
double rayleighSommerfeld(double half, double y, double distance) {
    Complex sum = 0.0;
    forNodes(-half, half, 4000, [&](double from, double weight) {
        const double rise = y - from;
        const double range = std::hypot(rise, distance);
        const double longer = rise * rise / (range + distance);  // than `distance`, without cancellation
        sum += weight * distance / (range * range) * std::polar(1.0, 2.0 * pi * longer / kGreenWave);
    });
    return std::norm(sum) * distance / kGreenWave;
}

// What Fresnel's approximation costs the sections that judge the device, for beams of 2 to 10 mm at 0.5 to 2
// m: 1.4e-3 of the peak for 10 mm at 0.5 m, 2.3e-4 for 10 mm at 1 m, less elsewhere (docs/theory.md,
// "Scope"). The next term of the way is rise^4 / (8 distance^3), which grows with the fourth power of the one
// and the third of the other.
TEST(Section, IsTheRayleighSommerfeldIntegralOfABeamFarEnoughAway) {
    for (const double half : {1e-3, 2.5e-3, 5e-3}) {
        for (const double distance : {0.5, 1.0, 2.0}) {
            double largest = 0.0, peak = 0.0;
            for (double y = 0.0; y < 1.5 * half; y += half / 40.0) {
                const double exact = rayleighSommerfeld(half, y, distance);
                const double section = std::norm(evenSection(half, {y, 1.0 / distance, 0.0}, kGreenWave)) /
                                       (kGreenWave * distance);
                peak = std::max(peak, exact);
                largest = std::max(largest, std::abs(section - exact));
            }
            EXPECT_GT(peak, 1.0);
            EXPECT_LT(largest, (half > 4e-3 && distance < 1.0 ? 2e-3 : 3e-4) * peak)
                << half << ' ' << distance << ' ' << largest / peak;
        }
    }
}

}  // namespace
}  // namespace fringe::oracle
