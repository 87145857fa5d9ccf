// Physical slits: the device against the reference renderer, which adds up the waves of all slits in double
// precision at 401 wavelengths or more. Signed XYZ, as shares of the peak.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <ostream>

#include "optics/color.hpp"
#include "optics/sources.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

using glm::dvec3;
using units::m, units::mm, units::nm, units::um, units::W;

scene::Beam rectangularBeam(units::Length width, units::Length height) {
    return {.profile = scene::BeamProfile::rectangle,
            .width = width,
            .height = height,
            .direction = {0, 0, -1},
            .power = 1.0 * W,
            .angularSize = {},
            .focus = {}};
}

// What is asked of one picture: a wall 1 m behind the slits, seen straight on.
struct Case {
    const char* name;
    optics::Slits slits;
    scene::Beam beam;
    optics::Spectrum spectrum;
    optics::Curve reflectance;
    double center;     // metres across the slits from their normal
    double pixel;      // metres
    double tolerance;  // share of the picture's peak
    bool throughGold = false;
    std::uint32_t columns = 24;
    std::uint32_t rows = 3;
    std::vector<scene::OrderEfficiency> orders = {};
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

scene::Scene sceneOf(const Case& c) {
    scene::Scene scene{};
    scene.image.width = c.columns;
    scene.image.height = c.rows;
    scene.image.samples = 1;
    scene.image.maxDepth = 4;
    scene.camera.position = {c.center, 0, -0.2};
    scene.camera.target = {c.center, 0, c.throughGold ? 0.4 : -1.0};
    scene.camera.up = {0, 1, 0};
    scene.camera.projection = scene::Orthographic{c.pixel * c.rows};
    scene.materials.push_back({"wall", scene::Diffuse{c.reflectance}});
    scene.objects.push_back({"", scene::Rectangle{{0, 0, -1}, {3, 0, 0}, {0, 3, 0}}, 0});
    if (c.throughGold) {
        scene.materials.push_back({"gold", scene::Conductor{scene::Metal::gold}});
        scene.objects.push_back({"", scene::Rectangle{{c.center, 0, 0.5}, {2, 0, 0}, {0, 2, 0}}, 1});
    }
    scene.lights.push_back({"",
                            {1, 1, 1},
                            c.spectrum,
                            scene::Grating{.position = {0, 0, 0},
                                           .normal = {0, 0, -1},
                                           .slitDirection = {0, 1, 0},
                                           .aperture = c.slits,
                                           .beam = c.beam,
                                           .efficiency = c.orders.empty() ? std::optional(1.0) : std::nullopt,
                                           .efficiencies = c.orders}});
    return scene;
}

class SlitsOnDevice : public ::testing::TestWithParam<Case> {};

TEST_P(SlitsOnDevice, AreTheSumOfTheirWaves) {
    const scene::Scene scene = sceneOf(GetParam());
    const image::Image device = renderOnDevice(scene);
    const image::Image reference = renderReference(scene);
    double peak = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        ASSERT_TRUE(std::isfinite(device.pixels[i].x + device.pixels[i].y + device.pixels[i].z));
        peak = std::max(peak, distance(reference.pixels[i], {}));
        largest = std::max(largest, distance(device.pixels[i], reference.pixels[i]));
    }
    EXPECT_GT(peak, 0.0);
    RecordProperty("error", fmt::format("{:.1e}", largest / peak));  // the table of docs/theory.md
    EXPECT_LE(largest, GetParam().tolerance * peak);
}

const optics::Spectrum kDaylight = *optics::namedSpectrum("D65");
const optics::Curve kGrey = optics::constantCurve(0.75);
const optics::Curve kRedPaint = optics::reflectanceCurve({0.6, 0.06, 0.05});

optics::Slits slits(std::uint32_t count, double width_um, double period_um) {
    return {count, width_um * um, period_um * um};
}

scene::Beam with(scene::Beam beam, auto change) {
    change(beam);
    return beam;
}

