// The propagating share of openings in two dimensions: worked values, and Parseval's theorem on the
// hemisphere by quadrature that shares nothing with the closed forms but the transform.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "optics/energy.hpp"
#include "optics/integrals.hpp"
#include "optics/shapes.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {
namespace {

using namespace units;
using std::numbers::pi;

// Over alpha and beta in polar angles of the hemisphere: sine = sin(theta), so that nothing is singular at
// its rim.
double byQuadrature(const Aperture& aperture, double wavelength, double alphaIn, double betaIn, int panels) {
    static const GaussRule rule = gaussLegendre(10);
    const int around = 24 * panels;
    double sum = 0.0;
    for (int panel = 0; panel < panels; ++panel) {
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double theta = 0.25 * pi * (2.0 * panel + 1.0 + rule.nodes[i]) / panels;
            const double weight = 0.25 * pi / panels * rule.weights[i] * std::sin(theta) * std::cos(theta);
            for (int j = 0; j < around; ++j) {
                const double phi = 2.0 * pi * j / around;
                const double alpha = std::sin(theta) * std::cos(phi), beta = std::sin(theta) * std::sin(phi);
                sum += weight * 2.0 * pi / around *
                       std::norm(transform(aperture,
                                           {(alpha - alphaIn) / wavelength, (beta - betaIn) / wavelength}));
            }
        }
    }
    return sum / (wavelength * wavelength * area(aperture));
}

constexpr double kStated = 1e-6;  // energy.hpp

void expectParseval(const Aperture& aperture, double wavelength, int panels) {
    for (const auto& [alpha, beta] : {std::pair{0.0, 0.0}, {0.3, 0.2}, {-0.1, 0.85}}) {
        EXPECT_NEAR(propagatingShare(aperture, wavelength * m, alpha, beta),
                    byQuadrature(aperture, wavelength, alpha, beta, panels), kStated)
            << alpha << ' ' << beta;
    }
}

TEST(Share, WorkedValues) {
    constexpr double kTable[][3] = {
        // diameter in um; circle; hexagon with its vertices on the circle
        {0.5, .80425, .76509},
        {1.0, .89178, .86414},
        {2.0, .94259, .93439},
        {5.0, .97804, .97466},
    };
    for (const auto& [diameter, circle, hexagon] : kTable) {
        EXPECT_NEAR(propagatingShare(CircularAperture{diameter * um, 0 * um}, 550 * nm, 0, 0), circle,
                    5.1e-6);
        EXPECT_NEAR(propagatingShare(regularPolygon(6, 0.5e-6 * diameter), 550 * nm, 0, 0), hexagon, 5.1e-6);
    }
}

TEST(Share, OfCirclesAndRings) {
    for (const double inner_um : {0.0, 0.1, 2.0, 3.9}) {
        expectParseval(CircularAperture{4 * um, inner_um * um}, 550e-9, 12);
        expectParseval(CircularAperture{0.2 * um, 0.05 * inner_um * um}, 550e-9, 8);
    }
}

TEST(Share, OfPolygons) {
    expectParseval(RectangularAperture{0.3 * um, 1 * um}, 550e-9, 8);
    expectParseval(RectangularAperture{1 * um, 6 * um}, 550e-9, 14);
    expectParseval(regularPolygon(3, 1e-6), 550e-9, 10);
    expectParseval(regularPolygon(6, 3e-6), 550e-9, 14);
    expectParseval(ell(), 550e-9, 14);
    expectParseval(regularPolygon(40, 1e-6), 550e-9, 8);  // more vertices than the closed form takes
}

// A side of a very long rectangle is that of a slit.
TEST(Share, OfALongRectangleIsThatOfTheSlit) {
    for (const double width_um : {0.3, 1.0, 20.0, 400.0}) {
        const double slit = propagatingShare(Slits{1, width_um * um, 1 * mm}, 550 * nm, 0.2, 0);
        const double ends = 550e-9 / (pi * pi * 1e-2 * std::sqrt(1.0 - 0.2 * 0.2));
        EXPECT_NEAR(propagatingShare(RectangularAperture{width_um * um, 1 * cm}, 550 * nm, 0.2, 0),
                    slit - ends, 1e-6);
    }
}

