// Which shapes are taken to throw no shadow.
#include "compile/casters.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "compile/compiled_scene.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

using compile::shadowCasters;

scene::Scene room() {
    return sceneFile("scenes/thesis/figure-24.json");
}

TEST(ShadowCasters, TheWallsOfARoomAreNone) {
    EXPECT_EQ(shadowCasters(room()), std::vector<bool>(5, false));
    const compile::CompiledScene compiled = compile::compileScene(room());
    EXPECT_EQ(compile::specialise(compiled, room().camera).RECTANGLE_CASTERS, 0U);
    EXPECT_EQ(compile::specialise(compiled, room().camera).HAS_SHADOWS, 0U);
}

TEST(ShadowCasters, WhatStandsInTheRoomIsOne) {
    scene::Scene scene = room();
    scene.objects.push_back({"", scene::Sphere{{0, 0, 0}, 0.2}, 0});
    EXPECT_EQ(shadowCasters(scene), (std::vector<bool>{false, false, false, false, false, true}));
}

TEST(ShadowCasters, AWallWithALampBehindItIsOne) {
    scene::Scene scene = room();
    scene.lights.push_back({"", {1, 1, 1}, {}, scene::PointLight{{0, 0, -2}, 1.0 * units::W}});
    EXPECT_EQ(shadowCasters(scene), (std::vector<bool>{true, false, false, false, false}));
}

TEST(ShadowCasters, ASkyMakesAllWallsCasters) {
    scene::Scene scene = room();
    scene.lights.push_back({"", {1, 1, 1}, {}, scene::EnvironmentLight{1.0 * units::W_per_m2_sr}});
    EXPECT_EQ(shadowCasters(scene), std::vector<bool>(5, true));
}

TEST(ShadowCasters, ASunFromAboveNeedsTheCeilingAlone) {
    scene::Scene scene = room();
    scene.lights.push_back({"", {1, 1, 1}, {}, scene::DirectionalLight{{0, -1, 0}, 1.0 * units::W_per_m2}});
    EXPECT_EQ(shadowCasters(scene), (std::vector<bool>{false, false, true, false, false}));
}

// A ball under the lamp, above what the picture shows: with its shadow, without it, and without the ball.
TEST(ShadowsOnDevice, AreNotThereWhereTheSceneCastsNone) {
    scene::Scene scene = room();
    scene.image.width = scene.image.height = 64;
    scene.camera.target = {0.0, -1.0, 0.0};
    scene.camera.position = {0.0, -0.5, 0.0};
    scene.camera.up = {0.0, 0.0, -1.0};
    const image::Image without = renderOnDevice(scene);
    scene.objects.push_back({"", scene::Sphere{{0, 0.5, 0}, 0.2}, 0});
    const image::Image shadow = renderOnDevice(scene);
    scene.castsShadows = false;
    EXPECT_EQ(compile::specialise(compile::compileScene(scene), scene.camera).HAS_SHADOWS, 0U);
    const image::Image none = renderOnDevice(scene);
    double difference = 0.0, change = 0.0;
    for (std::size_t i = 0; i < none.pixels.size(); ++i) {
        difference = std::max(difference, distance(none.pixels[i], without.pixels[i]));
        change = std::max(change, distance(shadow.pixels[i], without.pixels[i]));
    }
    EXPECT_EQ(difference, 0.0);
    EXPECT_GT(change, 0.01);
}

}  // namespace
}  // namespace fringe::testing
