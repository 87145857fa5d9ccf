// Every shape against distances and normals worked out by hand.
#include "oracle/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "oracle/axes.hpp"

namespace fringe::oracle {
namespace {

using glm::normalize;

// Coordinates of a few metres in a handful of operations: 1e-13 is some hundred roundings.

void expectHit(const scene::Shape& shape, const Ray& ray, double distance, const dvec3& normal) {
    const std::optional<Hit> hit = intersect(ray, shape);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, distance, kRounding);
    EXPECT_LT(glm::length(hit->normal - normal), kRounding)
        << hit->normal.x << ' ' << hit->normal.y << ' ' << hit->normal.z;
}

void expectMiss(const scene::Shape& shape, const Ray& ray) {
    EXPECT_FALSE(intersect(ray, shape));
}

TEST(Shapes, PlaneIsHitFromBothSidesWithItsOwnNormal) {
    const scene::Plane floor{{5.0, -1.0, 7.0}, kY};
    expectHit(floor, {{0.0, 1.0, 0.0}, -kY}, 2.0, kY);
    expectHit(floor, {{0.0, -4.0, 0.0}, kY}, 3.0, kY);
    expectHit(floor, {{0.0, 0.0, 0.0}, normalize(dvec3(3.0, -4.0, 0.0))}, 1.25, kY);
    expectMiss(floor, {{0.0, 1.0, 0.0}, kY});
    expectMiss(floor, {{0.0, 1.0, 0.0}, kX});
}

TEST(Shapes, RectangleEndsAtItsHalfEdges) {
    const scene::Rectangle wall{{1.0, 0.0, -2.0}, {2.0, 0.0, 0.0}, {0.0, 0.5, 0.0}};
    expectHit(wall, {{-0.9, 0.49, 0.0}, -kZ}, 2.0, kZ);
    expectHit(wall, {{2.9, -0.49, -5.0}, kZ}, 3.0, kZ);
    expectMiss(wall, {{-1.1, 0.0, 0.0}, -kZ});
    expectMiss(wall, {{0.0, 0.51, 0.0}, -kZ});
}

TEST(Shapes, DiscHasAHole) {
    const scene::Disc disc{{0.0, 0.0, 1.0}, -kZ, 2.0, 0.5};
    expectHit(disc, {{1.2, 1.2, 0.0}, kZ}, 1.0, -kZ);
    expectMiss(disc, {{0.3, 0.3, 0.0}, kZ});
    expectMiss(disc, {{1.5, 1.5, 0.0}, kZ});
}

TEST(Shapes, TriangleCountsCounterClockwise) {
    const scene::Triangle triangle{{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}};
    expectHit(triangle, {{0.9, 0.5, 3.0}, -kZ}, 3.0, kZ);
    expectMiss(triangle, {{1.1, 0.5, 3.0}, -kZ});
    expectMiss(triangle, {{-0.01, 0.5, 3.0}, -kZ});
    const scene::Triangle reversed{{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {2.0, 0.0, 0.0}}};
    expectHit(reversed, {{0.9, 0.5, 3.0}, -kZ}, 3.0, -kZ);
}

TEST(Shapes, SphereFromOutsideAndInside) {
    const scene::Sphere sphere{{0.0, 0.0, -3.0}, 1.0};
    expectHit(sphere, {{0.0, 0.0, 0.0}, -kZ}, 2.0, kZ);
    expectHit(sphere, {{0.6, 0.0, 0.0}, -kZ}, 2.2, {0.6, 0.0, 0.8});
    expectHit(sphere, {{0.0, 0.0, -3.0}, kX}, 1.0, kX);
    expectMiss(sphere, {{1.01, 0.0, 0.0}, -kZ});
    expectMiss(sphere, {{0.0, 0.0, 0.0}, kZ});
}

TEST(Shapes, FarSphereKeepsItsDigits) {
    // 1e6 m away the coefficients of the quadratic are 1e12; a textbook discriminant would err by 1e-4 here.
    const scene::Sphere sphere{{0.0, 0.0, -1e6}, 1.0};
    const std::optional<Hit> hit = intersect({{0.6, 0.0, 0.0}, -kZ}, sphere);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 1e6 - 0.8, 1e-9);  // a few roundings of 1e6
}

