// Which shapes are taken to throw no shadow.
#include "compile/casters.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace fringe::testing
