// Reflection and refraction against their laws, and metals against their tables.
#include "oracle/fresnel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "oracle/axes.hpp"
#include "oracle/metals.hpp"

namespace fringe::oracle {
namespace {

using namespace units;
using scene::Metal;

TEST(Fresnel, NormalIncidence) {
    EXPECT_NEAR(reflectance(1.0, 1.5), 0.04, kRounding);
    EXPECT_NEAR(reflectance(1.0, 1.0 / 1.5), 0.04, kRounding);
    EXPECT_NEAR(reflectance(1.0, {0.5, 2.0}), (0.25 + 4.0) / (2.25 + 4.0), kRounding);
}

TEST(Fresnel, BrewsterAngleLeavesOnePolarisation) {
    for (const double n : {1.33, 1.5, 2.4}) {
        const double perpendicular = (n * n - 1.0) / (n * n + 1.0);
        EXPECT_NEAR(reflectance(std::cos(std::atan(n)), n), 0.5 * perpendicular * perpendicular, kRounding);
    }
}

TEST(Fresnel, GrazingLightIsAllReflected) {
    EXPECT_DOUBLE_EQ(reflectance(0.0, 1.5), 1.0);
    EXPECT_DOUBLE_EQ(reflectance(0.0, {0.2, 3.0}), 1.0);
}

TEST(Fresnel, TotalInternalReflectionBeginsAtTheCriticalAngle) {
    const double critical = std::asin(1.0 / 1.5);
    const dvec3 normal(0.0, 0.0, 1.0);
    const auto towards = [](double angle) { return dvec3(std::sin(angle), 0.0, -std::cos(angle)); };
    EXPECT_TRUE(refracted(towards(critical - 1e-6), normal, 1.0 / 1.5));
    EXPECT_FALSE(refracted(towards(critical + 1e-6), normal, 1.0 / 1.5));
    EXPECT_LT(reflectance(std::cos(critical - 1e-3), 1.0 / 1.5), 0.9);
    for (const double angle : {critical + 1e-6, 0.9, 1.2, 1.5}) {
        EXPECT_NEAR(reflectance(std::cos(angle), 1.0 / 1.5), 1.0, kRounding);
    }
}

TEST(Fresnel, ReflectedAndTransmittedPowerMakeOne) {
    const double n = 1.5;
    for (double angle = 0.0; angle < 1.57; angle += 0.05) {
        const double in = std::cos(angle);
        const double out = std::sqrt(1.0 - std::pow(std::sin(angle) / n, 2));
        const double perpendicular = 2.0 * in / (in + n * out);
        const double parallel = 2.0 * in / (n * in + out);
        const double transmitted = 0.5 * n * out / in * (perpendicular * perpendicular + parallel * parallel);
        EXPECT_NEAR(reflectance(in, n) + transmitted, 1.0, kRounding);
        EXPECT_NEAR(reflectance(out, 1.0 / n), reflectance(in, n), kRounding) << "the way back";
    }
}

// Born & Wolf 14.2 in real numbers: m cos' = a + i b with m the complex index.
double metalReflectance(double angle, std::complex<double> index) {
    const double squaredSine = std::pow(std::sin(angle), 2);
    const double p = index.real() * index.real() - index.imag() * index.imag() - squaredSine;
    const double root = std::hypot(p, 2.0 * index.real() * index.imag());
    const double a = std::sqrt(0.5 * (root + p));
    const double squaredB = 0.5 * (root - p);
    const double cosine = std::cos(angle);
    const double tangent = squaredSine / cosine;
    const double perpendicular = (std::pow(a - cosine, 2) + squaredB) / (std::pow(a + cosine, 2) + squaredB);
    return 0.5 * perpendicular *
           (1.0 + (std::pow(a - tangent, 2) + squaredB) / (std::pow(a + tangent, 2) + squaredB));
}

TEST(Fresnel, MetalsFollowTheEquationsInRealNumbers) {
    for (const Metal metal : {Metal::aluminium, Metal::silver, Metal::gold, Metal::copper}) {
        const std::complex<double> index = refractiveIndex(metal, 549.1 * nm);
        for (double angle = 0.0; angle < 1.57; angle += 0.1) {
            EXPECT_NEAR(reflectance(std::cos(angle), index), metalReflectance(angle, index), kRounding);
        }
    }
}

TEST(Refraction, KeepsSnellsLawAndUnitLength) {
    const dvec3 normal = glm::normalize(dvec3(0.1, -0.2, 1.0));
    for (const dvec3 toward : {dvec3(0.0, 0.0, -1.0), dvec3(0.5, 0.3, -0.8), dvec3(-0.9, 0.4, -0.1)}) {
        const dvec3 in = glm::normalize(toward);
        const std::optional<dvec3> out = refracted(in, normal, 1.5);
        ASSERT_TRUE(out);
        EXPECT_NEAR(glm::length(*out), 1.0, kRounding);
        EXPECT_LT(glm::length(glm::cross(in, normal) - 1.5 * glm::cross(*out, normal)), kRounding);
        EXPECT_LT(glm::dot(*out, normal), 0.0);
    }
}

TEST(Metals, TablesAreReadAsPublished) {
    const auto expectIndex = [](Metal metal, Length wavelength, double n, double k) {
        const std::complex<double> index = refractiveIndex(metal, wavelength);
        EXPECT_NEAR(index.real(), n, kRounding);
        EXPECT_NEAR(index.imag(), k, kRounding);
    };
    expectIndex(Metal::silver, 548.6 * nm, 0.06, 3.586);
    expectIndex(Metal::gold, 616.8 * nm, 0.21, 3.272);
    expectIndex(Metal::copper, 450.9 * nm, 1.24, 2.397);
    expectIndex(Metal::aluminium, 563.57 * nm, 1.0728, 6.7839);
    expectIndex(Metal::gold, 0.5 * (495.9 + 520.9) * nm, 0.83, 1.957);  // halfway between two points
    expectIndex(Metal::silver, 380.0 * nm, 0.07 - 0.02 * 12.1 / 13.6, 1.657 + 0.207 * 12.1 / 13.6);
    expectIndex(Metal::copper, 780.0 * nm, 0.24 + 0.02 * 24.0 / 65.1, 4.665 + 0.515 * 24.0 / 65.1);
}

// What handbooks give for clean mirrors, within their spread of a few percent.
TEST(Metals, ReflectLikeMirrorsOfTheirKind) {
    const auto at = [](Metal metal, Length wavelength) {
        return reflectance(1.0, refractiveIndex(metal, wavelength));
    };
    EXPECT_NEAR(at(Metal::aluminium, 550.0 * nm), 0.915, 0.01);
    EXPECT_NEAR(at(Metal::silver, 550.0 * nm), 0.98, 0.02);
    EXPECT_NEAR(at(Metal::gold, 550.0 * nm), 0.78, 0.04);
    EXPECT_NEAR(at(Metal::copper, 550.0 * nm), 0.60, 0.05);
    EXPECT_GT(at(Metal::gold, 650.0 * nm), 2.0 * at(Metal::gold, 450.0 * nm)) << "gold is yellow";
}

}  // namespace
}  // namespace fringe::oracle
