// The propagating share of slits, against published values, against quadrature over the directions, and
// against the orders of infinitely many.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "optics/energy.hpp"
#include "optics/integrals.hpp"
#include "optics/orders.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {
namespace {

using namespace units;

// Integral over the directions of a plane, alpha = sin(theta), with as many Gauss panels as ripples.
double byQuadrature(const Slits& slits, double wavelength, double alphaIn) {
    static const GaussRule rule = gaussLegendre(8);
    const double extent = slits.count * (slits.period / m) + slits.width / m;
    const int panels = static_cast<int>(2.0 * extent / wavelength) + 8;
    double sum = 0.0;
    for (int panel = 0; panel < panels; ++panel) {
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double alpha = (2.0 * panel + 1.0 + rule.nodes[i]) / panels - 1.0;
            sum +=
                rule.weights[i] / panels * std::norm(transform(slits, {(alpha - alphaIn) / wavelength, 0.0}));
        }
    }
    return sum / (wavelength * area(slits));
}

double allOrders(const Slits& slits, double wavelength, double alphaIn, double betaIn) {
    const double fill = slits.width / slits.period;
    double sum = 0.0;
    for (int order = -1000; order <= 1000; ++order)
        if (propagates(alphaIn + order * wavelength / (slits.period / m), betaIn))
            sum += orderEfficiency(fill, order);
    return sum / fill;
}

struct Row {
    double width_um, period_um, wavelength_nm;
    double shares[5];  // 1, 2, 5, 50, 1000 slits
    double infinite;
};

// Worked with an independent program in double precision.
constexpr Row kTable[] = {
    {1, 2, 450, {.951357, .950952, .950509, .950338, .950317}, .950316},
    {1, 2, 550, {.948859, .949192, .949918, .950280, .950315}, .950316},
    {1, 2, 700, {.924452, .917546, .908310, .905653, .905303}, .905285},
    {.8, 1.6, 450, {.947966, .949035, .949893, .950270, .950314}, .950316},
    {.8, 1.6, 550, {.926899, .921801, .911938, .905842, .905313}, .905285},
    {.5, 1.6, 550, {.902255, .901303, .899897, .899237, .899180}, .899177},
    {.25, .5, 450, {.813836, .828822, .880997, .902968, .905168}, .905285},
    {.25, .5, 550, {.733454, .673295, .567575, .505680, .500286}, .500000},
    {.25, .5, 650, {.657987, .560013, .522296, .501922, .500096}, .500000},
    {4, 8, 550, {.985766, .985621, .985588, .985553, .985550}, .985550},
};

TEST(SlitShare, WorkedValues) {
    constexpr std::uint32_t kCounts[] = {1, 2, 5, 50, 1000};
    constexpr double kDigits = 5.1e-7;
    for (const Row& row : kTable) {
        Slits slits{1, row.width_um * um, row.period_um * um};
        for (std::size_t i = 0; i < 5; ++i) {
            slits.count = kCounts[i];
            EXPECT_NEAR(propagatingShare(slits, row.wavelength_nm * nm, 0, 0), row.shares[i], kDigits)
                << row.width_um << ' ' << row.wavelength_nm << ' ' << slits.count;
        }
        EXPECT_NEAR(allOrders(slits, row.wavelength_nm * 1e-9, 0, 0), row.infinite, kDigits);
    }
    constexpr double kSingle[][2] = {{.25, .4674}, {.5, .7737}, {1, .9028}, {2, .9499}, {10, .9899}};
    for (const auto& [waves, share] : kSingle)
        EXPECT_NEAR(propagatingShare(Slits{1, waves * 500 * nm, 1 * mm}, 500 * nm, 0, 0), share, 5.1e-5);
    EXPECT_NEAR(propagatingShare(Slits{3, 0.7 * um, 1.5 * um}, 600 * nm, 0, 0), 0.902130415650, 5e-13);
    constexpr double kOblique[][2] = {{0, .9058}, {.2, .9278}, {.5, .9276}, {.8, .7333}};
    for (const auto& [alpha, share] : kOblique)
        EXPECT_NEAR(propagatingShare(Slits{50, 0.8 * um, 1.6 * um}, 550 * nm, alpha, 0), share, 5.1e-5);
}

