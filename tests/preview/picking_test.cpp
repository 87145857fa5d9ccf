// From pixels to surfaces and back.
#include "preview/picking.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace fringe::preview {
namespace {

using namespace units;
using glm::dvec3;

constexpr double kRounding = 1e-9;  // metres; the reference's intersections lift off surfaces by as much

// A ball in front of a wall, and a lamp at its left; 200 x 100 pixels.
scene::Scene room() {
    scene::Scene scene;
    scene.image.width = 200;
    scene.image.height = 100;
    scene.camera = {{0, 0, 2}, {0, 0, 0}, {0, 1, 0}, scene::Perspective{90.0 * deg, {}}, {}};
    scene.objects = {{"wall", scene::Plane{{0, 0, -1}, {0, 0, -1}}, 0},
                     {"ball", scene::Sphere{{0, 0, 0}, 0.5}, 0}};
    scene.lights = {
        {"lamp",
         {1, 1, 1},
         {},
         scene::AreaLight{scene::Rectangle{{-2, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, 1.0 * W, true}}};
    return scene;
}

TEST(Picking, FindsTheNearestSurfaceAndItsSideTowardsTheCamera) {
    const scene::Scene scene = room();
    const auto ball = pickAt(scene, scene.camera, {100, 50});
    ASSERT_TRUE(ball);
    EXPECT_EQ(ball->object, 1U);
    EXPECT_LT(glm::distance(ball->point, dvec3(0, 0, 0.5)), kRounding);
    EXPECT_LT(glm::distance(ball->normal, dvec3(0, 0, 1)), kRounding);
    // 90 degrees: at the wall, 3 m away, half of the height shows 3 m, and so do 50 pixels.
    const auto wall = pickAt(scene, scene.camera, {150, 25});
    ASSERT_TRUE(wall);
    EXPECT_EQ(wall->object, 0U);
    EXPECT_LT(glm::distance(wall->point, dvec3(3, 1.5, -1)), kRounding);
    EXPECT_LT(glm::distance(wall->normal, dvec3(0, 0, 1)), kRounding);
}

TEST(Picking, FindsNothingInTheSkyAndBehindALamp) {
    scene::Scene scene = room();
    EXPECT_FALSE(pickAt(scene, scene.camera, {50, 50}));  // the lamp: 1 m for 25 pixels there
    scene.lights.clear();
    EXPECT_TRUE(pickAt(scene, scene.camera, {50, 50}));
    scene.objects.clear();
    EXPECT_FALSE(pickAt(scene, scene.camera, {100, 50}));
}

// From the right there is a wall on the way, from the front none; a ball around the target is not kept
// within.
TEST(Picking, KeepsTheCameraWithinARoom) {
    scene::Scene scene = room();
    scene.objects = {{"wall", scene::Plane{{1, 0, 0}, {-1, 0, 0}}, 0}};
    scene::Camera outside = scene.camera;
    outside.position = {2, 0, 0};
    EXPECT_LT(glm::distance(withinRoom(scene, outside).position, dvec3(0.98, 0, 0)), kRounding);
    EXPECT_EQ(withinRoom(scene, scene.camera).position, scene.camera.position);
    scene.objects = {{"ball", scene::Sphere{{0, 0, 0}, 0.15}, 0}};
    EXPECT_EQ(withinRoom(scene, outside).position, outside.position);
}

// Back to the pixel, for each camera and for places all over the picture.
TEST(Picking, GoesBackToThePlace) {
    scene::Scene scene = room();
    const scene::Perspective lens{60.0 * deg, scene::ThinLens{10.0 * mm, 2.0 * m}};
    for (const auto& projection : {scene.camera.projection, decltype(scene.camera.projection)(lens),
                                   decltype(scene.camera.projection)(scene::Orthographic{1.5})}) {
        scene.camera = {{1, 0.5, 2}, {0.2, 0, 0}, {0, 1, 0}, projection, {}};
        int found = 0;
        for (double x = 0.5; x < 200.0; x += 9.0) {
            for (double y = 0.5; y < 100.0; y += 9.0) {
                const auto pick = pickAt(scene, scene.camera, {x, y});
                if (!pick) continue;
                const auto place = placeOf(scene.image, scene.camera, pick->point);
                ASSERT_TRUE(place);
                EXPECT_LT(glm::distance(*place, glm::dvec2(x, y)), 1e-5) << x << ' ' << y;
                ++found;
            }
        }
        EXPECT_GT(found, 100);
    }
    EXPECT_FALSE(placeOf(scene.image, scene.camera, {3, 2, 6}));
}

}  // namespace
}  // namespace fringe::preview
