// Special functions against quadrature of what defines them, and against published values.
#include "optics/integrals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fringe::optics {
namespace {

using std::numbers::pi;

// Composite Gauss quadrature; 20 points for each panel of at most `panel`.
template <class Integrand>
auto integral(Integrand integrand, double from, double to, double panel) {
    const GaussRule rule = gaussLegendre(20);
    const int panels = static_cast<int>((to - from) / panel) + 1;
    const double half = 0.5 * (to - from) / panels;
    decltype(integrand(from)) sum = 0.0;
    for (int i = 0; i < panels; ++i)
        for (std::size_t node = 0; node < rule.nodes.size(); ++node)
            sum += half * rule.weights[node] * integrand(from + (2.0 * i + 1.0 + rule.nodes[node]) * half);
    return sum;
}

TEST(Integrals, GaussRuleIsExactForPolynomialsOfTwiceItsDegree) {
    for (const int points : {1, 2, 5, 12, 20}) {
        const GaussRule rule = gaussLegendre(points);
        for (int degree = 0; degree < 2 * points; ++degree) {
            double sum = 0.0;
            for (std::size_t i = 0; i < rule.nodes.size(); ++i)
                sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
            EXPECT_NEAR(sum, degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0, 1e-14) << points << ' ' << degree;
        }
    }
}

// M. Abramowitz, I. Stegun, "Handbook of Mathematical Functions", tables 5.1 and 5.3.
TEST(Integrals, SineIntegralIsAsPublished) {
    EXPECT_NEAR(sineIntegral(1.0), 0.9460830704, 5e-11);
    EXPECT_NEAR(sineIntegral(5.0), 1.5499312449, 5e-11);
    EXPECT_NEAR(sineIntegral(10.0), 1.6583475942, 5e-11);
    EXPECT_EQ(sineIntegral(0.0), 0.0);
    EXPECT_EQ(sineIntegral(-3.0), -sineIntegral(3.0));
}

TEST(Integrals, SineIntegralIsThatOfTheSine) {
    // On both sides of where the methods change, and far out.
    for (const double x : {0.5, 3.999, 4.0, 4.001, 7.0, 35.999, 36.001, 300.0}) {
        const double expected = integral([](double t) { return sinc(t / pi); }, 0.0, x, 1.0);
        EXPECT_NEAR(sineIntegral(x), expected, 1e-13) << x;  // a few hundred panels' roundings
    }
}

// f and g are Laplace transforms (DLMF 6.7.13-14); so are their rests: x^3 f/2 and the like. Written out,
// first = x^2 times the integral of exp(-xt) t^2/(1 + t^2), second = x^2 times that of exp(-xt) t^3/(1 +
// t^2).
TEST(Integrals, AuxiliaryRestsAreLaplaceTransforms) {
    for (const double x : {0.3, 2.0, 3.999, 4.001, 9.0, 35.99, 36.01, 500.0}) {
        const auto transformed = [&](int power) {
            return x * x *
                   integral([&](double t) { return std::exp(-x * t) * std::pow(t, power) / (1.0 + t * t); },
                            0.0, 45.0 / x, 0.5 / std::max(x, 1.0));
        };
        const AuxiliaryRests rests = auxiliaryRests(x);
        EXPECT_NEAR(rests.first, transformed(2), 2e-13)
            << x;  // x < 36: roundings of 1, times x^2/6 of the sum
        EXPECT_NEAR(rests.second, transformed(3), 2e-13) << x;
    }
}

TEST(Integrals, FresnelIntegralsAreThoseOfTheirPhase) {
    for (const double x : {0.1, 1.0, 1.599, 1.6, 1.601, 2.5, 5.0, 20.0}) {
        const auto expected =
            integral([](double t) { return std::polar(1.0, 0.5 * pi * t * t); }, 0.0, x, 0.05);
        EXPECT_LT(std::abs(fresnelIntegrals(x) - expected), 1e-12) << x;
        EXPECT_EQ(fresnelIntegrals(-x), -fresnelIntegrals(x));
    }
    // Abramowitz & Stegun, table 7.7.
    EXPECT_NEAR(fresnelIntegrals(1.0).real(), 0.7798934, 5e-8);
    EXPECT_NEAR(fresnelIntegrals(1.0).imag(), 0.4382591, 5e-8);
    // 1/2 + 1/(pi x) exp(i pi (x^2 - 1)/2), first term of the asymptotic series; the next is 1/(pi^2 x^3).
    const double far = 1e4 + 0.3;
    const auto asymptotic = std::complex<double>(0.5, 0.5) +
                            std::polar(1.0 / (pi * far), 0.5 * pi * std::fmod(far * far - 1.0, 4.0));
    EXPECT_LT(std::abs(fresnelIntegrals(far) - asymptotic), 1e-12);
}

TEST(Integrals, CentralShareIsTheIntegralOfSincSquared) {
    for (const double x : {0.01, 0.5, 1.0, 6.2, 40.0}) {
        const double expected = 2.0 * integral([](double t) { return sinc(t) * sinc(t); }, 0.0, x, 0.5);
        EXPECT_NEAR(centralShare(x), expected, 1e-13) << x;
    }
    EXPECT_NEAR(centralShare(1e6), 1.0 - 1e-6 / (pi * pi), 1e-13);
}

TEST(Integrals, ArrayFactorIsTheSumOfItsPhasors) {
    for (const int count : {1, 2, 3, 4, 50}) {
        for (const double t : {0.0, 1.0, -3.0, 0.13, 0.4999, 1.0 + 1e-9, -2.0 - 1e-4, 7.5}) {
            std::complex<long double> sum = 0.0L;
            for (int i = 0; i < count; ++i) {
                const long double place = static_cast<long double>(i) - 0.5L * (count - 1);
                sum += std::polar(1.0L, 2.0L * std::numbers::pi_v<long double> * place * t);
            }
            EXPECT_NEAR(arrayFactor(count, t), static_cast<double>(sum.real()), 1e-13 * count * count);
        }
    }
}

}  // namespace
}  // namespace fringe::optics