const scene::Beam kTall = rectangularBeam(1.0 * mm, 400.0 * mm);
const scene::Beam kDisc =
    with(rectangularBeam(2.0 * mm, 2.0 * mm), [](auto& b) { b.profile = scene::BeamProfile::flat; });
const scene::Beam kBroad = rectangularBeam(6.0 * mm, 400.0 * mm);

// The device's response tables are made for 1e-3 of the peak (src/compile/slit_response.cpp). The pixels are
// fine against the pattern, because the device averages over them and the reference does not.
constexpr double kTables = 1e-3;

INSTANTIATE_TEST_SUITE_P(
    WhiteLight, SlitsOnDevice,
    ::testing::Values(
        Case{"one slit", slits(1, 1, 1), kTall, kDaylight, kGrey, 0.2, 2e-3, kTables},
        Case{"four slits", slits(4, 1, 2), kTall, kDaylight, kGrey, 0.2, 1e-3, kTables},
        Case{"four slits on red", slits(4, 1, 2), kTall, kDaylight, kRedPaint, 0.2, 1e-3, kTables},
        Case{"four slits seen in gold", slits(4, 1, 2), kTall, kDaylight, kGrey, 0.2, 1e-3, kTables, true},
        Case{"fifty slits, undeviated", slits(50, 0.5, 1.6), kTall, kDaylight, kGrey, 0.0, 0.001, kTables},
        Case{"fifty slits, order 1", slits(50, 0.5, 1.6), kTall, kDaylight, kGrey, 0.32, 6e-4, kTables},
        Case{"fifty slits, order 1, red", slits(50, 0.5, 1.6), kTall, kDaylight, kRedPaint, 0.4, 6e-4,
             kTables},
        Case{"fifty slits seen in gold", slits(50, 0.5, 1.6), kTall, kDaylight, kGrey, 0.34, 6e-4, kTables,
             true, 12, 1},
        Case{"coarse, order 1", slits(50, 4, 8), kTall, kDaylight, kGrey, 0.06, 2e-4, kTables}));

// On both sides of every change of method: slits that cover 40 um (with the undeviated light in the table,
// or apart from it), 16 slits in laser light (their sum, or an image of the beam for each order), beams of
// discs whose slits are of like or unlike length. Where both sides are right there is no seam.
INSTANTIATE_TEST_SUITE_P(
    Seams, SlitsOnDevice,
    ::testing::Values(
        Case{"just narrow, undeviated", slits(20, 1, 1.999), kTall, kDaylight, kGrey, 0.0, 2e-4, kTables},
        Case{"just wide, undeviated", slits(20, 1, 2.001), kTall, kDaylight, kGrey, 0.0, 2e-4, kTables},
        Case{"just narrow, order 1", slits(20, 1, 1.999), kTall, kDaylight, kGrey, 0.27, 2e-4, kTables},
        Case{"just wide, order 1", slits(20, 1, 2.001), kTall, kDaylight, kGrey, 0.27, 2e-4, kTables},
        // In an image the slope of each slit's own pattern across an order is taken at one place: for an
        // order as wide as a sixteenth of the way to the next, 2.3e-3 of the peak.
        Case{"15 slits, laser", slits(15, 4, 8), kTall, optics::laser(550.0 * nm, {}), kGrey, 0.069, 1e-4,
             1e-3},
        Case{"16 slits, laser", slits(16, 4, 8), kTall, optics::laser(550.0 * nm, {}), kGrey, 0.069, 1e-4,
             3e-3},
        Case{"slits of like length", slits(30, 1, 2), kDisc, kDaylight, kGrey, 0.27, 1e-4, 2e-3, false, 3,
             16},
        Case{"slits of unlike length", slits(80, 1, 2), kDisc, kDaylight, kGrey, 0.27, 1e-4, 5e-3, false, 3,
             16}));

// A blazed grating, its efficiencies made up.
const std::vector<scene::OrderEfficiency> kBlazed{{-1, optics::constantCurve(0.05)},
                                                  {0, optics::constantCurve(0.1)},
                                                  {1, optics::Curve{{380.0, 0.5}, {780.0, 0.8}}}};

