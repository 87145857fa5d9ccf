// What judges the shaders' patterns is judged here: closed forms in double against waves added up one by one.
#include "oracle/exact_pattern.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "oracle/opening.hpp"
#include "qualify/draw.hpp"

namespace fringe::oracle {
namespace {

using glm::dvec2;
using Long = long double;
using Phasor = std::complex<Long>;

Phasor phasor(Long turns) {
    return std::polar<Long>(1.0L, 2.0L * std::numbers::pi_v<Long> * (turns - std::nearbyint(turns)));
}

// Sum of the waves of `count` slits: one over 2n is one over n and the same again, n slits on.
Phasor waves(std::uint32_t count, Long turns) {
    if (count == 1) return 1.0L;
    const std::uint32_t half = count / 2;
    const Phasor sum = waves(half, turns) * (1.0L + phasor(half * turns));
    return count % 2 == 0 ? sum : sum + phasor((count - 1) * turns);
}

TEST(ExactPattern, SlitsAreTheSumOfTheirWaves) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        qualify::Draw draw(3, i);
        const auto count = static_cast<std::uint32_t>(draw.magnitude(1.0, 1e6));
        const double period = draw.magnitude(0.1, 300.0);
        const auto high = static_cast<float>(period);
        const auto low = static_cast<float>(period - double{high});
        const double order = std::nearbyint(draw.between(-2.0, 2.0) * period);
        const auto u = static_cast<float>(draw.oneIn(2) ? draw.between(-2.0, 2.0)
                                                        : (order + draw.between(-3.0, 3.0) / count) / period);
        const Long turns = Long{u} * (Long{high} + Long{low});
        const Long sum = std::norm(waves(count, turns)) / (Long(count) * Long(count));
        // 1e-16 turns times a million slits, and the slope of the peak.
        EXPECT_NEAR(arrayPattern(turnsPast(u, high, low), count), static_cast<double>(sum), 1e-9)
            << u << ' ' << count;
    }
    EXPECT_EQ(arrayPattern(0.0, 1e6), 1.0);
}

TEST(ExactPattern, SlitAndDiscAreIntegralsOverTheirAreas) {
    const OpeningShape disc = optics::CircularAperture{
        2.0 * units::m, 0.5 * units::m};  // metres for once: turns per metre are x / 2
    const Opening opening(disc, 8.0);
    const double area = openArea(disc);
    for (const double f : {0.0, 1e-9, 0.1, 0.61, 1.7, 5.3}) {
        EXPECT_NEAR(discPattern(2.0 * f, 0.25), std::norm(opening.amplitude(dvec2(f, 0.0)) / area), 1e-9)
            << f;
        const OpeningShape slit = optics::RectangularAperture{1.0 * units::m, 1.0 * units::m};
        EXPECT_NEAR(slitPattern(f), std::norm(Opening(slit, 8.0).amplitude(dvec2(f, 0.0))), 1e-9) << f;
    }
}

TEST(ExactPattern, PolygonIsTheIntegralOverItsArea) {
    const std::array corners{dvec2(1.0, -0.2), dvec2(0.4, 0.7), dvec2(-0.3, 0.3), dvec2(-0.9, 0.1),
                             dvec2(-0.2, -0.8)};
    const OpeningShape polygon = optics::PolygonalAperture{{corners.begin(), corners.end()}};
    const Opening opening(polygon, 20.0);
    const double area = openArea(polygon);
    for (const double size : {0.0, 1e-12, 1e-4, 0.005, 0.01, 0.02, 0.3, 2.0, 9.0}) {
        for (const double angle : {0.0, 0.4, 1.0, 2.2, 4.0}) {
            const dvec2 f = size * dvec2(std::cos(angle), std::sin(angle));
            EXPECT_NEAR(polygonPattern(corners, f), std::norm(opening.amplitude(f) / area), 1e-9)
                << size << ' ' << angle;
        }
    }
}

}  // namespace
}  // namespace fringe::oracle
