// How wrong an answer about a ray and a shape is: cases known in closed form.
#include "qualify/shape_measure.hpp"

#include <gtest/gtest.h>

namespace fringe::qualify {
namespace {

using glm::dvec3;
using oracle::Ray;

constexpr double kMiss = -1.0;

TEST(ShapeMeasure, RightAnswersAreRight) {
    const ShapeMeasure sphere = ShapeMeasure::ofSphere(dvec3(0.0), 1.0);
    const Ray ray{dvec3(0.0, 0.0, 5.0), dvec3(0.0, 0.0, -1.0)};
    EXPECT_EQ(sphere.distance(ray), 4.0);
    EXPECT_EQ(sphere.shift(ray, 4.0, 4.0), 0.0);
    const Ray past{dvec3(0.0, 2.0, 5.0), dvec3(0.0, 0.0, -1.0)};
    EXPECT_EQ(sphere.distance(past), kMiss);
    EXPECT_EQ(sphere.shift(past, kMiss, kMiss), 0.0);
}

// In units of the largest length, 5 here.
TEST(ShapeMeasure, AHitBesideTheSurfaceIsOffByItsDistance) {
    const ShapeMeasure sphere = ShapeMeasure::ofSphere(dvec3(0.0), 1.0);
    const Ray ray{dvec3(0.0, 0.0, 5.0), dvec3(0.0, 0.0, -1.0)};
    EXPECT_NEAR(sphere.shift(ray, 3.9, 4.0), 0.1 / 5.0, 1e-12);
    EXPECT_NEAR(sphere.shift(ray, 6.0, 4.0), 1.0 / 6.0, 1e-6);  // the far side: it went 1 deep
    EXPECT_NEAR(sphere.shift(ray, kMiss, 4.0), 1.0 / 5.0, 1e-6);
}

// A grazing ray that is 1e-6 deep inside may as well miss: that is all that is wrong.
TEST(ShapeMeasure, GrazingRaysAreJudgedByTheirDepth) {
    const ShapeMeasure sphere = ShapeMeasure::ofSphere(dvec3(0.0), 1.0);
    const Ray ray{dvec3(0.0, 1.0 - 1e-6, 5.0), dvec3(0.0, 0.0, -1.0)};
    const double hit = sphere.distance(ray);
    EXPECT_NEAR(hit, 5.0 - 1.414e-3, 1e-5);
    EXPECT_NEAR(sphere.shift(ray, kMiss, hit), 1e-6 / 5.1, 1e-8);
    EXPECT_LT(sphere.shift(ray, 5.0, hit), 1.1e-6 / 5.0);
}

TEST(ShapeMeasure, ASolidThatTheRayLeavesAtTheRimWasPassedThrough) {
    const ShapeMeasure cylinder = ShapeMeasure::ofCylinder(dvec3(0.0), dvec3(0.0, 0.0, 1.0), 2.0, 1.0, true);
    const dvec3 direction = glm::normalize(dvec3(1.0, 0.0, -1.0));
    const Ray ray{dvec3(-1.0, 0.0, 2.0) - 2.0 * direction, direction};  // at the rim
    EXPECT_NEAR(cylinder.distance(ray), 2.0, 1e-9);
    EXPECT_GT(cylinder.shift(ray, 2.0 + 2.0 * std::sqrt(2.0), 2.0), 0.1);
}

TEST(ShapeMeasure, SheetsEndAtTheirRims) {
    const ShapeMeasure rectangle = ShapeMeasure::ofRectangle(dvec3(0.0), dvec3(1.0, 0.0, 0.0),
                                                             dvec3(0.0, 0.5, 0.0));  // 1 x 2 from the middle
    const auto down = [](double x, double y) { return Ray{dvec3(x, y, 4.0), dvec3(0.0, 0.0, -1.0)}; };
    EXPECT_EQ(rectangle.distance(down(0.9, 1.9)), 4.0);
    EXPECT_EQ(rectangle.distance(down(0.9, 2.1)), kMiss);
    EXPECT_NEAR(rectangle.shift(down(0.9, 2.1), 4.0, kMiss) * std::sqrt(16.0 + 0.81 + 4.41), 0.1, 1e-9);
    EXPECT_NEAR(rectangle.shift(down(0.9, 0.0), kMiss, 4.0) * std::sqrt(16.0 + 0.81), 0.1, 1e-9);
}

}  // namespace
}  // namespace fringe::qualify