// Wide openings lose at their edges alone: perimeter wavelength/(2 pi^2 area), the limit of the circle's
// closed form.
TEST(Share, OfWideOpeningsIsALawOfTheirEdges) {
    const double wavelength = 550e-9;
    const auto lost = [&](const Aperture& aperture, double perimeter) {
        return perimeter * wavelength / (2.0 * pi * pi * area(aperture));
    };
    for (const double size : {3e-4, 3e-3}) {
        // Corners and ripple: a few times (wavelength/size)^2.
        const double bound = 3.0 * std::pow(wavelength / size, 2);
        const CircularAperture ring{size * m, 0.5 * size * m};
        EXPECT_NEAR(1.0 - propagatingShare(ring, wavelength * m, 0, 0), lost(ring, 1.5 * pi * size), bound);
        const RectangularAperture square{size * m, size * m};
        EXPECT_NEAR(1.0 - propagatingShare(square, wavelength * m, 0, 0), lost(square, 4.0 * size), bound);
        const PolygonalAperture many = regularPolygon(100, 0.5 * size);
        EXPECT_NEAR(1.0 - propagatingShare(many, wavelength * m, 0, 0), lost(many, pi * size), 1e-6);
    }
}

TEST(Share, OfLattices) {
    LatticeAperture lattice{CircularAperture{1 * um, 0 * um}, {2e-6, 0}, {0.5e-6, 1.5e-6}, 3, 2};
    expectParseval(lattice, 550e-9, 14);
    // Side by side the cells are one opening.
    const LatticeAperture tiles{RectangularAperture{2 * um, 1 * um}, {2e-6, 0}, {0, 1e-6}, 50, 60};
    EXPECT_NEAR(propagatingShare(tiles, 550 * nm, 0, 0.1),
                propagatingShare(RectangularAperture{100 * um, 60 * um}, 550 * nm, 0, 0.1), 1e-3);
    // A lattice of one row is between its finite sum and the orders.
    lattice.firstCount = 16;
    lattice.secondCount = 20;
    for (const double wavelength : {450e-9, 620e-9})
        EXPECT_NEAR(propagatingShare(lattice, wavelength * m, 0.1, 0),
                    byQuadrature(lattice, wavelength, 0.1, 0, 90), 1e-3);
}

// Large cells side by side or a little apart, round ones that touch, edges at an angle, and small ones far
// apart. Neighbours change 1e-4 to 3e-3 here.
TEST(Share, OfLatticesOfManyOrders) {
    const auto expect = [](const Cell& cell, glm::dvec2 first, glm::dvec2 second) {
        const LatticeAperture lattice{cell, first, second, 3, 2};
        EXPECT_NEAR(propagatingShare(lattice, 550 * nm, 0.1, 0), byQuadrature(lattice, 550e-9, 0.1, 0, 90),
                    2e-5);
    };
    expect(RectangularAperture{20 * um, 18 * um}, {2e-5, 0}, {1e-5, 1.8e-5});
    expect(RectangularAperture{19.7 * um, 17.6 * um}, {2e-5, 0}, {0, 1.8e-5});
    expect(PolygonalAperture{{{-9e-6, -1e-5}, {1e-5, -1e-5}, {8e-6, 1e-5}, {-9e-6, 1e-5}}}, {2e-5, 0},
           {0, 2e-5});
    expect(CircularAperture{19 * um, 6 * um}, {1.9e-5, 0}, {0.95e-5, 1.65e-5});
    expect(CircularAperture{0.5 * um, 0 * um}, {1.65e-5, 0}, {0, 1.65e-5});
}

}  // namespace
}  // namespace fringe::optics
