// Lines on surfaces, and the pictures that are taken of them.
#include "profile/surface.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "profile/sampling.hpp"

namespace fringe::profile {
namespace {

using namespace units;

// One object of a white material.
scene::Scene sceneOf(scene::Shape shape) {
    scene::Scene scene;
    scene.materials.push_back({"white", scene::Diffuse{optics::constantCurve(0.5)}});
    scene.materials.push_back({"mirror", scene::Conductor{scene::Metal::silver}});
    scene.objects.push_back({"wall", std::move(shape), 0});
    return scene;
}

scene::Rectangle wall() {
    return {{0, 0, -1}, {0.5, 0, 0}, {0, 0.5, 0}};
}

std::string refusal(const scene::Scene& scene, dvec3 from, dvec3 to) {
    try {
        surfaceUnder(scene, from, to, {0, 0, 0});
    } catch (const LineError& error) {
        return error.what();
    }
    return "accepted";
}

void expectSays(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

void expectNear(dvec3 a, dvec3 b, double tolerance = 1e-12) {
    EXPECT_LE(glm::distance(a, b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " instead of " << b.x << ' ' << b.y << ' ' << b.z;
}

struct FootCase {
    scene::Shape shape;
    dvec3 point, foot, normal;
    bool twoSided;
};

// Points 0.1 off each kind of surface, straight over a point that is easy to name.
TEST(Foot, IsTheNearestPointWithItsNormal) {
    const double r = std::sqrt(0.5);
    const std::vector<FootCase> cases{
        {scene::Plane{{0, 2, 0}, {0, 1, 0}}, {3, 2.1, 4}, {3, 2, 4}, {0, 1, 0}, true},
        {wall(), {0.2, 0.3, -0.9}, {0.2, 0.3, -1}, {0, 0, 1}, true},
        {scene::Disc{{0, 0, 0}, {0, 0, 1}, 1.0, 0.5}, {0, 0.7, -0.1}, {0, 0.7, 0}, {0, 0, 1}, true},
        {scene::Triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {0.2, 0.2, 0.1}, {0.2, 0.2, 0}, {0, 0, 1}, true},
        {scene::Sphere{{1, 0, 0}, 0.5}, {1, 0.6, 0}, {1, 0.5, 0}, {0, 1, 0}, false},
        {scene::Box{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {-1.1, 1, 2}, {-1, 1, 2}, {-1, 0, 0}, false},
        {scene::Cylinder{{0, 0, 0}, {0, 0, 2}, 0.5, true}, {0.6, 0, 1}, {0.5, 0, 1}, {1, 0, 0}, false},
        {scene::Cylinder{{0, 0, 0}, {0, 0, 2}, 0.5, true}, {0.2, 0, 2.1}, {0.2, 0, 2}, {0, 0, 1}, false},
        {scene::Cylinder{{0, 0, 0}, {0, 0, 2}, 0.5, false}, {0, 0.4, 1}, {0, 0.5, 1}, {0, 1, 0}, true},
        {scene::Cone{{0, 0, 0}, {0, 0, 1}, 1.0, true},
         {0.5 + 0.1 * r, 0, 0.5 + 0.1 * r},
         {0.5, 0, 0.5},
         {r, 0, r},
         false},
        {scene::Cone{{0, 0, 0}, {0, 0, 1}, 1.0, true}, {0.2, 0, -0.1}, {0.2, 0, 0}, {0, 0, -1}, false},
    };
    for (const FootCase& each : cases) {
        SCOPED_TRACE(each.shape.index());
        const auto foot = footOn(each.shape, each.point);
        ASSERT_TRUE(foot);
        expectNear(foot->point, each.foot);
        expectNear(foot->normal, each.normal);
        EXPECT_EQ(foot->twoSided, each.twoSided);
    }
}

TEST(Foot, IsMissingBeyondTheEdge) {
    EXPECT_FALSE(footOn(wall(), {0.6, 0, -1}));
    EXPECT_FALSE(footOn(scene::Disc{{0, 0, 0}, {0, 0, 1}, 1.0, 0.5}, {0, 0.4, 0}));
    EXPECT_FALSE(footOn(scene::Disc{{0, 0, 0}, {0, 0, 1}, 1.0, 0.5}, {0, 1.1, 0}));
    EXPECT_FALSE(footOn(scene::Triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {0.6, 0.6, 0}));
    EXPECT_FALSE(footOn(scene::Cylinder{{0, 0, 0}, {0, 0, 2}, 0.5, false}, {0.5, 0, 2.1}));
}

TEST(Surface, IsTheOneUnderTheWholeLine) {
    scene::Scene scene = sceneOf(wall());
    scene.objects.push_back({"floor", scene::Plane{{0, -0.5, 0}, {0, 1, 0}}, 0});
    const SurfaceLine line = surfaceUnder(scene, {-0.5, 0, -1}, {0.5, 0.2, -1.00005}, {0, 0, 0});
    EXPECT_EQ(line.object, 0U);
    expectNear(line.from, {-0.5, 0, -1});
    expectNear(line.to, {0.5, 0.2, -1});  // put onto the surface
    expectNear(line.normal, {0, 0, 1});
    EXPECT_EQ(surfaceUnder(scene, {0, -0.5, 0}, {1, -0.5, 0}, {0, 0, 0}).object, 1U);
}

TEST(Surface, IsMeasuredOnTheSideOfTheEye) {
    const scene::Scene scene = sceneOf(wall());
    expectNear(surfaceUnder(scene, {0, 0, -1}, {0.1, 0, -1}, {0, 0, 5}).normal, {0, 0, 1});
    expectNear(surfaceUnder(scene, {0, 0, -1}, {0.1, 0, -1}, {0, 0, -5}).normal, {0, 0, -1});
    const scene::Scene box = sceneOf(scene::Box{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    expectNear(surfaceUnder(box, {0, 0, 1}, {0.1, 0, 1}, {0, 0, 0}).normal, {0, 0, 1});  // never the inside
}

TEST(Surface, ALineOffItIsToldHowFarAndWhereTo) {
    const scene::Scene scene = sceneOf(wall());
    const std::string off = refusal(scene, {0, 0, -0.98}, {0.1, 0, -1});
    expectSays(off, "the beginning of the line, (0, 0, -0.98) is 20 mm from the nearest surface, \"wall\"");
    expectSays(off, "within 0.1 mm");
    expectSays(off, "(0, 0, -1)");
    expectSays(refusal(scene, {0, 0, -1}, {0.1, 0, -1.01}), "the end of the line, (0.1, 0, -1.01)");
    expectSays(refusal(scene, {0, 0, -1}, {0.7, 0, -1}),
               "the end of the line, (0.7, 0, -1) is above no surface");
    expectSays(refusal(scene, {0, 0, -1}, {0, 0, -1}), "the same point");
}

TEST(Surface, ALineMustStayOnIt) {
    const scene::Scene ring = sceneOf(scene::Disc{{0, 0, 0}, {0, 0, 1}, 1.0, 0.5});
    expectSays(refusal(ring, {-0.7, 0, 0}, {0.7, 0, 0}), "the middle of the line");
    const scene::Scene pillar = sceneOf(scene::Cylinder{{0, 0, 0}, {0, 2, 0}, 0.5, false});
    EXPECT_EQ(refusal(pillar, {0.5, 0.1, 0}, {0.5, 1.9, 0}), "accepted");
    expectSays(refusal(pillar, {0.5, 1, 0}, {0, 1, 0.5}), "the middle of the line");
    scene::Scene lamp = sceneOf(wall());
    lamp.materials[0].model = scene::Emissive{1.0 * W_per_m2_sr, {}, false};
    expectSays(refusal(lamp, {0, 0, -1}, {0.1, 0, -1}), "glows");
}

TEST(LineScene, IsAPictureOfTheLineFromAbove) {
    scene::Scene scene = sceneOf(wall());
    scene.objects[0].material = 1;
    const SurfaceLine line = surfaceUnder(scene, {0.1, 0.2, -1}, {0.1, -0.2, -1}, {0, 0, 0});
    const scene::Scene picture = lineScene(scene, line, 200);
    EXPECT_EQ(picture.image.width, 200U);
    EXPECT_EQ(picture.image.height, 1U);
    const auto& projection = std::get<scene::Orthographic>(picture.camera.projection);
    EXPECT_NEAR(projection.height, 0.4 / 200, 1e-15);  // square pixels
    const dvec3 forward = glm::normalize(picture.camera.target - picture.camera.position);
    expectNear(forward, -line.normal, 1e-9);
    expectNear(glm::normalize(glm::cross(forward, picture.camera.up)), {0, -1, 0},
               1e-9);  // from left to right
    EXPECT_GT(picture.camera.position.z, -1.0 + kSurfaceTolerance);
    EXPECT_LT(picture.camera.position.z, -0.999);
    const auto& white = std::get<scene::Diffuse>(picture.materials[1].model);
    EXPECT_EQ(optics::valueAt(white.reflectance, 550.0), 1.0);
}

TEST(LineScene, HasNoGratingOfTheThesis) {
    scene::Scene scene = sceneOf(wall());
    scene.lights.push_back({"old", {1, 1, 1}, {}, scene::ThesisGrating{}});
    const SurfaceLine line = surfaceUnder(scene, {0, 0, -1}, {0.1, 0, -1}, {0, 0, 0});
    EXPECT_THROW(lineScene(scene, line, 10), LineError);
}

}  // namespace
}  // namespace fringe::profile