// Parseval on the half circle of directions, for oblique light too; slits side by side without bars between
// (their sum is one wide slit) are the limit of the formula.
TEST(SlitShare, IsTheIntegralOverTheDirections) {
    for (const Slits& slits :
         {Slits{1, 0.1 * um, 1 * um}, Slits{1, 30 * um, 40 * um}, Slits{2, 0.2 * um, 0.3 * um},
          Slits{7, 1 * um, 1 * um}, Slits{50, 0.5 * um, 1.6 * um}, Slits{400, 1 * um, 9 * um}}) {
        for (const double alpha : {0.0, 0.3, -0.95}) {
            const double share = propagatingShare(slits, 550 * nm, alpha, 0.0);
            EXPECT_NEAR(share, byQuadrature(slits, 550e-9, alpha), 1e-10) << slits.count << ' ' << alpha;
        }
    }
    EXPECT_NEAR(propagatingShare(Slits{7, 1 * um, 1 * um}, 550 * nm, 0.2, 0),
                propagatingShare(Slits{1, 7 * um, 7 * um}, 550 * nm, 0.2, 0), 1e-12);
}

// Beta is conserved: the directions form a cone, gamma^2 + alpha^2 = 1 - beta^2, and dP = |A|^2
// dalpha/wavelength.
TEST(SlitShare, ConicalLight) {
    static const GaussRule rule = gaussLegendre(12);
    const Slits slits{6, 1 * um, 2 * um};
    for (const double beta : {0.3, -0.8}) {
        const double alphaIn = 0.25, last = std::sqrt(1.0 - beta * beta);
        constexpr int kPanels = 100;
        double sum = 0.0;
        for (int panel = 0; panel < kPanels; ++panel) {
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const double alpha = last * ((2.0 * panel + 1.0 + rule.nodes[i]) / kPanels - 1.0);
                sum += rule.weights[i] * last / kPanels *
                       std::norm(transform(slits, {(alpha - alphaIn) / 600e-9, 0.0}));
            }
        }
        EXPECT_NEAR(propagatingShare(slits, 600 * nm, alphaIn, beta), sum / (600e-9 * area(slits)), 1e-12);
    }
}

// Past 10^4 slits the sum is extrapolated; here 10^5 are integrated.
TEST(SlitShare, OfVeryManySlits) {
    for (const double wavelength : {450e-9, 550e-9}) {
        const Slits slits{100'000, 0.25 * um, 0.5 * um};
        EXPECT_NEAR(propagatingShare(slits, wavelength * m, 0.13, 0), byQuadrature(slits, wavelength, 0.13),
                    2e-8);
    }
    // At the very wavelength at which two orders leave, and next to it.
    for (const double wavelength : {500e-9, 500.002e-9, 499.9e-9}) {
        const Slits slits{50'000, 0.25 * um, 0.5 * um};
        EXPECT_NEAR(propagatingShare(slits, wavelength * m, 0.0, 0), byQuadrature(slits, wavelength, 0.0),
                    2e-6);
    }
    const Slits many{1'000'000, 0.5 * um, 1.6 * um};
    EXPECT_NEAR(propagatingShare(many, 550 * nm, 0.2, 0.3), allOrders(many, 550e-9, 0.2, 0.3), 1e-6);
}

TEST(SlitShare, OfLightThatGrazes) {
    const Slits slits{5, 1 * um, 2 * um};
    // Half of the pattern has gone: what is left on this side is that of half the wavelength.
    const double half = 0.5 * propagatingShare(slits, 275 * nm, 0, 0);
    EXPECT_NEAR(propagatingShare(slits, 550 * nm, 1.0 - 1e-13, 0), half, 1e-6);
}

TEST(Orders, OfAnAmplitudeGratingTakeWhatIsOpen) {
    for (const double fill : {0.1, 0.5, 0.3125, 1.0}) {
        double sum = 0.0;
        for (int order = -20'000; order <= 20'000; ++order) sum += orderEfficiency(fill, order);
        EXPECT_NEAR(sum, fill, 1e-5);  // what is left beyond: 1/(pi^2 20000)
    }
    EXPECT_DOUBLE_EQ(orderEfficiency(0.5, 0), 0.25);
    EXPECT_NEAR(orderEfficiency(0.5, 1), 1.0 / (std::numbers::pi * std::numbers::pi), 1e-16);
    EXPECT_NEAR(orderEfficiency(0.5, -2), 0.0, 1e-32);
    EXPECT_TRUE(propagates(0.6, 0.79));
    EXPECT_FALSE(propagates(0.6, 0.8));
}

}  // namespace
}  // namespace fringe::optics
