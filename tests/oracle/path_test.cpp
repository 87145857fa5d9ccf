// Chains of mirrors and glass against what must come out of them.
#include "oracle/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "oracle/axes.hpp"
#include "oracle/fresnel.hpp"
#include "oracle/metals.hpp"
#include "oracle/thesis.hpp"
#include "scenes.hpp"

namespace fringe::oracle {
namespace {

using namespace units;

Value look(const scene::Scene& scene, const Ray& ray, std::uint32_t maxDepth = 8) {
    const World world = makeWorld(scene);
    const Sampler sampler(0, 0, 0, 1);
    return Tracer(world, sampler, maxDepth).radiance(ray, {});
}

Rgb seen(const scene::Scene& scene, const Ray& ray, std::uint32_t maxDepth = 8) {
    return rgbOf(look(scene, ray, maxDepth).xyz);
}

// Radiance of D65 light.
double radianceSeen(const scene::Scene& scene, const Ray& ray, std::uint32_t maxDepth = 8) {
    return look(scene, ray, maxDepth).xyz.y;
}

scene::Scene under(double radiance) {
    scene::Scene scene;
    addLight(scene, scene::EnvironmentLight{radiance * W_per_m2_sr});
    return scene;
}

TEST(Path, WhatMissesSeesTheEnvironment) {
    EXPECT_LT(glm::length(seen(under(3.0), {dvec3(0.0), kX}) - Rgb(3.0)), kRounding);
    EXPECT_EQ(seen({}, {dvec3(0.0), kX}), Rgb(0.0));
}

// A convex matt body under an even sky is as bright as the sky times its reflectance, everywhere and at every
// wavelength.
TEST(Path, MattSphereInAFurnace) {
    const Ray ray{dvec3(0.0), glm::normalize(dvec3(0.1, 0.2, -1.0))};
    scene::Scene scene = under(2.0);
    addObject(scene, scene::Sphere{{0.0, 0.0, -3.0}, 1.0}, grey(0.75));
    EXPECT_LT(glm::length(seen(scene, ray) - Rgb(1.5)), kRounding);

    // A line keeps its chromaticity, and takes the reflectance of its wavelength: 0.25 in the middle of the
    // ramp.
    scene.materials[0].model = scene::Diffuse{{{380.0, 0.0}, {500.0, 0.0}, {600.0, 0.5}, {780.0, 0.5}}};
    scene.lights[0].spectrum = {{}, {{550.0 * nm, 1.0, 0.0 * nm}}};
    EXPECT_LT(glm::length(look(scene, ray).xyz - 0.5 * filmResponse(550.0)), kRounding);
}

// Glass neither makes nor keeps light: it cannot be told from the sky, but for the branches dropped as too
// faint.
TEST(Path, GlassInAFurnaceIsInvisible) {
    scene::Scene scene = under(1.0);
    addObject(scene, scene::Sphere{{0.0, 0.0, -3.0}, 1.0}, scene::Dielectric{1.5});
    addObject(scene, scene::Box{{0.0, 0.0, -6.0}, kX, kY, kZ}, scene::Dielectric{1.3});
    for (double x = 0.0; x < 0.33; x += 0.01) {
        const double left = radianceSeen(scene, {dvec3(0.0), glm::normalize(dvec3(x, 0.02, -1.0))}, 64);
        EXPECT_LE(left, 1.0 + kRounding);
        EXPECT_GE(left, 1.0 - 16.0 / 4096.0);  // 16 faint branches at two bodies are more than enough
    }
}

// A record is black lacquer: of light from straight ahead it sends back ((n - 1)/(n + 1))^2, and at
// Brewster's angle, tan = n, half of the perpendicular part ((1 - n^2)/(1 + n^2))^2. Nothing comes through
// it.
TEST(Path, RecordReflectsAtItsLacquerAlone) {
    constexpr double kIndex = 1.5;
    scene::OpticalDisc record{};
    record.coverIndex = kIndex;
    scene::Scene scene = under(1.0);
    addObject(scene, scene::Disc{{0.0, 0.0, -1.0}, kZ, 10.0, 0.0}, record);
    EXPECT_NEAR(radianceSeen(scene, {dvec3(0.0), -kZ}), 0.04, kRounding);
    const double brewster = std::atan(kIndex);
    const double perpendicular = (kIndex * kIndex - 1.0) / (kIndex * kIndex + 1.0);
    EXPECT_NEAR(radianceSeen(scene, {dvec3(0.0), dvec3(std::sin(brewster), 0.0, -std::cos(brewster))}),
                0.5 * perpendicular * perpendicular, kRounding);
}

TEST(Path, MetalReflectsTheSkyByFresnel) {
    scene::Scene scene = under(1.0);
    addObject(scene, scene::Plane{{0.0, 0.0, -1.0}, -kZ}, scene::Conductor{scene::Metal::gold});
    for (const double wavelength_nm : {450.0, 532.0, 611.4}) {
        scene.lights[0].spectrum = {{}, {{wavelength_nm * nm, 1.0, 0.0 * nm}}};
        const double share = reflectance(0.8, refractiveIndex(scene::Metal::gold, wavelength_nm * nm));
        const Xyz left = look(scene, {dvec3(0.0), {0.6, 0.0, -0.8}}).xyz;
        EXPECT_LT(glm::length(left - share * filmResponse(wavelength_nm)), kRounding);
    }
}

TEST(Path, DepthCountsMirrorsAndGlass) {
    // A corner of two mirrors, with a lamp that is seen after both.
    scene::Scene scene;
    addObject(scene, scene::Plane{{0.0, 0.0, -1.0}, kZ}, scene::Conductor{scene::Metal::silver});
    addObject(scene, scene::Plane{{1.0, 0.0, 0.0}, -kX}, scene::Conductor{scene::Metal::silver});
    addObject(scene, scene::Rectangle{{0.0, 0.0, 4.0}, {0.0, 3.0, 0.0}, {3.0, 0.0, 0.0}},
              scene::Emissive{1.0 * W_per_m2_sr, {{}, {{549.1 * nm, 1.0, 0.0 * nm}}}, false});  // faces -z
    const Ray ray{{0.5, 0.0, 0.0}, glm::normalize(dvec3(0.4, 0.0, -1.0))};
    EXPECT_EQ(look(scene, ray, 0).xyz, Xyz(0.0));
    EXPECT_EQ(look(scene, ray, 1).xyz, Xyz(0.0));
    const double first =
        reflectance(1.0 / std::sqrt(1.16), refractiveIndex(scene::Metal::silver, 549.1 * nm));
    const double second =
        reflectance(0.4 / std::sqrt(1.16), refractiveIndex(scene::Metal::silver, 549.1 * nm));
    const double one = filmResponse(549.1).y;
    EXPECT_NEAR(look(scene, ray, 2).xyz.y, first * second * one, kRounding);
    EXPECT_DOUBLE_EQ(look(scene, {dvec3(0.0), kZ}, 0).xyz.y, one) << "a lamp is no bounce";
}

// A ray that enters a sphere under the angle i leaves it turned by 2 (i - r), sin i = n sin r.
TEST(Path, GlassSphereTurnsARayBySnellsLaw) {
    const double height = 0.6;
    const double turn = 2.0 * (std::asin(height) - std::asin(height / 1.5));
    // It leaves at the height that makes its direction pass the sphere's centre at `height` again.
    const dvec3 out(std::cos(turn), -std::sin(turn), 0.0);
    const dvec3 passing = height * dvec3(std::sin(turn), std::cos(turn), 0.0);

    scene::Scene scene;
    addObject(scene, scene::Sphere{dvec3(0.0), 1.0}, scene::Dielectric{1.5});
    addObject(scene, scene::Disc{passing + 3.0 * out, -out, 1e-7, 0.0},
              glowing(1.0));  // a target of 0.1 micrometres
    const double straight = 1.0 - reflectance(0.8, 1.5);
    // A path starts a nanometre off each surface.
    EXPECT_NEAR(radianceSeen(scene, {{-3.0, height, 0.0}, kX}), straight * straight, 1e-9);
}

// Inside a glass box, 60 degrees on the face at x = 1, which reflects all, then 30 degrees on the face at y
// = 1.
TEST(Path, TotalReflectionKeepsAllLight) {
    scene::Scene scene;
    addObject(scene, scene::Box{dvec3(0.0), kX, kY, kZ}, scene::Dielectric{1.5});
    addObject(scene, scene::Plane{{5.0, 0.0, 0.0}, -kX}, glowing(100.0));
    addObject(scene, scene::Plane{{0.0, 5.0, 0.0}, -kY}, glowing(1.0));
    const Ray ray{{0.9, 0.0, 0.0}, {0.5, std::sqrt(0.75), 0.0}};
    EXPECT_EQ(radianceSeen(scene, ray, 1), 0.0) << "nothing goes through the first face";
    EXPECT_NEAR(radianceSeen(scene, ray, 2), 1.0 - reflectance(std::sqrt(0.75), 1.0 / 1.5), kRounding);
}

TEST(Path, EmittersShineFromTheirFront) {
    scene::Scene scene;
    addObject(scene, squareFacingZ(0.0, 1.0), glowing(2.0));
    EXPECT_NEAR(radianceSeen(scene, {kZ, -kZ}), 2.0, kRounding);
    EXPECT_EQ(radianceSeen(scene, {-kZ, kZ}), 0.0);
    scene::Scene both;
    addObject(both, squareFacingZ(0.0, 1.0), glowing(2.0, true));
    EXPECT_NEAR(radianceSeen(both, {-kZ, kZ}), 2.0, kRounding);

    scene::Scene lamp;
    addLight(lamp, scene::AreaLight{scene::Sphere{dvec3(0.0), 0.5}, 8.0 * W, false});
    const double radiance = 8.0 / (std::numbers::pi * std::numbers::pi);  // area is pi square metres
    EXPECT_LT(glm::length(seen(lamp, {kZ, -kZ}) - Rgb(radiance)), kRounding);
}

TEST(Path, MattSurfacesAreLambertian) {
    scene::Scene scene;
    addObject(scene, squareFacingZ(0.0, 10.0), grey(0.8));
    addLight(scene, scene::PointLight{{0.0, 0.0, 2.0}, 50.0 * W});
    const double expected = 0.8 * 50.0 / (16.0 * std::numbers::pi) / std::numbers::pi;
    EXPECT_NEAR(radianceSeen(scene, {{3.0, 0.0, 4.0}, {-0.6, 0.0, -0.8}}), expected, kRounding);
    EXPECT_EQ(radianceSeen(scene, {-kZ, kZ}), 0.0) << "lit from the other side";
    scene.lights.clear();
    addLight(scene, scene::PointLight{{0.0, 0.0, -2.0}, 50.0 * W});
    EXPECT_NEAR(radianceSeen(scene, {-kZ, kZ}), expected, kRounding) << "both sides are matt";
}

TEST(Path, DiscOfTheThesisAddsItsPatternOncePerLight) {
    const scene::Disc disc{dvec3(0.0), kZ, 0.06, 0.0125};
    const scene::ThesisDisc material{{4, 6.0 * um, 8.3 * um}, 0.6, scene::Faults::limit};
    scene::Scene scene = under(0.5);
    addObject(scene, disc, material);
    addLight(scene, scene::PointLight{{1.0, 1.0, 1.0}, 9.0 * W}, {1.0, 0.0, 0.25});
    addLight(scene, gratingAt(kZ, kZ, kY), {0.5, 0.0, 0.5});

    const Ray ray{dvec3(0.04, 0.0, 0.0) - dvec3(0.1, 0.2, -1.0), glm::normalize(dvec3(0.1, 0.2, -1.0))};
    const Rgb pattern = discPattern(material, disc, {0.04, 0.0, 0.0}, ray.direction);
    const Rgb expected = Rgb(1.5, 0.0, 0.75) * pattern;
    // Where the pattern is steep, rounding of the hit point by 1e-16 of 0.04 m turns its radius.
    EXPECT_LT(glm::length(seen(scene, ray) - (expected + 0.6 * 0.5)), 1e-11);
    EXPECT_LT(glm::length(seen(scene, ray, 0) - expected), 1e-11) << "the pattern is no bounce";
}

TEST(Path, WhatIsNotFiniteIsFlaggedThroughMirrors) {
    scene::Scene scene;
    addObject(scene, squareFacingZ(0.0, 1.0), grey(0.5));
    addObject(scene, scene::Plane{{0.0, 0.0, 5.0}, -kZ}, scene::Conductor{scene::Metal::copper});
    addLight(scene, gratingAt(2.0 * kZ, -kZ, kY, scene::Faults::asPrinted));
    EXPECT_TRUE(look(scene, {kZ, -kZ}).nonFinite);
    EXPECT_TRUE(look(scene, {kZ, kZ}).nonFinite);
    EXPECT_FALSE(look(scene, {{0.1, 0.0, 1.0}, -kZ}).nonFinite);
}

}  // namespace
}  // namespace fringe::oracle
