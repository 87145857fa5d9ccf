// Rays through the picture against the definition of the image plane.
#include "oracle/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.hpp"

namespace fringe::oracle {
namespace {

using namespace units;

constexpr double kFewRoundings = 1e-14;
constexpr glm::dvec2 kMiddle(0.5);

void expectNear(const dvec3& a, const dvec3& b) {
    EXPECT_LT(glm::length(a - b), kFewRoundings) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Camera, RowZeroIsTheTop) {
    // 90 degrees up and down: the picture's upper edge is 45 degrees up; it is twice as wide as high.
    const Camera camera(
        {dvec3(0.0), {0.0, 0.0, -5.0}, {0.0, 3.0, 0.0}, scene::Perspective{90.0 * deg, {}}, {}}, 200, 100);
    expectNear(camera.ray({100.0, 50.0}, kMiddle).direction, {0.0, 0.0, -1.0});
    expectNear(camera.ray({100.0, 0.0}, kMiddle).direction, glm::normalize(dvec3(0.0, 1.0, -1.0)));
    expectNear(camera.ray({200.0, 50.0}, kMiddle).direction, glm::normalize(dvec3(2.0, 0.0, -1.0)));
    expectNear(camera.ray({0.0, 100.0}, kMiddle).direction, glm::normalize(dvec3(-2.0, -1.0, -1.0)));
}

TEST(Camera, UpNeedNotBePerpendicular) {
    const Camera camera(
        {{1.0, 2.0, 3.0}, {2.0, 3.0, 3.0}, {0.0, 1.0, 0.0}, scene::Perspective{60.0 * deg, {}}, {}}, 10, 10);
    const Ray top = camera.ray({5.0, 0.0}, kMiddle);
    expectNear(top.origin, {1.0, 2.0, 3.0});
    const double up = std::tan(30.0 * deg.si) * std::sqrt(0.5);
    expectNear(top.direction, glm::normalize(dvec3(std::sqrt(0.5) - up, std::sqrt(0.5) + up, 0.0)));
}

TEST(Camera, OrthographicRaysAreParallel) {
    const Camera camera({{0.0, 0.0, 1.0}, dvec3(0.0), {0.0, 1.0, 0.0}, scene::Orthographic{4.0}, {}}, 20, 10);
    const Ray corner = camera.ray({20.0, 0.0}, kMiddle);
    expectNear(corner.origin, {4.0, 2.0, 1.0});
    expectNear(corner.direction, {0.0, 0.0, -1.0});
}

TEST(Camera, RaysOfAPointMeetInThePlaneInFocus) {
    const scene::ThinLens lens{10.0 * mm, 2.0 * m};
    const Camera camera(
        {dvec3(0.0), {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, scene::Perspective{90.0 * deg, lens}, {}}, 10, 10);
    const dvec3 inFocus(1.2, -0.8, -2.0);  // of the point (8, 7) in the picture
    double widest = 0.0;
    for (double u = 0.0; u < 1.0; u += 0.09) {
        for (double v = 0.0; v < 1.0; v += 0.09) {
            const Ray ray = camera.ray({8.0, 7.0}, {u, v});
            EXPECT_EQ(ray.origin.z, 0.0);
            widest = std::max(widest, glm::length(ray.origin));
            expectNear(ray.at(glm::length(inFocus - ray.origin)), inFocus);
        }
    }
    EXPECT_LE(widest, 5e-3 + 1e-15);
    EXPECT_GT(widest, 4.9e-3);
    expectNear(camera.ray({8.0, 7.0}, kMiddle).origin, dvec3(0.0));
}

}  // namespace
}  // namespace fringe::oracle