INSTANTIATE_TEST_SUITE_P(GivenOrders, SlitsOnDevice,
                         ::testing::Values(Case{"few slits, order 1", slits(6, 1, 2), kTall, kDaylight, kGrey,
                                                0.27, 1e-3, kTables, false, 24, 1, kBlazed},
                                           Case{"few slits, order -1", slits(6, 1, 2), kTall, kDaylight,
                                                kGrey, -0.27, 1e-3, kTables, false, 24, 1, kBlazed},
                                           Case{"many slits, undeviated", slits(100, 1, 2), kTall, kDaylight,
                                                kGrey, 0.0, 2e-4, kTables, false, 24, 1, kBlazed},
                                           Case{"many slits, order 1", slits(100, 1, 2), kTall, kDaylight,
                                                kGrey, 0.27, 2e-4, kTables, false, 24, 1, kBlazed},
                                           Case{"many slits, laser, order 1", slits(100, 1, 2), kTall,
                                                optics::laser(550.0 * nm, {}), kGrey, 0.286, 2e-4, 2e-3,
                                                false, 24, 1, kBlazed}));

// Few slits of periods so coarse that a room is within the near field of their row: in Young's experiment, at
// the undeviated light and among the orders. Pixels are a fiftieth of a fringe: the device averages over
// them, which takes (pi/50)^2/6 off, 7e-4. The slits' own patterns are taken to the second order about the
// row's middle, which is 1.4e-3 for 20 slits whose row is as long as 0.07 of the width of a slit's pattern on
// the wall.
INSTANTIATE_TEST_SUITE_P(
    CoarseSlits, SlitsOnDevice,
    ::testing::Values(Case{"Young, undeviated", slits(2, 100, 250), kBroad, kDaylight, kGrey, 0.0006, 3e-5,
                           kTables, false, 60, 1},
                      Case{"Young, third fringe", slits(2, 100, 250), kBroad, kDaylight, kGrey, 0.006, 3e-5,
                           kTables, false, 60, 1},
                      Case{"Young on red", slits(2, 100, 250), kBroad, kDaylight, kRedPaint, 0.003, 3e-5,
                           kTables, false, 60, 1},
                      Case{"Young seen in gold", slits(2, 100, 250), kBroad, kDaylight, kGrey, 0.003, 3e-5,
                           kTables, true, 40, 1},
                      Case{"Young, laser", slits(2, 100, 250), kBroad, optics::laser(633.0 * nm, {}), kGrey,
                           0.003, 3e-5, kTables, false, 60, 1},
                      Case{"5 slits", slits(5, 20, 60), kBroad, kDaylight, kGrey, 0.009, 3e-5, kTables, false,
                           80, 1},
                      Case{"20 slits, undeviated", slits(20, 20, 100), kBroad, kDaylight, kGrey, 0.0, 5e-6,
                           kTables, false, 80, 1},
                      Case{"20 slits, order 1", slits(20, 20, 100), kBroad, kDaylight, kGrey, 0.0048, 5e-6,
                           kTables, false, 80, 1},
                      Case{"20 slits, order 4", slits(20, 20, 100), kBroad, kDaylight, kGrey, 0.022, 5e-6,
                           kTables, false, 80, 1},
                      Case{"20 slits, laser", slits(20, 20, 100), kBroad, optics::laser(550.0 * nm, {}),
                           kGrey, 0.0055, 5e-6, kTables, false, 80, 1}));

// A thousand slits cost the reference 0.3 s a point.
INSTANTIATE_TEST_SUITE_P(ManySlits, SlitsOnDevice,
                         ::testing::Values(Case{"undeviated", slits(1000, 1, 4), kBroad, kDaylight, kGrey,
                                                0.0, 1e-4, kTables, false, 8, 1},
                                           Case{"order 1", slits(1000, 1, 4), kBroad, kDaylight, kGrey, 0.13,
                                                2e-4, kTables, false, 8, 1}));

