// Openings against closed forms, worked values and each other.
#include "oracle/opening.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "oracle/opening_share.hpp"
#include "oracle/opening_wave.hpp"

namespace fringe::oracle {
namespace {

using namespace units;
using Complex = std::complex<double>;
using glm::dvec2;
using std::numbers::pi;

// Square micrometres, for frequencies per metre.
Complex amplitude(const OpeningShape& shape, const dvec2& f) {
    return Opening(shape, glm::length(f)).amplitude(f) * 1e12;
}

optics::PolygonalAperture regular(int sides, double radius) {
    optics::PolygonalAperture polygon;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * pi * i / sides;
        polygon.vertices.push_back(radius * dvec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

double sinc(double x) {
    return std::sin(pi * x) / (pi * x);
}

double airy(double x) {
    return 2.0 * std::cyl_bessel_j(1, x) / x;
}

// Green's theorem turns the area into a sum over edges; worked out elsewhere, and agreeing with quadrature to
// 5e-15.
TEST(Opening, HasTheWorkedValues) {
    EXPECT_NEAR(std::abs(amplitude(regular(6, 2e-6), {1.5e5, 2.5e5}) - 1.25682059869), 0.0, 1e-10);
    const optics::PolygonalAperture triangle{{{0.0, 0.0}, {3e-6, 0.0}, {0.0, 2e-6}}};
    EXPECT_NEAR(std::abs(amplitude(triangle, {1e5, 2e5}) - Complex(0.241882802319, -2.58479244122)), 0.0,
                1e-10);
    EXPECT_NEAR(std::abs(amplitude(optics::CircularAperture{3.0 * um, 0.0 * um}, {2e5, 1e5}) - 3.80695308130),
                0.0, 1e-10);
}

TEST(Opening, RectangleIsTwoSincs) {
    const optics::RectangularAperture rectangle{40.0 * um, 15.0 * um};
    for (const dvec2 f : {dvec2(1e4, 3e4), dvec2(2.1e6, 1e3), dvec2(-7.3e6, 1.1e6)}) {
        const double expected = 600.0 * sinc(40e-6 * f.x) * sinc(15e-6 * f.y);
        EXPECT_NEAR(std::abs(amplitude(rectangle, f) - expected), 0.0, 600.0 * 1e-12);  // up to 290 turns
    }
}

TEST(Opening, CircleIsAiryAndARingTheDifference) {
    for (const double f : {1e4, 3e5, 2e6}) {
        const dvec2 at = f * dvec2(0.6, -0.8);
        const double outer = 25.0 * pi * airy(pi * 10e-6 * f);
        const double inner = 4.0 * pi * airy(pi * 4e-6 * f);
        EXPECT_NEAR(std::abs(amplitude(optics::CircularAperture{10.0 * um, 0.0 * um}, at) - outer), 0.0,
                    1e-10);
        EXPECT_NEAR(std::abs(amplitude(optics::CircularAperture{10.0 * um, 4.0 * um}, at) - (outer - inner)),
                    0.0, 1e-10);
    }
    EXPECT_LT(std::abs(amplitude(optics::CircularAperture{10.0 * um, 0.0 * um}, {1.219669891 / 10e-6, 0.0})),
              25.0 * pi * 1e-9)
        << "Airy's first dark ring";
}

// An L is a rectangle without a rectangle; its outline turns both ways.
TEST(Opening, PolygonsNeedNotBeConvex) {
    const optics::PolygonalAperture ell{
        {{0.0, 0.0}, {3e-6, 0.0}, {3e-6, 1e-6}, {1e-6, 1e-6}, {1e-6, 4e-6}, {0.0, 4e-6}}};
    const auto box = [](const dvec2& middle, const dvec2& size, const dvec2& f) {
        return size.x * size.y * 1e12 * sinc(size.x * f.x) * sinc(size.y * f.y) *
               std::polar(1.0, -2.0 * pi * glm::dot(f, middle));
    };
    const dvec2 f(3.1e5, -4.7e5);
    const Complex expected = box({0.5e-6, 2e-6}, {1e-6, 4e-6}, f) + box({2e-6, 0.5e-6}, {2e-6, 1e-6}, f);
    EXPECT_LT(std::abs(amplitude(ell, f) - expected), 1e-11);
}

TEST(Opening, LatticeIsItsCellsAddedUp) {
    const optics::LatticeAperture lattice{
        optics::CircularAperture{2.0 * um, 0.0 * um}, {5e-6, 1e-6}, {-1e-6, 4e-6}, 4, 3};
    const dvec2 f(2.3e5, -0.9e5);
    const Complex cell = amplitude(optics::CircularAperture{2.0 * um, 0.0 * um}, f);
    Complex expected = 0.0;
    for (double i : {-1.5, -0.5, 0.5, 1.5}) {
        for (double j : {-1.0, 0.0, 1.0})
            expected +=
                cell * std::polar(1.0, -2.0 * pi * glm::dot(f, i * lattice.first + j * lattice.second));
    }
    EXPECT_LT(std::abs(amplitude(lattice, f) - expected), 1e-11);
    EXPECT_NEAR(openArea(lattice), 12.0 * pi * 1e-12, 1e-23);
}

// Rows run from the top, and the middle is at 0.
TEST(Opening, MaskIsMadeOfSquares) {
    optics::MaskAperture mask{4, 3, 2.0 * um, std::vector<float>(12, 0.0F)};
    mask.transmission[3] = 1.0F;  // the upper right corner
    mask.transmission[4] = 0.5F;  // the left end of the middle row
    const dvec2 f(1.3e5, -0.7e5);
    const auto pixel = [&](const dvec2& middle) {
        return 4.0 * sinc(2e-6 * f.x) * sinc(2e-6 * f.y) * std::polar(1.0, -2.0 * pi * glm::dot(f, middle));
    };
    const Complex expected = pixel({3e-6, 2e-6}) + 0.5 * pixel({-3e-6, 0.0});
    EXPECT_LT(std::abs(amplitude(mask, f) - expected), 1e-12);
    EXPECT_DOUBLE_EQ(openArea(mask), 1.25 * 4e-12);
}

// Circle: 1 - J0(x)^2 - J1(x)^2, x = pi D / wavelength; hexagons by another quadrature. Five digits.
TEST(OpeningShare, HasThePublishedValues) {
    const double circles[][2] = {{0.5, 0.80425}, {1.0, 0.89178}, {2.0, 0.94259}, {5.0, 0.97804}};
    for (const auto& [diameter_um, share] : circles) {
        const optics::CircularAperture circle{diameter_um * um, 0.0 * um};
        EXPECT_NEAR(propagatingShare(circle, 550e-9, dvec2(0.0)), share, 6e-6) << diameter_um;
    }
    const double hexagons[][2] = {{0.25, 0.76509}, {0.5, 0.86414}, {1.0, 0.93439}, {2.5, 0.97466}};
    for (const auto& [radius_um, share] : hexagons)
        EXPECT_NEAR(propagatingShare(regular(6, radius_um * 1e-6), 550e-9, dvec2(0.0)), share, 6e-6);
}

// What is missing falls as wavelength / size. The ripple that edges alone do not know is (wavelength /
// size)^2.
TEST(OpeningShare, OfLargeOpeningsComesFromTheirEdges) {
    for (const double diameter_um : {8.0, 30.0, 200.0}) {
        const double x = pi * diameter_um / 0.55;
        const double j0 = std::cyl_bessel_j(0, x);
        const double j1 = std::cyl_bessel_j(1, x);
        const optics::CircularAperture circle{diameter_um * um, 0.0 * um};
        EXPECT_NEAR(propagatingShare(circle, 550e-9, dvec2(0.0)), 1.0 - j0 * j0 - j1 * j1,
                    0.25 * std::pow(0.55 / diameter_um, 2));
    }
}

// On both sides of the size where the method changes; oblique light, polygons, rings and masks too.
TEST(OpeningShare, HasNoSeam) {
    const double wavelength = 0.5e-6;
    const auto expectSeamless = [&](const auto& ofExtent) {
        for (const dvec2 incident : {dvec2(0.0), dvec2(-0.3, 0.5)}) {
            // 11.6 and 13.4 wavelengths across.
            const double small = 1.0 - propagatingShare(ofExtent(5.8e-6), wavelength, incident);
            const double large = 1.0 - propagatingShare(ofExtent(6.7e-6), wavelength, incident);
            EXPECT_NEAR(small, large * 6.7 / 5.8, 2e-3) << incident.x;
        }
    };
    expectSeamless([](double size) -> OpeningShape { return regular(6, 0.5 * size); });
    expectSeamless([](double size) -> OpeningShape {
        return optics::CircularAperture{size * m, 0.3 * size * m};
    });
    expectSeamless([](double size) -> OpeningShape {
        return optics::RectangularAperture{0.8 * size * m, 0.6 * size * m};
    });
    expectSeamless([](double size) -> OpeningShape {
        return optics::MaskAperture{
            4, 3, 0.2 * size * m, {1.0F, 0.0F, 0.5F, 0.5F, 1.0F, 1.0F, 1.0F, 0.0F, 0.0F, 1.0F, 0.25F, 1.0F}};
    });
}

// An endless row of rows is endless rows across: a lattice of slots that touch along one direction is a
// grating of slits, whose share is known.
TEST(OpeningShare, OfALatticeOfSlotsIsThatOfSlits) {
    const optics::LatticeAperture slots{
        optics::RectangularAperture{0.5 * um, 1.0 * um}, {1.6e-6, 0.0}, {0.0, 1e-6}, 400, 400};
    EXPECT_NEAR(propagatingShare(slots, 550e-9, dvec2(0.0)), 0.899177, 6e-7);  // docs/theory.md, endless
    const optics::LatticeAperture wide{
        optics::RectangularAperture{0.8 * um, 1.0 * um}, {1.6e-6, 0.0}, {1.6e-6, 1e-6}, 400, 400};
    EXPECT_NEAR(propagatingShare(wide, 550e-9, dvec2(0.5, 0.0)), 0.9278, 6e-5);
}

// On the axis of a circle in even light the sum of waves over rings of equal ways has a primitive.
TEST(OpeningWave, OnTheAxisOfACircleIsAsTheIntegralOverTheWays) {
    scene::Grating grating{};
    const optics::CircularAperture circle{6.0 * mm, 0.0 * mm};
    grating.efficiency = 1.0;
    const OpeningWave wave(grating, circle);
    for (const double distance : {0.5, 1.0, 1.7}) {
        const auto view = wave.view({0, 0, distance}, {0, 0, -1}, {0, 0});
        for (const double wavelength : {400e-9, 543e-9, 777e-9}) {
            const double k = 2.0 * pi / wavelength;
            const auto primitive = [&](double s) {
                return Complex(1.0 / (k * k), -s / k) * std::polar(1.0, k * (s - distance));
            };
            const Complex amplitude =
                2.0 * pi * (primitive(std::hypot(distance, 3e-3)) - primitive(distance));
            const double area = pi * 9e-6;
            const double expected = std::norm(amplitude) / (area * std::pow(wavelength * distance, 2));
            EXPECT_NEAR(wave.irradiance(view, wavelength), expected, 1e-5 * 4.0 / area)
                << distance << ' ' << wavelength;
        }
    }
}

}  // namespace
}  // namespace fringe::oracle
