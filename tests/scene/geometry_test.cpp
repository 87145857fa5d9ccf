// Problems of values that are right one by one but cannot work together.
#include <gtest/gtest.h>

#include "scene/support.hpp"

namespace fringe::scene {
namespace {

// A grating light; its slit direction is on line 9 in column 19, its aperture on line 10 in column 13.
std::string gratingWith(std::string_view normal, std::string_view slitDirection, std::string_view slits) {
    return fmt::format(R"({{"type": "grating", "model": "thesis", "position": [0, 0, 0], "normal": {},
"slit_direction": {},
"aperture": {{"type": "slits", {}}}, "beam": {{"diameter": "2 mm"}}}})",
                       normal, slitDirection, slits);
}

constexpr std::string_view kGoodSlits = R"("count": 2, "width": "1 um", "period": "2 um")";

// ---- directions ----------------------------------------------------------------------------------

TEST(SceneGeometry, ZeroDirectionsPointNowhere) {
    EXPECT_EQ(
        problemsOfObject(R"({"type": "plane", "material": "grey", "point": [0, 0, 0], "normal": [0, 0, 0]})"),
        R"(s:5:69: "normal" is [0, 0, 0], which points nowhere; write a direction such as [0, 1, 0])");
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "disc", "material": "grey", "center": [0, 0, 0], "normal": [0, 0, 0], "radius": 1})"),
        R"(s:5:69: "normal" is [0, 0, 0], which points nowhere; write a direction such as [0, 1, 0])");
    EXPECT_EQ(
        problemsOfLight(R"({"type": "directional", "direction": [0, 0, 0], "irradiance": "1 W/m^2"})"),
        R"(s:8:38: "direction" is [0, 0, 0], which points nowhere; write a direction such as [0, 1, 0])");
    EXPECT_EQ(
        problemsOfLight(
            R"({"type": "spot", "position": [0, 0, 0], "direction": [0, 0, 0], "angle": "1 deg", "power": "1 W"})"),
        R"(s:8:54: "direction" is [0, 0, 0], which points nowhere; write a direction such as [0, 1, 0])");
    EXPECT_EQ(
        problemsOfLight(gratingWith("[0, 0, 1]", "[0, 0, 0]", kGoodSlits)),
        R"(s:9:19: "slit_direction" is [0, 0, 0], which points nowhere; write a direction such as [0, 1, 0])");
    EXPECT_EQ(problemsOfCamera(R"({"position": [0, 0, 3], "target": [0, 0, 0], "up": [0, 0, 0]})"),
              R"(s:2:62: "up" is [0, 0, 0], which points nowhere; write a direction such as [0, 1, 0])");
}

TEST(SceneGeometry, SlitsLieInThePlaneOfTheGrating) {
    EXPECT_EQ(problemsOfLight(gratingWith("[0, 0, 1]", "[0, 0, -3]", kGoodSlits)),
              "s:9:19: \"slit_direction\" is parallel to \"normal\", but slits lie in the plane of the "
              "grating; write "
              "another direction, such as [0, 1, 0]");
    EXPECT_EQ(problemsOfLight(gratingWith("[0, -1, 0]", "[0, 1, 0]", kGoodSlits)),
              "s:9:19: \"slit_direction\" is parallel to \"normal\", but slits lie in the plane of the "
              "grating; write "
              "another direction, such as [1, 0, 0]");
    // 1e-5 rad off the normal is a direction, if an odd one.
    EXPECT_EQ(problemsOfLight(gratingWith("[0, 0, 1]", "[0, 0.00001, 1]", kGoodSlits)), "no problem");
}

TEST(SceneGeometry, CameraLooksSomewhere) {
    EXPECT_EQ(problemsOfCamera(R"({"position": [1, 2, 3], "target": [1, 2, 3]})"),
              R"(s:2:45: "target" is the same point as "position"; write a point that the camera looks at)");
}

TEST(SceneGeometry, UpIsNotAlongTheView) {
    EXPECT_EQ(
        problemsOfCamera(R"({"position": [0, 3, 0], "target": [0, 0, 0], "up": [0, 2, 0]})"),
        R"(s:2:62: "up" is along the view from "position" to "target"; write another direction, such as [1, 0, 0])");
    // The default is no better than what is written; the camera itself is the place then.
    EXPECT_EQ(
        problemsOfCamera(R"({"position": [0, 3, 0], "target": [0, 0, 0]})"),
        R"(s:2:11: "up" is along the view from "position" to "target"; write another direction, such as [1, 0, 0])");
}

// ---- shapes --------------------------------------------------------------------------------------

TEST(SceneGeometry, InnerRadiusIsLessThanTheOuter) {
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "disc", "material": "grey", "center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1, "inner_radius": 1})"),
        R"(s:5:109: "inner_radius" is 1; write less than the radius, which is 1)");
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "disc", "material": "grey", "center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1, "inner_radius": -1})"),
        R"(s:5:109: "inner_radius" is -1; write a number of metres of at least 0)");
}