INSTANTIATE_TEST_SUITE_P(
    Lasers, SlitsOnDevice,
    ::testing::Values(
        // Closed forms in float32: the phase of five slits to 1e-6 of a turn.
        Case{"five slits", slits(5, 1, 2), kTall, optics::laser(550.0 * nm, {}), kGrey, 0.286, 1e-4, 1e-4},
        // The three orders nearest to a point stand for all: the rest is 1/(pi^2 N^2 1.5) of the peak, and
        // the phases of a disc of Fresnel number 2 are summed in float32.
        Case{"filled disc, order 1", slits(1000, 1, 2),
             with(rectangularBeam(2.0 * mm, 2.0 * mm), [](auto& b) { b.profile = scene::BeamProfile::flat; }),
             optics::laser(589.0 * nm, {}), kGrey, 0.3083, 2.5e-4, 2e-3, false, 12, 12},
        // A Fresnel number of 0.1: nearly the Airy pattern of the beam. The device has an even screen behind
        // its rim, the reference a row of 200 slits: 1/200.
        Case{"filled disc, far field", slits(200, 1.25, 2.5),
             with(rectangularBeam(0.5 * mm, 0.5 * mm), [](auto& b) { b.profile = scene::BeamProfile::flat; }),
             optics::laser(589.0 * nm, {}), kGrey, 0.2424, 2.5e-4, 5e-3, false, 12, 12},
        // A Fresnel number of 400. The rim counts as straight, which leaves out what its other side adds: one
        // over the root of that number.
        Case{"large disc, rim", slits(2000, 7.5, 15),
             with(rectangularBeam(30.0 * mm, 30.0 * mm),
                  [](auto& b) { b.profile = scene::BeamProfile::flat; }),
             optics::laser(550.0 * nm, {}), kGrey, 0.015, 1e-4, 5e-2, false, 12, 12}));

// Across the edges of beams of 2 to 10 mm, whose Fresnel ripple lies along the slits.
INSTANTIATE_TEST_SUITE_P(
    NearField, SlitsOnDevice,
    ::testing::Values(
        Case{"5 mm, 5 slits", slits(5, 1, 2), rectangularBeam(5.0 * mm, 5.0 * mm), kDaylight, kGrey, 0.0,
             1e-4, 2e-3, false, 3, 60},
        Case{"2 mm, 5 slits", slits(5, 1, 2), rectangularBeam(2.0 * mm, 2.0 * mm), kDaylight, kGrey, 0.25,
             1e-4, 2e-3, false, 3, 40},
        Case{"disc of 4 mm, undeviated", slits(1000, 1, 4),
             with(rectangularBeam(4.0 * mm, 4.0 * mm), [](auto& b) { b.profile = scene::BeamProfile::flat; }),
             kDaylight, kGrey, 0.0, 1e-4, 5e-3, false, 5, 5},
        // As in laser light, with the disc in 24 pieces.
        Case{"disc of 0.5 mm, order 1", slits(200, 1.25, 2.5),
             with(rectangularBeam(0.5 * mm, 0.5 * mm), [](auto& b) { b.profile = scene::BeamProfile::flat; }),
             kDaylight, kGrey, 0.2255, 2.5e-4, 1e-2, false, 12, 12}));

TEST(SlitBeamsOnDevice, ObliqueBeamsGoTheirWay) {
    Case c{"oblique", slits(20, 1, 2), kTall, kDaylight, kGrey, 0.45, 2e-4, kTables};
    c.beam.direction = glm::normalize(dvec3(0.4, 0.2, -0.89));
    scene::Scene scene = sceneOf(c);
    scene.camera.position.y = scene.camera.target.y = 0.2 / 0.89;
    const image::Image device = renderOnDevice(scene);
    const image::Image reference = renderReference(scene);
    double peak = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        peak = std::max(peak, distance(reference.pixels[i], {}));
        largest = std::max(largest, distance(device.pixels[i], reference.pixels[i]));
    }
    EXPECT_LE(largest, c.tolerance * peak);
}

class FineFringesOnDevice : public ::testing::TestWithParam<Case> {};

