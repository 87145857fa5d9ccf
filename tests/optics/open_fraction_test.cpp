// How much of a beam passes: against sums over small pieces of the opening.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "optics/energy.hpp"
#include "optics/shapes.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {
namespace {

using namespace units;
using glm::dvec2;
using std::numbers::pi;

constexpr double kBeam = 2e-3;

// Per watt, at a point of a beam of kBeam.
double irradiance(BeamProfile shape, dvec2 at) {
    const double place = 2.0 * glm::length(at) / kBeam;
    if (shape == BeamProfile::gaussian) return 8.0 / (pi * kBeam * kBeam) * std::exp(-2.0 * place * place);
    if (shape == BeamProfile::flat) return place < 1.0 ? 4.0 / (pi * kBeam * kBeam) : 0.0;
    return std::abs(at.x) < 0.5 * kBeam && std::abs(at.y) < kBeam ? 1.0 / (2.0 * kBeam * kBeam) : 0.0;
}

// Midpoint sum over a square of `size` of what `isOpen` at a point.
template <class IsOpen>
double summed(BeamProfile shape, double size, IsOpen isOpen) {
    constexpr int kSteps = 2000;
    const double step = size / kSteps;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const dvec2 at((i + 0.5) * step - 0.5 * size, (j + 0.5) * step - 0.5 * size);
            if (isOpen(at)) sum += irradiance(shape, at) * step * step;
        }
    }
    return sum;
}

constexpr BeamProfile kShapes[] = {BeamProfile::flat, BeamProfile::gaussian, BeamProfile::rectangle};

// Few slits in a large disc: 4 count width/(pi diameter).
TEST(OpenFraction, OfFewSlits) {
    EXPECT_NEAR(openFraction(Slits{5, 1 * um, 2 * um}, 5e-3, 5e-3, BeamProfile::flat),
                4.0 * 5e-6 / (pi * 5e-3),
                1e-9);  // 1e-6 of it: the chord is shorter off the middle
    EXPECT_NEAR(openFraction(Slits{5, 1 * um, 2 * um}, 5e-3, 1e-3, BeamProfile::rectangle), 1e-3, 1e-15);
}

TEST(OpenFraction, OfSlitsPartlyOutsideTheBeam) {
    // 30 slits of 80 um, 100 um apart: 3 mm, of which the beam holds two.
    const Slits slits{30, 80 * um, 100 * um};
    for (const BeamProfile shape : kShapes) {
        const double expected = summed(shape, 3.0 * kBeam, [&](dvec2 at) {
            const double place = at.x / 100e-6 - 0.5;
            return std::abs(place - std::nearbyint(place)) < 0.4 && std::abs(at.x) < 15 * 100e-6;
        });
        EXPECT_NEAR(openFraction(slits, kBeam, 2.0 * kBeam, shape), expected,
                    2e-3);  // rows of 3 um at the edges
    }
    // A grating that fills the beam passes width/period of it.
    EXPECT_NEAR(openFraction(Slits{100'000, 0.4 * um, 1 * um}, kBeam, kBeam, BeamProfile::gaussian), 0.4,
                1e-9);
}

TEST(OpenFraction, OfOpeningsInTheMiddle) {
    const RectangularAperture rectangle{0.6 * mm, 1.2 * mm};
    const CircularAperture ring{1.6 * mm, 0.4 * mm};
    const PolygonalAperture square{{{0.0, -1e-3}, {1e-3, 0.0}, {0.0, 1e-3}, {-1e-3, 0.0}}};
    for (const BeamProfile shape : kShapes) {
        EXPECT_NEAR(
            openFraction(rectangle, kBeam, 2.0 * kBeam, shape),
            summed(shape, 2e-3, [](dvec2 at) { return std::abs(at.x) < 0.3e-3 && std::abs(at.y) < 0.6e-3; }),
            2e-3);
        EXPECT_NEAR(openFraction(ring, kBeam, 2.0 * kBeam, shape),
                    summed(shape, 2e-3,
                           [](dvec2 at) { return glm::length(at) < 0.8e-3 && glm::length(at) > 0.2e-3; }),
                    2e-3);
        EXPECT_NEAR(openFraction(square, kBeam, 2.0 * kBeam, shape),
                    summed(shape, 2e-3, [](dvec2 at) { return std::abs(at.x) + std::abs(at.y) < 1e-3; }),
                    2e-3);
    }
    // Of a Gaussian: closed in the rectangle's two directions.
    EXPECT_NEAR(openFraction(rectangle, kBeam, kBeam, BeamProfile::gaussian),
                std::erf(std::sqrt(2.0) * 0.3) * std::erf(std::sqrt(2.0) * 0.6), 1e-12);
}

TEST(OpenFraction, OfLatticesAndMasksIsTheSumOfTheirCells) {
    const LatticeAperture lattice{
        RectangularAperture{0.1 * mm, 0.06 * mm}, {2e-4, 0}, {0.3e-4, 1.5e-4}, 5, 6};
    for (const BeamProfile shape : kShapes) {
        double cells = 0.0;
        for (int i = 0; i < 5; ++i) {
            for (int j = 0; j < 6; ++j) {
                const dvec2 at = (i - 2.0) * lattice.first + (j - 2.5) * lattice.second;
                PolygonalAperture cell = asPolygon(std::get<RectangularAperture>(lattice.cell));
                for (dvec2& vertex : cell.vertices) vertex += at;
                cells += openFraction(cell, kBeam, 2.0 * kBeam, shape);
            }
        }
        // (cell/beam)^4 of it, 6e-6.
        EXPECT_NEAR(openFraction(lattice, kBeam, 2.0 * kBeam, shape), cells, 1e-5 * cells);
    }
    // The lower left pixel of 2 x 2 is open, at half the amplitude: a quarter of the power on it.
    const MaskAperture mask{2, 2, 10 * um, {0.0F, 0.0F, 0.5F, 0.0F}};
    EXPECT_NEAR(openFraction(mask, kBeam, kBeam, BeamProfile::gaussian),
                0.25 * 1e-10 * 8.0 / (pi * kBeam * kBeam), 1e-8);
    EXPECT_NEAR(openFraction(mask, kBeam, kBeam, BeamProfile::rectangle), 0.25 * 1e-10 / (kBeam * kBeam),
                1e-18);
}

}  // namespace
}  // namespace fringe::optics
