// Pixels that stand for an opening: how they are covered, and what they keep of it.
#include "optics/amplitude_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "optics/coverage.hpp"
#include "optics/energy.hpp"
#include "optics/mask_spectrum.hpp"

namespace fringe::optics {
namespace {

using namespace units;
using glm::dvec2;

// Worked by hand: a triangle with corners at (0.5, 0.5), (2.5, 0.5) and (0.5, 2.5), in any direction of turn.
TEST(Coverage, OfATriangle) {
    const std::vector<dvec2> triangle{{0.5, 0.5}, {2.5, 0.5}, {0.5, 2.5}};
    const std::vector<dvec2> reversed(triangle.rbegin(), triangle.rend());
    for (const std::vector<dvec2>& outline : {triangle, reversed}) {
        const std::vector<Covered> pixels = coverage({&outline, 1}, 3, 3);
        const double shares[] = {0.25, 0.5, 0.125, 0.5, 0.5, 0.0, 0.125, 0.0, 0.0};
        for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(pixels[i].share, shares[i], 1e-14) << i;
        EXPECT_NEAR(pixels[0].centroid.x, 0.25, 1e-14);
        EXPECT_NEAR(pixels[1].centroid.y, 0.25, 1e-14);
        EXPECT_NEAR(pixels[2].centroid.x, 1.0 / 6.0 - 0.5, 1e-14);
        EXPECT_NEAR(pixels[2].centroid.y, 0.5 + 1.0 / 6.0 - 0.5, 1e-14);
        EXPECT_NEAR(pixels[4].centroid.x, 1.0 / 3.0 - 0.5, 1e-14);
    }
}

// A square with a hole, half beyond the left and the upper side of the grid.
TEST(Coverage, LeavesOutHolesAndWhatIsOutside) {
    const std::vector<dvec2> outlines[] = {{{-2.5, -2.5}, {2.5, -2.5}, {2.5, 2.5}, {-2.5, 2.5}},
                                           {{-1.5, -1.5}, {-1.5, 1.5}, {1.5, 1.5}, {1.5, -1.5}}};
    double sum = 0.0;
    for (const Covered& pixel : coverage(outlines, 4, 4)) sum += pixel.share;
    EXPECT_NEAR(sum, 2.5 * 2.5 - 1.5 * 1.5, 1e-13);
    EXPECT_NEAR(coverage(outlines, 4, 4)[5].share, 0.75, 1e-14);
}

// What of a beam passes is known otherwise, from closed forms and by Green's theorem. A disc has 1,024 sides
// here: next to a hole's rim a narrow beam, which falls there by half within 0.1 of the radius, knows 1e-5.
TEST(GaussianGrid, HoldsTheOpeningsPower) {
    const Aperture openings[] = {RectangularAperture{30 * um, 4 * um}, CircularAperture{20 * um, 0 * um},
                                 CircularAperture{20 * um, 9 * um},
                                 PolygonalAperture{{{-5e-6, -4e-6}, {7e-6, -2e-6}, {-2e-6, 6e-6}}}};
    for (const Aperture& opening : openings) {
        for (const double beam : {7e-6, 20e-6, 200e-6}) {
            double nearest = 0.0;  // of a ring: the amplitude counts from there
            if (const auto* round = std::get_if<CircularAperture>(&opening))
                nearest = round->innerDiameter / m / beam;
            const double expected = openFraction(opening, beam, beam, BeamProfile::gaussian) /
                                    centralIrradiance(beam, beam, BeamProfile::gaussian) *
                                    std::exp(2.0 * nearest * nearest);
            EXPECT_NEAR(gaussianGrid(opening, beam, 144).area / expected, 1.0, 1e-5)
                << opening.index() << ' ' << beam;
        }
    }
}

// Summed over all directions where the table has all of them, and by the edges' law beyond. What that leaves
// out goes as the square of the wavelength over the opening's width: up to 6e-4 here.
TEST(GaussianGrid, ShareHasNoSeam) {
    for (const Aperture& opening :
         {Aperture(RectangularAperture{20 * um, 12 * um}), Aperture(CircularAperture{20 * um, 10 * um})}) {
        const MaskSpectrum spectrum(gaussianGrid(opening, 20e-6, 144));
        const double small = 1.0 - spectrum.propagatingShare(0.60 * um, 0.1, -0.2);
        const double large = 1.0 - spectrum.propagatingShare(0.54 * um, 0.1, -0.2);
        EXPECT_NEAR(small / 0.60, large / 0.54, 1.2e-3);
        EXPECT_GT(large, 1e-3);
    }
}

}  // namespace
}  // namespace fringe::optics