TEST(SceneGeometry, EdgesOfARectangleArePerpendicular) {
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "rectangle", "material": "grey", "center": [0, 0, 0], "u": [1, 0, 0], "v": [1, 1, 0]})"),
        R"(s:5:85: "v" is not perpendicular to "u", but at 45 degrees; the nearest that is perpendicular is [0, 1, 0])");
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "rectangle", "material": "grey", "center": [0, 0, 0], "u": [1, 0, 0], "v": [-2, 0, 0]})"),
        R"(s:5:85: "v" is not perpendicular to "u", but at 180 degrees; write one that points another way)");
    EXPECT_EQ(
        problemsOfLight(
            R"({"type": "area", "power": "1 W", "shape": {"type": "rectangle", "center": [0, 0, 0], "u": [0, 0, 1], "v": [0, 1, 0.01]}})"),
        R"(s:8:107: "v" is not perpendicular to "u", but at 89.43 degrees; the nearest that is perpendicular is [0, 1, 0])");
}

TEST(SceneGeometry, EdgesOfABoxArePerpendicular) {
    EXPECT_EQ(
        problemsOfObject(R"({"type": "box", "material": "grey", "center": [0, 0, 0],
"u": [1, 0, 0],
"v": [0, 1, 0],
"w": [0, 1, 1]})"),
        R"(s:8:6: "w" is not perpendicular to "v", but at 45 degrees; the nearest that is perpendicular is [0, 0, 1])");
    EXPECT_EQ(
        problemsOfObject(R"({"type": "box", "material": "grey", "center": [0, 0, 0],
"u": [1, 0, 0],
"v": [0.2, 1, 0],
"w": [0, 0, 1]})"),
        R"(s:7:6: "v" is not perpendicular to "u", but at 78.69 degrees; the nearest that is perpendicular is [0, 1, 0])");
}

TEST(SceneGeometry, EdgesHaveALength) {
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "rectangle", "material": "grey", "center": [0, 0, 0], "u": [0, 0, 0], "v": [1, 0, 0]})"),
        R"(s:5:69: the length of "u" is 0 m; write one of at least 1e-9 m (1 nm))");
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "box", "material": "grey", "center": [0, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0], "w": [0, 0, 1e-20]})"),
        R"(s:5:95: the length of "w" is 1e-20 m; write one of at least 1e-9 m (1 nm))");
}

TEST(SceneGeometry, RadiusIsNotTooSmallForSinglePrecision) {
    EXPECT_EQ(
        problemsOfObject(R"({"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1e-30})"),
        R"(s:5:71: "radius" is 1e-30 m; write one of at least 1e-9 m (1 nm))");
}

TEST(SceneGeometry, AxesHaveALength) {
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "cylinder", "material": "grey", "base": [1, 0, 0], "top": [1, 0, 0], "radius": 1})"),
        R"(s:5:68: "base" and "top" are the same point; write points at least 1e-9 m (1 nm) apart)");
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "cone", "material": "grey", "base": [1, 0, 0], "apex": [1, 0, 0], "radius": 1})"),
        R"(s:5:65: "base" and "apex" are the same point; write points at least 1e-9 m (1 nm) apart)");
}

TEST(SceneGeometry, TrianglesHaveAnArea) {
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "triangle", "material": "grey", "vertices": [[0, 0, 0], [1, 1, 1], [3, 3, 3]]})"),
        "s:5:54: the vertices lie on one line; write three points that span an area");
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "triangle", "material": "grey", "vertices": [[1, 0, 0], [1, 0, 0], [1, 0, 0]]})"),
        "s:5:54: the longest side is 0 m; write one of at least 1e-9 m (1 nm)");
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "triangle", "material": "grey", "vertices": [[0, 0, 0], [1, 0, 0], [0, 0.001, 0]]})"),
        "no problem");
}

// ---- lights --------------------------------------------------------------------------------------

TEST(SceneGeometry, SlitsDoNotOverlap) {
    EXPECT_EQ(
        problemsOfLight(
            gratingWith("[0, 0, 1]", "[0, 1, 0]", R"("count": 2, "width": "3 um", "period": "2000 nm")")),
        R"(s:10:52: "width" is "3 um"; write at most the period, which is "2000 nm", or the slits overlap)");
    EXPECT_EQ(
        problemsOf(
            sceneWithMaterial(R"({"type": "optical-disc", "model": "thesis", "slits": {"width": "9 um"}})")),
        R"(s:3:84: "width" is "9 um"; write at most the period, which is "8.3 um", or the slits overlap)");
    // As wide as the period is a single wide opening, and a single slit has no neighbour.
    EXPECT_EQ(problemsOfLight(
                  gratingWith("[0, 0, 1]", "[0, 1, 0]", R"("count": 2, "width": "2 um", "period": "2 um")")),
              "no problem");
    EXPECT_EQ(problemsOfLight(
                  gratingWith("[0, 0, 1]", "[0, 1, 0]", R"("count": 1, "width": "3 um", "period": "2 um")")),
              "no problem");
}

TEST(SceneGeometry, InnerAngleIsAtMostTheAngle) {
    EXPECT_EQ(
        problemsOfLight(R"({"type": "spot", "position": [0, 0, 0], "direction": [0, 1, 0], "angle": "30 deg",
"inner_angle": "0.6 rad", "power": "1 W"})"),
        R"(s:9:16: "inner_angle" is "0.6 rad"; write at most the angle, which is "30 deg")");
}

}  // namespace
}  // namespace fringe::scene