TEST(Shapes, BoxTurnedByFortyFiveDegrees) {
    const double h = std::sqrt(0.5);
    const scene::Box box{{0.0, 0.0, 0.0}, {h, 0.0, h}, {0.0, 2.0, 0.0}, {-h, 0.0, h}};  // |u| = |w| = 1
    const Ray fromFront{{0.25, 1.0, 5.0}, -kZ};
    expectHit(box, fromFront, 5.0 - (2.0 * h - 0.25), normalize(dvec3(1.0, 0.0, 1.0)));
    expectHit(box, {{0.0, 0.5, 0.0}, kY}, 1.5, kY);  // from inside
    expectMiss(box, {{0.25, 2.1, 5.0}, -kZ});
    expectMiss(box, {{1.5, 0.0, 5.0}, -kZ});
}

TEST(Shapes, BoxIsSixRectangles) {
    const scene::Box box{{0.1, 0.2, 0.3}, {1.0, 0.0, 0.0}, {0.0, 0.3, 0.4}, {0.0, -0.8, 0.6}};
    const dvec3 edges[3] = {box.u, box.v, box.w};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto point = [&] { return dvec3(coordinate(random), coordinate(random), coordinate(random)); };
        const dvec3 origin = point();
        const Ray ray{origin, normalize(0.5 * point() - origin)};
        std::optional<Hit> expected;
        for (int face = 0; face < 6; ++face) {
            const double side = face % 2 == 0 ? 1.0 : -1.0;
            const dvec3 out = side * edges[face / 2];
            // u x v points outwards for the half edges in this order.
            const scene::Rectangle rectangle{box.center + out, side * edges[(face / 2 + 1) % 3],
                                             edges[(face / 2 + 2) % 3]};
            const std::optional<Hit> hit = intersect(ray, rectangle);
            if (hit && (!expected || hit->distance < expected->distance)) expected = hit;
        }
        if (expected) {
            expectHit(box, ray, expected->distance, expected->normal);
            ++hits;
        } else {
            expectMiss(box, ray);
        }
    }
    EXPECT_GT(hits, 500);
}

TEST(Shapes, CylinderWallAndCaps) {
    const scene::Cylinder closed{{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, 0.5, true};
    expectHit(closed, {{0.3, 0.9, 3.0}, -kZ}, 2.6, {0.6, 0.0, 0.8});
    expectHit(closed, {{0.3, 3.0, 0.3}, -kY}, 2.0, kY);
    expectHit(closed, {{0.3, -3.0, 0.3}, kY}, 2.0, -kY);
    expectHit(closed, {{0.0, 0.0, 0.0}, kY}, 1.0, kY);  // from inside
    expectMiss(closed, {{0.3, 1.1, 3.0}, -kZ});
    expectMiss(closed, {{0.4, 3.0, 0.4}, -kY});
}

TEST(Shapes, OpenCylinderShowsItsInside) {
    const scene::Cylinder open{{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, 0.5, false};
    expectMiss(open, {{0.0, 3.0, 0.0}, -kY});
    // In at the open top, 45 degrees down, to the wall half a metre further; the normal stays the outward
    // one.
    expectHit(open, {{0.0, 1.0, 0.0}, normalize(dvec3(1.0, -1.0, 0.0))}, std::sqrt(0.5), kX);
}

TEST(Shapes, ConeWallAndCap) {
    // Half angle 45 degrees, apex up at y = 1, base in y = 0.
    const scene::Cone closed{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 1.0, true};
    expectHit(closed, {{0.0, 0.5, 3.0}, -kZ}, 2.5, normalize(dvec3(0.0, 1.0, 1.0)));
    expectHit(closed, {{0.3, 0.5, 3.0}, -kZ}, 2.6, normalize(dvec3(0.3, 0.5, 0.4)));
    expectHit(closed, {{0.25, 4.0, 0.0}, -kY}, 3.25, normalize(dvec3(1.0, 1.0, 0.0)));
    expectHit(closed, {{0.25, -4.0, 0.0}, kY}, 4.0, -kY);
    expectHit(closed, {{0.0, 0.25, 0.0}, -kY}, 0.25, -kY);  // from inside, through the base
    // Along the wall's own slope the quadratic has no square.
    expectHit(closed, {{-0.5, 0.0, 0.0}, normalize(dvec3(1.0, 1.0, 0.0))}, 0.75 * std::sqrt(2.0),
              normalize(dvec3(1.0, 1.0, 0.0)));
    expectMiss(closed, {{0.6, 0.5, 3.0}, -kZ});
    expectMiss(closed, {{0.0, 1.5, 3.0}, -kZ});  // would hit the mirrored nappe above the apex
}

TEST(Shapes, OpenConeHasNoBase) {
    const scene::Cone open{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 1.0, false};
    expectHit(open, {{0.25, -4.0, 0.0}, kY}, 4.75, normalize(dvec3(1.0, 1.0, 0.0)));
}

}  // namespace
}  // namespace fringe::oracle
