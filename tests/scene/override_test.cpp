// --set: values, paths, and the place of the problems that they cause.
#include <gtest/gtest.h>

#include "optics/color.hpp"
#include "scene/support.hpp"

namespace fringe::scene {
namespace {

// Two objects and two lights; the first of each has a name.
std::string scene() {
    return sceneWith(
        R"({"type": "disc", "name": "cd", "material": "grey", "center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1},
{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1})",
        R"({"type": "point", "name": "lamp", "position": [0, 0, 0], "power": "1 W"},
{"type": "grating", "name": "slits", "model": "thesis", "position": [0, 0, 0], "normal": [0, 0, 1], "slit_direction": [0, 1, 0],
"aperture": {"type": "slits", "count": 2, "width": "1 um", "period": "2 um"}, "beam": {"diameter": "2 mm"}})");
}

Scene with(const std::vector<Override>& overrides) {
    return parseScene(scene(), "s", overrides);
}
std::string problemsWith(const std::vector<Override>& overrides) {
    return problemsOf(scene(), overrides);
}

// ---- values --------------------------------------------------------------------------------------

TEST(SceneOverride, ReplacesAValue) {
    EXPECT_EQ(std::get<Sphere>(with({{"objects.1.radius", "2"}}).objects[1].shape).radius, 2.0);
    EXPECT_EQ(std::get<Disc>(with({{"objects.cd.radius", "2"}}).objects[0].shape).radius, 2.0);
}

TEST(SceneOverride, QuantitiesNeedNoQuotes) {
    const units::Power expected = 5.0 * (1e-3 * units::W);
    for (const std::string value : {"5mW", "5 mW", "\"5 mW\"", "5   mW"}) {
        const Scene scene = with({{"lights.lamp.power", value}});
        EXPECT_EQ(std::get<PointLight>(scene.lights[0].model).power, expected) << value;
    }
    const Scene scene = with({{"lights.slits.aperture.width", "0.5\u00b5m"}});
    EXPECT_EQ(std::get<ThesisGrating>(scene.lights[1].model).slits.width, 0.5 * units::um);
}

TEST(SceneOverride, AddsWhatTheFileLeavesToItsDefault) {
    const Scene scene = with({{"image.samples", "16"},
                              {"lights.slits.beam.power", "5 W"},
                              {"camera.lens", R"({"diameter": "1 mm", "focus_distance": "1 m"})"},
                              {"camera.up.0", "1"},
                              {"lights.lamp.color.1", "0"},
                              {"description", "a b"}});
    EXPECT_EQ(scene.image.samples, 16U);
    EXPECT_EQ(scene.image.width, 600U);
    EXPECT_EQ(std::get<ThesisGrating>(scene.lights[1].model).power, 5.0 * units::W);
    EXPECT_EQ(std::get<Perspective>(scene.camera.projection).lens->diameter, units::mm);
    EXPECT_GT(scene.camera.up.x, 0.7);
    EXPECT_EQ(scene.lights[0].color, Rgb(1, 0, 1));
    EXPECT_EQ(scene.description, "a b");
}

TEST(SceneOverride, ArraysObjectsAndNewMaterials) {
    const Scene scene = with({{"materials.grey.reflectance", "[1,0,0]"},
                              {"materials.red", R"({"type": "diffuse"})"},
                              {"materials.red.reflectance", "0.25"},
                              {"objects.cd.material", "red"}});
    const auto reflectance = [&](std::size_t object) {
        return std::get<Diffuse>(scene.materials.at(scene.objects.at(object).material).model).reflectance;
    };
    EXPECT_EQ(reflectance(0), optics::constantCurve(0.25));
    EXPECT_EQ(reflectance(1), optics::reflectanceCurve({1, 0, 0}));
}

TEST(SceneOverride, TheLastOneWins) {
    EXPECT_EQ(with({{"image.width", "100"}, {"image.width", "200"}}).image.width, 200U);
}

// ---- wrong paths ---------------------------------------------------------------------------------

TEST(SceneOverride, UnknownElementSaysWhichThereAre) {
    EXPECT_EQ(
        problemsWith({{"lights.lamb.power", "1 W"}}),
        R"(--set lights.lamb.power=1 W: "lights" has nothing named "lamb"; did you mean "lamp"? (or an index from 0 to 1))");
    EXPECT_EQ(
        problemsWith({{"lights.2.power", "1 W"}}),
        R"(--set lights.2.power=1 W: "lights" has nothing named "2"; write "lamp" or "slits" (or an index from 0 to 1))");
    EXPECT_EQ(
        problemsWith({{"objects.1.center.3", "1"}}),
        R"(--set objects.1.center.3=1: "objects.1.center" has nothing named "3"; write an index from 0 to 2)");
    EXPECT_EQ(problemsOf(sceneWith(""), {{"lights.lamp.power", "1 W"}}),
              R"(--set lights.lamp.power=1 W: "lights" has nothing named "lamp"; it is empty)");
}

