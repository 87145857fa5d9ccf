// Slits on the device, up to 10^6 of them, against sums over the slits in long double at the very floats that
// the device got.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "probes/probe.hpp"

namespace fringe::testing {
namespace {

using Long = long double;
using Phasor = std::complex<Long>;

Phasor phasor(Long turns) {
    return std::polar<Long>(1.0L, 2.0L * std::numbers::pi_v<Long> * (turns - std::nearbyint(turns)));
}

// Sum of exp(2 pi i k t) over `count` slits, one by one.
Phasor oneByOne(std::uint32_t count, Long t) {
    Phasor sum = 0.0L, step = phasor(t), now = 1.0L;
    for (std::uint32_t k = 0; k < count; ++k) {
        sum += now;
        now *= step;
    }
    return sum;
}

// The same by halves: a sum over 2n slits is one over n and the same again, n slits on.
Phasor byHalves(std::uint32_t count, Long t) {
    if (count == 1) return 1.0L;
    const std::uint32_t half = count / 2;
    const Phasor sum = byHalves(half, t) * (1.0L + phasor(half * t));
    return count % 2 == 0 ? sum : sum + phasor((count - 1) * t);
}

// |sum|^2/count^2 at the number of turns that the device's own numbers make.
double expectedArray(std::uint32_t count, float u, TwoFloats period) {
    const Long t = Long{u} * (Long{period.high} + Long{period.low});
    const Phasor sum = count <= 1000 ? oneByOne(count, t) : byHalves(count, t);
    return static_cast<double>(std::norm(sum) / (Long(count) * Long(count)));
}

double expectedSlit(float u, float width) {
    const Long x = std::numbers::pi_v<Long> * Long{u} * Long{width};
    const Long amplitude = std::abs(x) < 1e-9L ? 1.0L : std::sin(x) / x;
    return static_cast<double>(amplitude * amplitude);
}

// Half within 3/count of an order, some at the floats next to one; the rest anywhere from grazing to grazing.
std::vector<glm::vec2> directionsFor(std::uint32_t count, double period) {
    std::mt19937 random(count);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<glm::vec2> directions{{0, 0},      {-0.0F, 0}, {1e-38F, 0}, {-1e-30F, 0},
                                      {1e-12F, 0}, {2.0F, 0},  {-2.0F, 0}};
    const double orders = std::floor(2.0 * period);
    for (double order = -orders; order <= orders; ++order)
        directions.emplace_back(static_cast<float>(order / period), 0.0F);
    while (directions.size() < 10'000) {
        const double order = std::nearbyint(orders * uniform(random));
        directions.emplace_back(static_cast<float>((order + 3.0 * uniform(random) / count) / period), 0.0F);
        directions.emplace_back(static_cast<float>(2.0 * uniform(random)), 0.0F);
    }
    return directions;
}

TEST(SlitsReference, SumsOfTheReferenceAgree) {
    for (const std::uint32_t count : {2U, 7U, 1000U, 1023U})
        for (const Long t : {0.0L, 0.3L, 2.0L + 1e-6L, 1.499L})
            EXPECT_LT(std::abs(oneByOne(count, t) - byHalves(count, t)), 1e-14L * count * count);
}

// What the two-float product rests on: no contraction, no reordering, no fused multiplication.
TEST(PhaseOnDevice, RoundingErrorOfAProductIsExact) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(-1.0F, 1.0F);
    std::vector<glm::vec2> factors;
    for (int i = 0; i < 10'000; ++i)
        factors.emplace_back(std::ldexp(uniform(random), i % 20 - 10), std::ldexp(uniform(random), i % 17));
    const float unused = 0.0F;
    const std::vector<float> errors = evaluate(Probe::productError, {&unused, 1}, factors);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const double exact = double{factors[i].x} * double{factors[i].y};
        const float product = factors[i].x * factors[i].y;
        ASSERT_EQ(errors[i], exact - double{product}) << factors[i].x << ' ' << factors[i].y;
    }
}

class SlitsOnDevice : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(SlitsOnDevice, AreTheSumOfTheirWaves) {
    const std::uint32_t count = GetParam();
    for (const double wavelength_um : {0.38, 0.55, 0.6328, 0.78}) {
        for (const double period_um : {0.5, 1.6, 2.0, 40.0}) {
            const TwoFloats period = split(period_um / wavelength_um);
            const auto width = static_cast<float>(0.4 * period_um / wavelength_um);
            const std::vector<glm::vec2> directions = directionsFor(count, period_um / wavelength_um);
            std::vector<double> expected;
            for (const glm::vec2& direction : directions)
                expected.push_back(expectedSlit(direction.x, width) *
                                   expectedArray(count, direction.x, period));
            const std::array parameters{width, period.high, period.low, static_cast<float>(count)};
            expectNear(evaluate(Probe::slits, parameters, directions), expected, directions, kSineBound);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Counts, SlitsOnDevice,
                         ::testing::Values(1U, 2U, 4U, 50U, 1000U, 10'000U, 1'000'000U),
                         ::testing::PrintToStringParamName());

}  // namespace
}  // namespace fringe::testing
