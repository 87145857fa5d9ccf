// Closed forms of gratings and apertures against the reference renderer, which adds up waves, and shares
// with them no more than the scene.
#include "profile/closed_form.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "optics/quadrature.hpp"
#include "oracle/grating.hpp"

namespace fringe::profile {
namespace {

using namespace units;

// Light goes to -z, x across the slits; a wall stands one metre away.
scene::Light lightOfBeam(optics::Aperture aperture, optics::Spectrum spectrum, Length beam = 5.0 * mm) {
    scene::Grating grating{};
    grating.position = {0, 0, 0};
    grating.normal = {0, 0, -1};
    grating.slitDirection = {0, -1, 0};
    grating.aperture = std::move(aperture);
    grating.beam = {scene::BeamProfile::rectangle, beam, beam, {0, 0, -1}, 1.0 * W, 0.0 * rad, {}};
    scene::Light light{"grating", {1, 1, 1}, std::move(spectrum), grating};
    return light;
}

scene::Grating& gratingOf(scene::Light& light) {
    return std::get<scene::Grating>(light.model);
}

optics::Spectrum laser() {
    return {{}, {{632.8 * nm, 1.0, 0.0 * nm}}};
}

// One watt over the visible range, more of it in the red.
optics::Spectrum lamp() {
    return optics::normalised({{{380.0, 0.5}, {780.0, 1.5}}, {}});
}

double oracleIrradiance(const oracle::Grating& grating, const optics::Spectrum& spectrum, dvec3 point,
                        dvec3 normal) {
    double sum = 0.0;
    const optics::Curve all = optics::constantCurve(1.0);
    for (const optics::Line& line : spectrum.lines)
        sum += line.power * grating.irradiance(point, normal, line.wavelength / nm);
    constexpr double kStep_nm = 0.25;  // a fraction of the finest fringe below
    if (!spectrum.density.empty())
        for (double at = 380.0 + 0.5 * kStep_nm; at < 780.0; at += kStep_nm)
            sum += kStep_nm * optics::valueAt(spectrum.density, at) * grating.irradiance(point, normal, at);
    return sum;
}

// Largest difference along a line on the wall over the largest value of the reference there.
double errorAlong(const scene::Light& light, dvec3 from, dvec3 to, int steps) {
    const oracle::Grating reference(std::get<scene::Grating>(light.model), light.spectrum);
    const auto form = ClosedForm::of(light);
    EXPECT_TRUE(form);
    const dvec3 normal(0, 0, 1);
    double largest = 0.0, peak = 0.0;
    for (int i = 0; i <= steps; ++i) {
        const dvec3 point = from + (1.0 * i / steps) * (to - from);
        const double expected = oracleIrradiance(reference, light.spectrum, point, normal);
        largest = std::max(largest, std::abs(form->irradiance(point, normal, dvec3(0.0)) - expected));
        peak = std::max(peak, expected);
    }
    ::testing::Test::RecordProperty("error", std::to_string(largest / peak));
    return largest / peak;
}

optics::Slits slits(std::uint32_t count, double width_um, double period_um) {
    return {count, width_um * um, period_um * um};
}

// The reference has the exact ways. Fresnel's approximation leaves out their cubic term, which at the rim of
// 5 mm at 1 m turns the wave by 0.02 and of 1 mm by 2e-4; intensities then change by up to twice that. Few
// slits have no such term.
constexpr double kFew = 1e-5, kNarrow = 5e-4, kWide = 2e-2;

TEST(ClosedForm, OfFewSlitsInLaserLight) {
    EXPECT_LT(errorAlong(lightOfBeam(slits(1, 10, 10), laser()), {-0.1, 0, -1}, {0.13, 0, -1}, 60), kFew);
    EXPECT_LT(errorAlong(lightOfBeam(slits(4, 1, 2), laser()), {-0.1, 0, -1}, {0.53, 0, -1}, 60), kFew);
    EXPECT_LT(errorAlong(lightOfBeam(slits(50, 1, 2), laser()), {0.3, 0, -1}, {0.36, 0, -1}, 60), kNarrow);
}

// The mean over the orders' tails between them leaves out how they interfere: 1/(pi^2 N) of an order.
TEST(ClosedForm, OfAContinuum) {
    EXPECT_LT(errorAlong(lightOfBeam(slits(4, 1, 2), lamp()), {-0.1, 0, -1}, {0.53, 0, -1}, 10), kFew);
    EXPECT_LT(errorAlong(lightOfBeam(slits(50, 1, 2), lamp()), {-0.01, 0, -1}, {0.53, 0, -1}, 10), kNarrow);
    EXPECT_LT(errorAlong(lightOfBeam(slits(100, 1, 2), lamp()), {-0.01, 0, -1}, {0.53, 0, -1}, 10), 2e-3);
    EXPECT_LT(errorAlong(lightOfBeam(slits(500, 1, 2), lamp()), {0.2, 0, -1}, {0.3, 0, -1}, 2), kNarrow);
}

TEST(ClosedForm, OfManySlitsNearAndFar) {
    EXPECT_LT(errorAlong(lightOfBeam(slits(500, 1, 2), laser()), {0.325, 0, -1}, {0.330, 0, -1}, 100),
              kNarrow);
    EXPECT_LT(errorAlong(lightOfBeam(slits(2500, 1, 2), laser()), {0.321, 0, -1}, {0.335, 0, -1}, 100),
              kWide);
    EXPECT_LT(errorAlong(lightOfBeam(slits(500, 1, 2), lamp()), {-0.001, 0, -1}, {0.001, 0, -1}, 4), kNarrow);
    scene::Light focused = lightOfBeam(slits(2500, 1, 2), laser());
    gratingOf(focused).beam.focus = 1.0 * m;
    EXPECT_LT(errorAlong(focused, {-0.0005, 0, -1}, {0.0005, 0, -1}, 60), kFew);
}

// Across the slits the focus of 1.11 m lies on the wall where order 1 is, along them it does not; then a
// parallel beam, and one that the slits fill by half.
TEST(ClosedForm, OfRoundBeams) {
    scene::Light light = lightOfBeam(slits(2500, 1, 2), laser());
    gratingOf(light).beam.profile = scene::BeamProfile::flat;
    EXPECT_LT(errorAlong(light, {0.321, 1e-3, -1}, {0.335, 1e-3, -1}, 20), kWide);
    gratingOf(light).beam.focus = 1.17 * m;
    EXPECT_LT(errorAlong(light, {0.3325, 1e-4, -1}, {0.3345, 1e-4, -1}, 20), kWide);
    light = lightOfBeam(slits(500, 1, 2), laser(), 2.0 * mm);
    gratingOf(light).beam.profile = scene::BeamProfile::flat;
    EXPECT_LT(errorAlong(light, {0.3260, 1e-4, -1}, {0.3290, 1e-4, -1}, 20), kNarrow);
}

TEST(ClosedForm, OfObliqueBeams) {
    scene::Light light = lightOfBeam(slits(50, 1, 2), laser());
    gratingOf(light).beam.direction = glm::normalize(dvec3(0.2, 0.3, -1.0));
    EXPECT_LT(errorAlong(light, {0.2, 0.0, -1}, {0.2, 0.8, -1}, 800), kNarrow);
}

TEST(ClosedForm, AlongTheSlits) {
    scene::Light light = lightOfBeam(slits(4, 1, 2), laser());
    EXPECT_LT(errorAlong(light, {0.32, -0.005, -1}, {0.32, 0.005, -1}, 100), kFew);
    light = lightOfBeam(slits(4, 1, 2), laser(), 1.0 * mm);
    gratingOf(light).beam.profile = scene::BeamProfile::gaussian;
    EXPECT_LT(errorAlong(light, {0.32, -0.005, -1}, {0.32, 0.005, -1}, 100), kNarrow);
}

TEST(ClosedForm, OfGivenOrders) {
    scene::Light light = lightOfBeam(slits(200, 1, 2), laser());
    gratingOf(light).efficiencies = {{1, optics::constantCurve(0.6)}, {-1, optics::constantCurve(0.1)}};
    EXPECT_LT(errorAlong(light, {0.325, 0, -1}, {0.330, 0, -1}, 100), kNarrow);
    EXPECT_LT(errorAlong(light, {-0.330, 0, -1}, {-0.325, 0, -1}, 100), kNarrow);
}

TEST(ClosedForm, OfOpenings) {
    const optics::RectangularAperture rectangle{0.2 * mm, 0.1 * mm};
    const std::vector<optics::Aperture> apertures = {
        optics::CircularAperture{0.2 * mm, 0.0 * mm}, optics::CircularAperture{0.2 * mm, 0.1 * mm}, rectangle,
        optics::PolygonalAperture{{{1e-4, -1e-4}, {1e-4, 1e-4}, {-2e-4, 0.0}}},
        optics::LatticeAperture{
            optics::CircularAperture{0.05 * mm, 0.0 * mm}, {1e-4, 0.0}, {0.0, 1e-4}, 2, 3}};
    for (const optics::Aperture& aperture : apertures) {
        scene::Light light = lightOfBeam(aperture, laser());
        gratingOf(light).beam.focus = 1.0 * m;  // else the wall is in their near field
        EXPECT_LT(errorAlong(light, {-0.01, 0.002, -1}, {0.01, 0.002, -1}, 100), kFew) << aperture.index();
    }
    const scene::Light small = lightOfBeam(optics::RectangularAperture{20.0 * um, 10.0 * um}, lamp());
    EXPECT_LT(errorAlong(small, {-0.1, 0.002, -1}, {0.1, 0.002, -1}, 10), kFew);
}

TEST(ClosedForm, MasksAndOtherLightsHaveNone) {
    EXPECT_FALSE(ClosedForm::of(lightOfBeam(optics::MaskAperture{1, 1, 1.0 * mm, {1.0F}}, laser())));
    EXPECT_FALSE(ClosedForm::of({"lamp", {1, 1, 1}, laser(), scene::PointLight{{0, 0, 0}, 1.0 * W}}));
}

TEST(ClosedForm, IsDarkBehindTheGratingAndOnTheBack) {
    const auto form = ClosedForm::of(lightOfBeam(slits(4, 1, 2), laser()));
    EXPECT_EQ(form->irradiance({0, 0, 1}, {0, 0, -1}, dvec3(0.0)), 0.0);
    EXPECT_EQ(form->irradiance({0, 0, -1}, {0, 0, -1}, dvec3(0.0)), 0.0);
    EXPECT_GT(form->irradiance({0, 0, -1}, {0, 0, 1}, dvec3(0.0)), 0.0);
}

// The mean over what a sample stands for is that of the points in it.
TEST(ClosedForm, AveragesOverTheSample) {
    const dvec3 reach(0.01, 0, 0), normal(0, 0, 1);
    for (const std::uint32_t count : {4U, 200U}) {
        scene::Light light = lightOfBeam(slits(count, 1, 2), laser());
        gratingOf(light).beam.focus = 1.0 * m;
        const auto form = ClosedForm::of(light);
        const dvec3 middle(count == 4 ? 0.3 : 0.3329, 0, -1);
        double sum = 0.0;
        constexpr int kPoints = 2000;
        for (int i = 0; i < kPoints; ++i)
            sum += form->irradiance(middle + ((2.0 * i + 1.0) / kPoints - 1.0) * reach, normal, dvec3(0.0));
        const double mean = form->irradiance(middle, normal, reach);
        // Distance and pattern of a slit are those of the middle: over 2 cm they change by 2 % to either
        // side.
        EXPECT_NEAR(mean, sum / kPoints, 0.01 * sum / kPoints) << count;
    }
}

}  // namespace
}  // namespace fringe::profile
