// What a point sees of gratings: distances, angles and orders, against the grating equation.
#include "profile/sighting.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fringe::profile {
namespace {

using namespace units;

// At the origin, light to -z, x across.
scene::Light lightOfNarrowBeam(optics::Aperture aperture, optics::Spectrum spectrum) {
    scene::Grating grating{};
    grating.normal = {0, 0, -1};
    grating.slitDirection = {0, -1, 0};
    grating.aperture = std::move(aperture);
    grating.beam = {scene::BeamProfile::rectangle, 1.0 * mm, 1.0 * mm, {0, 0, -1}, 1.0 * W, 0.0 * rad, {}};
    return {"", {1, 1, 1}, std::move(spectrum), grating};
}

constexpr double kRounding = 1e-9;

TEST(Sighting, HasTheGratingEquationsOrders) {
    scene::Scene scene;
    const optics::Slits slits{100, 1.0 * um, 2.0 * um};
    scene.lights = {
        lightOfNarrowBeam(slits, {{{380.0, 1.0}, {780.0, 1.0}}, {}}),
        lightOfNarrowBeam(slits, {{}, {{600.0 * nm, 1.0, 0.0 * nm}, {500.0 * nm, 3.0, 0.0 * nm}}})};
    // 3-4-5: the sine is 0.6, and 0.6 d is 1200 nm.
    const auto sightings = sightingsFrom(scene, {0.3, 0.0, -0.4});
    ASSERT_EQ(sightings.size(), 2U);
    EXPECT_EQ(sightings[0].grating, "lights[0]");
    EXPECT_NEAR(sightings[0].distance, 0.5, kRounding);
    EXPECT_NEAR(sightings[0].angle_deg, std::atan(0.75) * 180.0 / std::acos(-1.0), kRounding);
    EXPECT_NEAR(sightings[0].u, 0.6, kRounding);
    ASSERT_EQ(sightings[0].orders.size(), 2U);  // order 1 is infrared
    EXPECT_EQ(sightings[0].orders[0].order, 2);
    EXPECT_NEAR(sightings[0].orders[0].wavelength_nm, 600.0, 1e-6);
    EXPECT_EQ(sightings[0].orders[1].order, 3);
    EXPECT_NEAR(sightings[0].orders[1].wavelength_nm, 400.0, 1e-6);
    ASSERT_EQ(sightings[1].lines.size(), 2U);
    EXPECT_NEAR(sightings[1].lines[0].wavelength_nm, 500.0, 1e-6);  // the brightest first
    EXPECT_NEAR(sightings[1].lines[0].order, 2.4, kRounding);
    EXPECT_NEAR(sightings[1].lines[1].order, 2.0, kRounding);
    EXPECT_TRUE(sightings[1].orders.empty());
}

TEST(Sighting, OfTheOtherSideHasNegativeOrders) {
    scene::Scene scene;
    scene.lights = {
        lightOfNarrowBeam(optics::Slits{100, 1.0 * um, 2.0 * um}, {{{380.0, 1.0}, {780.0, 1.0}}, {}})};
    const auto sightings = sightingsFrom(scene, {-0.3, 0.0, -0.4});
    ASSERT_EQ(sightings[0].orders.size(), 2U);
    EXPECT_EQ(sightings[0].orders[0].order, -2);
    EXPECT_FALSE(sightings[0].isUndeviated);
    EXPECT_TRUE(sightingsFrom(scene, {0.0, 0.0, -0.4})[0].isUndeviated);
    EXPECT_TRUE(sightingsFrom(scene, {0.0, 0.0, 0.4}).empty());  // behind it
}

TEST(Sighting, OfAnOpeningHasBothSines) {
    scene::Scene scene;
    scene.lights = {
        lightOfNarrowBeam(optics::CircularAperture{1.0 * mm, 0.0 * mm}, {{}, {{600.0 * nm, 1.0, 0.0 * nm}}}),
        {"lamp", {1, 1, 1}, {}, scene::PointLight{{0, 0, 0}, 1.0 * W}}};
    const auto sightings = sightingsFrom(scene, {0.3, 0.2, -0.4});
    ASSERT_EQ(sightings.size(), 1U);
    const double distance = std::sqrt(0.29);
    EXPECT_NEAR(sightings[0].u, 0.3 / distance, kRounding);
    EXPECT_NEAR(sightings[0].v, -0.2 / distance, kRounding);
    EXPECT_TRUE(sightings[0].lines.empty());
}

}  // namespace
}  // namespace fringe::profile