// One sample a pixel, which knows its size, against 1024, which need not. The pattern across a pixel is taken
// as a box in the direction cosine, and edges along the slits as straight: 1e-2 of the peak.
TEST_P(FineFringesOnDevice, AreAveragedOverAPixel) {
    scene::Scene scene = sceneOf(GetParam());
    const image::Image one = renderOnDevice(scene);
    scene.image.samples = 1024;
    const image::Image many = renderOnDevice(scene);
    double peak = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < many.pixels.size(); ++i) {
        peak = std::max(peak, distance(many.pixels[i], {}));
        largest = std::max(largest, distance(one.pixels[i], many.pixels[i]));
    }
    EXPECT_LE(largest, GetParam().tolerance * peak);
}

INSTANTIATE_TEST_SUITE_P(
    Slits, FineFringesOnDevice,
    ::testing::Values(Case{"two slits, laser", slits(2, 4, 100), kTall, optics::laser(550.0 * nm, {}), kGrey,
                           0.0, 0.02, 1e-2},
                      Case{"two slits, daylight", slits(2, 4, 100), kTall, kDaylight, kGrey, 0.0, 0.02, 1e-2},
                      // Where the pixel hides it, what spills over the edge of a beam of 1 mm into the next
                      // pixel is left out.
                      Case{"orders as thin as a hair, laser", slits(1000, 1, 2), kTall,
                           optics::laser(550.0 * nm, {}), kGrey, 0.28, 0.01, 2e-2},
                      Case{"the beam's edge", slits(5, 1, 2), rectangularBeam(5.0 * mm, 50.0 * mm), kDaylight,
                           kGrey, 0.0, 0.015, 1e-2, false, 8, 8}));

// The middle of each order's image of an oblique beam, against the conical grating equation (E. Loewen, E.
// Popov, "Diffraction Gratings and Applications", 2.1): alpha = alpha_in + m wavelength / period, beta =
// beta_in. The image of 0.6 mm weighs its near side more, by a relative 1e-3 a millimetre or so: 1e-7 m of
// the middle's place.
TEST(OrdersOnDevice, GoWhereTheConicalGratingEquationSays) {
    constexpr std::uint32_t kPixels = 96;
    constexpr double kField = 2.4e-3;  // metres
    const dvec3 in = glm::normalize(dvec3(0.2, 0.1, -1.0));
    for (const int order : {-2, -1, 1}) {
        const double alpha = in.x + order * 0.55 / 2.0, beta = in.y;
        const double gamma = std::sqrt(1.0 - alpha * alpha - beta * beta);
        const double x = alpha / gamma, y = beta / gamma;  // on the wall, 1 m away
        Case place{"",
                   slits(400, 1, 2),
                   rectangularBeam(0.6 * mm, 1.0 * mm),
                   optics::laser(550.0 * nm, {}),
                   kGrey,
                   x,
                   kField / kPixels,
                   0.0};
        place.beam.direction = in;
        place.columns = place.rows = kPixels;
        scene::Scene scene = sceneOf(place);
        scene.camera.position.y = scene.camera.target.y = y;
        const image::Image picture = renderOnDevice(scene);
        double sum = 0.0, right = 0.0, up = 0.0;
        for (std::uint32_t row = 0; row < kPixels; ++row) {
            for (std::uint32_t column = 0; column < kPixels; ++column) {
                const double value = picture.pixels[std::size_t{row} * kPixels + column].y;
                sum += value;
                right += value * ((column + 0.5) / kPixels - 0.5) * kField;
                up -= value * ((row + 0.5) / kPixels - 0.5) * kField;
            }
        }
        ASSERT_GT(sum, 0.0) << order;
        const dvec3 direction = glm::normalize(dvec3(x + right / sum, y + up / sum, -1.0));
        EXPECT_NEAR(direction.x, alpha, 1e-6) << order;
        EXPECT_NEAR(direction.y, beta, 1e-6) << order;
    }
}

}  // namespace
}  // namespace fringe::testing
