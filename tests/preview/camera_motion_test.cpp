// Moving a camera: what stays, and which way it goes.
#include "preview/camera_motion.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numbers>

namespace fringe::preview {
namespace {

using glm::dvec3;

constexpr double kFewRoundings = 1e-12;  // a few operations in double precision on values near 1

scene::Camera cameraAt(const dvec3& position) {
    return {position, dvec3(0.0), dvec3(0, 1, 0), scene::Perspective{90.0 * units::deg, {}}, {}};
}

void expectNear(const dvec3& a, const dvec3& b) {
    EXPECT_LT(glm::distance(a, b), kFewRoundings) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Orbit, TurnsAroundTheTargetAtTheSameDistance) {
    const scene::Camera turned = orbited(cameraAt({0, 0, 2}), 0.5 * std::numbers::pi, 0.0);
    expectNear(turned.position, {2, 0, 0});
    expectNear(turned.target, dvec3(0.0));
    const scene::Camera raised = orbited(cameraAt({0, 0, 2}), 0.0, 0.25 * std::numbers::pi);
    expectNear(raised.position, {0, std::numbers::sqrt2, std::numbers::sqrt2});
}

TEST(Orbit, StopsBeforeThePoleSoThatUpStaysUp) {
    scene::Camera camera = cameraAt({0.3, 0.1, 2});
    for (int i = 0; i < 20; ++i) camera = orbited(camera, 0.1, 0.4);
    const dvec3 forward = glm::normalize(camera.target - camera.position);
    EXPECT_LT(forward.y, 0.0);
    EXPECT_GT(glm::length(glm::cross(forward, camera.up)), 0.01);
}

TEST(Orbit, LeavesAViewFromThePole) {
    const scene::Camera top = seenFrom(cameraAt({0, 0, 2}), Side::top);
    expectNear(top.position, {0, 2, 0});
    const scene::Camera turned = orbited(top, 0.3, 0.3);
    EXPECT_NEAR(glm::distance(turned.position, turned.target), 2.0, kFewRoundings);
    EXPECT_GT(glm::length(glm::cross(turned.target - turned.position, turned.up)), 0.01);
}

// With 90 degrees at a distance of 2 the picture is 4 high there; what is seen moves with the mouse.
TEST(Pan, MovesWhatIsSeenAlong) {
    const scene::Camera panned = preview::panned(cameraAt({0, 0, 2}), 0.25, 0.5);
    expectNear(panned.target, {-1, -2, 0});
    expectNear(panned.position, {-1, -2, 2});
}

TEST(Dolly, ScalesTheDistanceOrTheHeight) {
    expectNear(dollied(cameraAt({0, 0, 2}), 0.5).position, {0, 0, 1});
    scene::Camera flat = cameraAt({0, 0, 2});
    flat.projection = scene::Orthographic{3.0};
    EXPECT_EQ(std::get<scene::Orthographic>(dollied(flat, 0.5).projection).height, 1.5);
}

TEST(Flight, FollowsTheAxesOfTheCamera) {
    const scene::Camera flown = preview::flown(cameraAt({2, 0, 0}), {1, 2, 3});
    expectNear(flown.position, {-1, 2, -1});
    expectNear(flown.target, {-3, 2, -1});
}

TEST(Presets, LookAtTheTargetFromTheSameDistance) {
    for (const Side side : {Side::front, Side::back, Side::left, Side::right, Side::top, Side::bottom}) {
        const scene::Camera camera = seenFrom(cameraAt({1, 2, 2}), side);
        EXPECT_NEAR(glm::length(camera.position), 3.0, kFewRoundings);
        EXPECT_NEAR(glm::dot(camera.position, camera.up), 0.0, kFewRoundings);
    }
}

}  // namespace
}  // namespace fringe::preview
