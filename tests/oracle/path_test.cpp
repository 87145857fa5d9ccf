// Chains of mirrors and glass against what must come out of them.
#include "oracle/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "oracle/fresnel.hpp"
#include "oracle/metals.hpp"
#include "oracle/thesis.hpp"
#include "scenes.hpp"

namespace fringe::oracle {
namespace {

using namespace units;

constexpr dvec3 kX(1.0, 0.0, 0.0), kY(0.0, 1.0, 0.0), kZ(0.0, 0.0, 1.0);
constexpr double kRounding = 1e-13;

Value look(const scene::Scene& scene, const Ray& ray, std::uint32_t maxDepth = 8) {
    const World world = makeWorld(scene);
    const Sampler sampler(0, 0, 0, 1);
    return Tracer(world, sampler, maxDepth).radiance(ray, {});
}

scene::Scene under(double radiance) {
    scene::Scene scene;
    addLight(scene, scene::EnvironmentLight{radiance * W_per_m2_sr});
    return scene;
}

TEST(Path, WhatMissesSeesTheEnvironment) {
    EXPECT_EQ(look(under(3.0), {dvec3(0.0), kX}).rgb, Rgb(3.0));
    EXPECT_EQ(look({}, {dvec3(0.0), kX}).rgb, Rgb(0.0));
}

// A convex matt body under an even sky is as bright as the sky times its reflectance, everywhere.
TEST(Path, MattSphereInAFurnace) {
    scene::Scene scene = under(2.0);
    addObject(scene, scene::Sphere{{0.0, 0.0, -3.0}, 1.0}, scene::Diffuse{{0.75, 0.5, 0.0}});
    const Rgb seen = look(scene, {dvec3(0.0), glm::normalize(dvec3(0.1, 0.2, -1.0))}).rgb;
    EXPECT_LT(glm::length(seen - Rgb(1.5, 1.0, 0.0)), kRounding);
}

// Glass neither makes nor keeps light: it cannot be told from the sky, but for the branches dropped as too
// faint.
TEST(Path, GlassInAFurnaceIsInvisible) {
    scene::Scene scene = under(1.0);
    addObject(scene, scene::Sphere{{0.0, 0.0, -3.0}, 1.0}, scene::Dielectric{1.5});
    addObject(scene, scene::Box{{0.0, 0.0, -6.0}, kX, kY, kZ}, scene::Dielectric{1.3});
    for (double x = 0.0; x < 0.33; x += 0.01) {
        const double seen = look(scene, {dvec3(0.0), glm::normalize(dvec3(x, 0.02, -1.0))}, 64).rgb.g;
        EXPECT_LE(seen, 1.0 + kRounding);
        EXPECT_GE(seen, 1.0 - 16.0 / 4096.0);  // 16 faint branches at two bodies are more than enough
    }
}

TEST(Path, MetalReflectsTheSkyByFresnel) {
    scene::Scene scene = under(1.0);
    addObject(scene, scene::Plane{{0.0, 0.0, -1.0}, -kZ}, scene::Conductor{scene::Metal::gold});
    const Rgb seen = look(scene, {dvec3(0.0), {0.6, 0.0, -0.8}}).rgb;
    EXPECT_NEAR(seen.r, reflectance(0.8, refractiveIndex(scene::Metal::gold, 611.4 * nm)), kRounding);
    EXPECT_NEAR(seen.g, reflectance(0.8, refractiveIndex(scene::Metal::gold, 549.1 * nm)), kRounding);
    EXPECT_NEAR(seen.b, reflectance(0.8, refractiveIndex(scene::Metal::gold, 464.2 * nm)), kRounding);
}

TEST(Path, DepthCountsMirrorsAndGlass) {
    // A corner of two mirrors, with a lamp that is seen after both.
    scene::Scene scene;
    addObject(scene, scene::Plane{{0.0, 0.0, -1.0}, kZ}, scene::Conductor{scene::Metal::silver});
    addObject(scene, scene::Plane{{1.0, 0.0, 0.0}, -kX}, scene::Conductor{scene::Metal::silver});
    addObject(scene, scene::Rectangle{{0.0, 0.0, 4.0}, {0.0, 3.0, 0.0}, {3.0, 0.0, 0.0}},
              glowing(1.0));  // faces -z
    const Ray ray{{0.5, 0.0, 0.0}, glm::normalize(dvec3(0.4, 0.0, -1.0))};
    EXPECT_EQ(look(scene, ray, 0).rgb, Rgb(0.0));
    EXPECT_EQ(look(scene, ray, 1).rgb, Rgb(0.0));
    const double first =
        reflectance(1.0 / std::sqrt(1.16), refractiveIndex(scene::Metal::silver, 549.1 * nm));
    const double second =
        reflectance(0.4 / std::sqrt(1.16), refractiveIndex(scene::Metal::silver, 549.1 * nm));
    EXPECT_NEAR(look(scene, ray, 2).rgb.g, first * second, kRounding);
    EXPECT_EQ(look(scene, {dvec3(0.0), kZ}, 0).rgb, Rgb(1.0)) << "a lamp is no bounce";
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
    EXPECT_NEAR(look(scene, {{-3.0, height, 0.0}, kX}).rgb.g, straight * straight, 1e-9);
}

// Inside a glass box, 60 degrees on the face at x = 1, which reflects all, then 30 degrees on the face at y
// = 1.
TEST(Path, TotalReflectionKeepsAllLight) {
    scene::Scene scene;
    addObject(scene, scene::Box{dvec3(0.0), kX, kY, kZ}, scene::Dielectric{1.5});
    addObject(scene, scene::Plane{{5.0, 0.0, 0.0}, -kX}, glowing(100.0));
    addObject(scene, scene::Plane{{0.0, 5.0, 0.0}, -kY}, glowing(1.0));
    const Ray ray{{0.9, 0.0, 0.0}, {0.5, std::sqrt(0.75), 0.0}};
    EXPECT_EQ(look(scene, ray, 1).rgb, Rgb(0.0)) << "nothing goes through the first face";
    EXPECT_NEAR(look(scene, ray, 2).rgb.g, 1.0 - reflectance(std::sqrt(0.75), 1.0 / 1.5), kRounding);
}

TEST(Path, EmittersShineFromTheirFront) {
    scene::Scene scene;
    addObject(scene, squareFacingZ(0.0, 1.0), glowing(2.0));
    EXPECT_EQ(look(scene, {kZ, -kZ}).rgb, Rgb(2.0));
    EXPECT_EQ(look(scene, {-kZ, kZ}).rgb, Rgb(0.0));
    scene::Scene both;
    addObject(both, squareFacingZ(0.0, 1.0), glowing(2.0, true));
    EXPECT_EQ(look(both, {-kZ, kZ}).rgb, Rgb(2.0));

    scene::Scene lamp;
    addLight(lamp, scene::AreaLight{scene::Sphere{dvec3(0.0), 0.5}, 8.0 * W, false}, {1.0, 0.0, 0.5});
    const double radiance = 8.0 / (std::numbers::pi * std::numbers::pi);  // area is pi square metres
    EXPECT_LT(glm::length(look(lamp, {kZ, -kZ}).rgb - radiance * Rgb(1.0, 0.0, 0.5)), kRounding);
}

TEST(Path, MattSurfacesAreLambertian) {
    scene::Scene scene;
    addObject(scene, squareFacingZ(0.0, 10.0), scene::Diffuse{{0.8, 0.4, 0.2}});
    addLight(scene, scene::PointLight{{0.0, 0.0, 2.0}, 50.0 * W});
    const double irradiance = 50.0 / (16.0 * std::numbers::pi);
    const Rgb expected = irradiance / std::numbers::pi * Rgb(0.8, 0.4, 0.2);
    EXPECT_LT(glm::length(look(scene, {{3.0, 0.0, 4.0}, {-0.6, 0.0, -0.8}}).rgb - expected), kRounding);
    EXPECT_EQ(look(scene, {-kZ, kZ}).rgb, Rgb(0.0)) << "lit from the other side";
    scene.lights.clear();
    addLight(scene, scene::PointLight{{0.0, 0.0, -2.0}, 50.0 * W});
    EXPECT_LT(glm::length(look(scene, {-kZ, kZ}).rgb - expected), kRounding) << "both sides are matt";
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
    EXPECT_LT(glm::length(look(scene, ray).rgb - (expected + 0.6 * 0.5)), 1e-11);
    EXPECT_LT(glm::length(look(scene, ray, 0).rgb - expected), 1e-11) << "the pattern is no bounce";
}

TEST(Path, WhatIsNotFiniteIsFlaggedThroughMirrors) {
    scene::Scene scene;
    addObject(scene, squareFacingZ(0.0, 1.0), scene::Diffuse{Rgb(0.5)});
    addObject(scene, scene::Plane{{0.0, 0.0, 5.0}, -kZ}, scene::Conductor{scene::Metal::copper});
    addLight(scene, gratingAt(2.0 * kZ, -kZ, kY, scene::Faults::asPrinted));
    EXPECT_TRUE(look(scene, {kZ, -kZ}).nonFinite);
    EXPECT_TRUE(look(scene, {kZ, kZ}).nonFinite);
    EXPECT_FALSE(look(scene, {{0.1, 0.0, 1.0}, -kZ}).nonFinite);
}

}  // namespace
}  // namespace fringe::oracle