TEST(SceneOverride, UnknownMaterialSaysWhichThereAre) {
    EXPECT_EQ(
        problemsWith({{"materials.gray.reflectance", "1"}}),
        R"(--set materials.gray.reflectance=1: "materials" has nothing named "gray"; did you mean "grey"?)");
}

TEST(SceneOverride, UnknownKeyNamesTheNearest) {
    EXPECT_EQ(problemsWith({{"image.sampels", "16"}}),
              R"(--set image.sampels=16: unknown key "sampels"; did you mean "samples"?)");
    EXPECT_EQ(problemsWith({{"imag.samples", "16"}}),
              R"(--set imag.samples=16: unknown key "imag"; did you mean "image"?)");
}

TEST(SceneOverride, PathThroughAValueThatHasNoParts) {
    EXPECT_EQ(
        problemsWith({{"objects.1.radius.x", "1"}}),
        R"(--set objects.1.radius.x=1: "objects.1.radius" is 1, which has nothing named "x"; end the path before it)");
}

TEST(SceneOverride, EmptySegments) {
    EXPECT_EQ(problemsWith({{"", "1"}}),
              "--set =1: segment 1 of the path is empty; write keys, names or indices between the dots");
    EXPECT_EQ(problemsWith({{"image..width", "1"}}),
              "--set image..width=1: segment 2 of the path is empty; write keys, names or indices between "
              "the dots");
}

// ---- problems that an override causes ------------------------------------------------------------

TEST(SceneOverride, WrongValueHasThePlaceOfTheOverride) {
    EXPECT_EQ(problemsWith({{"image.samples", "0"}}),
              R"(--set image.samples=0: "samples" is 0; write a whole number from 1 to 65535)");
    EXPECT_EQ(
        problemsWith({{"lights.lamp.power", "5"}}),
        R"(--set lights.lamp.power=5: "power" is the bare number 5, which has no unit; write a power such as "5 W")");
    EXPECT_EQ(problemsWith({{"camera.position", "[1,0"}}),
              R"(--set camera.position=[1,0: "position" is "[1,0"; write a point [x, y, z] in metres)");
    EXPECT_EQ(problemsWith({{"image", R"({"width": 0})"}}),
              R"(--set image={"width": 0}: "width" is 0; write a whole number from 1 to 65536)");
}

TEST(SceneOverride, ConflictWithAValueOfTheFileIsPutDownToTheOverride) {
    EXPECT_EQ(
        problemsWith({{"lights.slits.aperture.period", "0.5um"}}),
        R"(--set lights.slits.aperture.period=0.5um: "width" is "1 um"; write at most the period, which is "0.5um", or the slits overlap)");
    EXPECT_EQ(
        problemsWith({{"objects.cd.normal.2", "0"}}),
        R"(--set objects.cd.normal.2=0: "normal" is [0, 0, 0], which points nowhere; write a direction such as [0, 1, 0])");
    EXPECT_EQ(
        problemsWith({{"camera.position", "[0, 0, 0]"}}),
        R"(--set camera.position=[0, 0, 0]: "target" is the same point as "position"; write a point that the camera looks at)");
    EXPECT_EQ(
        problemsWith({{"lights.lamp.name", "slits"}}),
        R"(--set lights.lamp.name=slits: "lights"[0] and [1] both have the name "slits"; give each of the lights its own)");
}

TEST(SceneOverride, OtherTypeMakesOtherKeysRight) {
    EXPECT_EQ(problemsWith({{"objects.1.type", "cone"}}),
              "--set objects.1.type=cone: unknown key \"center\"; a cone may have \"type\", \"name\", "
              "\"material\", \"base\", "
              "\"apex\", \"radius\" or \"capped\"\n"
              "--set objects.1.type=cone: missing key \"base\"; add a point [x, y, z] in metres\n"
              "--set objects.1.type=cone: missing key \"apex\"; add a point [x, y, z] in metres");
}

TEST(SceneOverride, ProblemsOfTheFileComeFirst) {
    EXPECT_EQ(
        problemsOf(sceneWithCamera(R"({"position": [0, 0, 3], "target": [0, 0]})"), {{"image.width", "0"}}),
        "s:2:45: \"target\" has 2 elements; write a point [x, y, z] in metres\n"
        "--set image.width=0: \"width\" is 0; write a whole number from 1 to 65536");
}

}  // namespace
}  // namespace fringe::scene
