// Problems that the schema finds: what parseScene says, to the letter, with line and column.
#include <gtest/gtest.h>

#include "scene/support.hpp"

namespace fringe::scene {
namespace {

std::string problemsOfMaterial(std::string_view material) {
    return problemsOf(sceneWithMaterial(material));
}

// A grating light with the given aperture, which begins in column 113.
std::string gratingWith(std::string_view aperture) {
    return fmt::format(
        R"({{"type": "grating", "model": "thesis", "position": [0, 0, 0], "normal": [0, 0, 1], "beam": {{"diameter": "2 mm"}},
"slit_direction": [0, 1, 0], "aperture": {}}})",
        aperture);
}

// ---- keys ----------------------------------------------------------------------------------------

TEST(SceneProblems, UnknownKeyNamesTheNearest) {
    EXPECT_EQ(problemsOfObject(
                  R"({"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1, "nam": "a"})"),
              R"(s:5:74: unknown key "nam"; did you mean "name"?)");
}

TEST(SceneProblems, MisspeltKeyIsUnknownAndTheRightOneMissing) {
    EXPECT_EQ(problemsOfObject(R"({"type": "sphere", "material": "grey", "center": [0, 0, 0], "radus": 1})"),
              "s:5:1: missing key \"radius\"; add a number of metres\n"
              "s:5:61: unknown key \"radus\"; did you mean \"radius\"?");
}

TEST(SceneProblems, UnknownKeyUnlikeAnyListsThemAll) {
    EXPECT_EQ(
        problemsOf(R"({"fringe": 1, "camera": {"position": [0, 0, 3], "target": [0, 0, 0]},
  /* not a "key": */ "image": { "resolution": /* nor : this */ 600 }})"),
        R"(s:2:33: unknown key "resolution"; an image may have "width", "height", "samples", "seed", "max_depth", "exposure", "color_space" or "tolerance")");
}

TEST(SceneProblems, MissingKeysAreNamed) {
    EXPECT_EQ(problemsOf("{}"),
              "s:1:1: missing key \"fringe\"; add 1\n"
              "s:1:1: missing key \"camera\"; add a camera");
    EXPECT_EQ(problemsOfCamera("{}"),
              "s:2:11: missing key \"position\"; add a point [x, y, z] in metres\n"
              "s:2:11: missing key \"target\"; add a point [x, y, z] in metres");
    EXPECT_EQ(problemsOfLight(gratingWith(R"({"count": 2})")),
              "s:9:42: missing key \"type\"; add \"slits\"\n"
              "s:9:42: missing key \"width\"; add a length such as \"1 um\"\n"
              "s:9:42: missing key \"period\"; add a length such as \"2 um\"");
    EXPECT_EQ(problemsOfMaterial(R"({"type": "conductor"})"),
              R"(s:3:21: missing key "metal"; add "aluminium", "silver", "gold" or "copper")");
}

// ---- types and choices ---------------------------------------------------------------------------

TEST(SceneProblems, UnknownTypeNamesTheNearest) {
    EXPECT_EQ(problemsOfObject(R"({"type": "spere"})"),
              R"(s:5:10: "type" is "spere"; did you mean "sphere"?)");
    EXPECT_EQ(problemsOfMaterial(R"({"type": "Diffuse"})"),
              R"(s:3:30: "type" is "Diffuse"; did you mean "diffuse"?)");
}

TEST(SceneProblems, UnknownTypeUnlikeAnyListsThemAll) {
    EXPECT_EQ(
        problemsOfLight(R"({"type": "neon tube"})"),
        R"(s:8:10: "type" is "neon tube"; write "point", "spot", "directional", "area", "environment" or "grating")");
    EXPECT_EQ(problemsOfCamera(R"({"type": 3})"),
              R"(s:2:20: "type" is 3; write "perspective" or "orthographic")");
}

TEST(SceneProblems, MissingTypeListsThemAll) {
    EXPECT_EQ(
        problemsOfMaterial(R"({"reflectance": 1})"),
        R"(s:3:21: missing key "type"; add "diffuse", "conductor", "dielectric", "emissive" or "optical-disc")");
}

TEST(SceneProblems, UnknownChoiceNamesTheNearestOrAll) {
    EXPECT_EQ(problemsOfMaterial(R"({"type": "conductor", "metal": "aluminum"})"),
              R"(s:3:52: "metal" is "aluminum"; did you mean "aluminium"?)");
    EXPECT_EQ(problemsOfMaterial(R"({"type": "conductor", "metal": "tin"})"),
              R"(s:3:52: "metal" is "tin"; write "aluminium", "silver", "gold" or "copper")");
    EXPECT_EQ(problemsOfMaterial(R"({"type": "optical-disc", "model": "thesis", "faults": "as printed"})"),
              R"(s:3:75: "faults" is "as printed"; did you mean "as-printed"?)");
    EXPECT_EQ(problemsOfMaterial(R"({"type": "optical-disc", "model": "physical"})"),
              R"(s:3:21: missing key "medium"; add "cd", "dvd", "blu-ray", "vinyl" or "custom")");
}

TEST(SceneProblems, OtherVersionIsRefused) {
    EXPECT_EQ(problemsOf(R"({"fringe": 2, "camera": {"position": [0, 0, 3], "target": [0, 0, 0]}})"),
              R"(s:1:12: "fringe" is 2; write 1)");
}

TEST(SceneProblems, WrongJsonTypeSaysWhatToWrite) {
    EXPECT_EQ(problemsOf("[1]"), "s:1:1: the scene is an array; write a scene");
    EXPECT_EQ(problemsOf("null"), "s:1:1: the scene is null; write a scene");
    EXPECT_EQ(problemsOfCamera("true"), R"(s:2:11: "camera" is true; write a camera)");
    EXPECT_EQ(problemsOfObject("3"), R"(s:5:1: "objects"[0] is 3; write an object)");
    EXPECT_EQ(
        problemsOf(R"({"fringe": 1, "camera": {"position": [0, 0, 3], "target": [0, 0, 0]}, "lights": {}})"),
        R"(s:1:81: "lights" is an object; write an array)");
    EXPECT_EQ(
        problemsOf(
            R"({"fringe": 1, "camera": {"position": [0, 0, 3], "target": [0, 0, 0]}, "materials": []})"),
        R"(s:1:84: "materials" is an array; write an object)");
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "cone", "material": 1, "base": [0, 0, 0], "apex": "up", "radius": "1", "capped": 1})"),
        "s:5:30: \"material\" is 1; write the name of a material\n"
        "s:5:60: \"apex\" is \"up\"; write a point [x, y, z] in metres\n"
        "s:5:76: \"radius\" is \"1\"; write a number of metres\n"
        "s:5:91: \"capped\" is 1; write true or false");
    EXPECT_EQ(
        problemsOfMaterial(R"({"type": "diffuse", "reflectance": "white"})"),
        R"(s:3:56: "reflectance" is "white"; write a number from 0 to 1, a colour [r, g, b] of such numbers, or a curve)");
}

TEST(SceneProblems, VectorOfWrongLength) {
    EXPECT_EQ(problemsOfCamera(R"({"position": [0, 0], "target": [0, 0, 0, 1]})"),
              "s:2:24: \"position\" has 2 elements; write a point [x, y, z] in metres\n"
              "s:2:42: \"target\" has 4 elements; write a point [x, y, z] in metres");
    EXPECT_EQ(problemsOfObject(R"({"type": "triangle", "material": "grey", "vertices": [[0, 0, 0]]})"),
              R"(s:5:54: "vertices" has 1 element; write three points [x, y, z] in metres)");
}

TEST(SceneProblems, WrongElementIsNamedWithItsIndex) {
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "triangle", "material": "grey", "vertices": [[0, 0, 0], [0, "1", 0], [1, 0, 0]]})"),
        R"(s:5:70: "vertices"[1][1] is "1"; write a number of metres)");
}

// ---- ranges --------------------------------------------------------------------------------------

TEST(SceneProblems, NumberOutOfRange) {
    EXPECT_EQ(problemsOf(R"({"fringe": 1, "camera": {"position": [0, 0, 3], "target": [0, 0, 0]},
"image": {"width": 0, "height": 65537, "samples": 1.5, "seed": -1, "max_depth": 65, "exposure": 1e9}})"),
              "s:2:20: \"width\" is 0; write a whole number from 1 to 65536\n"
              "s:2:33: \"height\" is 65537; write a whole number from 1 to 65536\n"
              "s:2:51: \"samples\" is 1.5; write a whole number\n"
              "s:2:64: \"seed\" is -1; write a whole number from 0 to 4294967295\n"
              "s:2:81: \"max_depth\" is 65; write a whole number from 0 to 64\n"
              "s:2:97: \"exposure\" is 1000000000; write a number from -64 to 64");
    EXPECT_EQ(problemsOfMaterial(R"({"type": "diffuse", "reflectance": [0, 1.5, 0]})"),
              R"(s:3:60: "reflectance"[1] is 1.5; write a number from 0 to 1)");
    EXPECT_EQ(problemsOfMaterial(R"({"type": "diffuse", "reflectance": -0.5})"),
              R"(s:3:56: "reflectance" is -0.5; write a number from 0 to 1)");
    EXPECT_EQ(problemsOfMaterial(R"({"type": "dielectric", "ior": 0.9})"),
              R"(s:3:51: "ior" is 0.9; write a number from 1 to 4)");
}

TEST(SceneProblems, RadiusMustBePositive) {
    EXPECT_EQ(
        problemsOfObject(R"({"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": -1})"),
        R"(s:5:71: "radius" is -1; write a number of metres greater than 0 and at most 1000000)");
    EXPECT_EQ(
        problemsOfObject(
            R"({"type": "cylinder", "material": "grey", "base": [0, 0, 0], "top": [0, 1, 0], "radius": 0})"),
        R"(s:5:89: "radius" is 0; write a number of metres greater than 0 and at most 1000000)");
    EXPECT_EQ(problemsOfCamera(
                  R"({"type": "orthographic", "position": [0, 0, 3], "target": [0, 0, 0], "height": 0})"),
              R"(s:2:90: "height" is 0; write a number of metres greater than 0 and at most 1000000)");
}

TEST(SceneProblems, CoordinatesBeyondSinglePrecisionAreRefusedWithTheReason) {
    EXPECT_EQ(
        problemsOfObject(R"({"type": "sphere", "material": "grey", "center": [0, -2e6, 0], "radius": 1})"),
        "s:5:54: \"center\"[1] is -2000000; write a number of metres from -1000000 to 1000000 (1000 km from "
        "the "
        "origin, the single precision that devices compute in is as coarse as 6 cm)");
}

TEST(SceneProblems, ColorOutOfRange) {
    EXPECT_EQ(problemsOfLight(R"({"type": "environment", "radiance": "1 W/m^2/sr", "color": [-1, 0, 1e7]})"),
              "s:8:61: \"color\"[0] is -1; write a number from 0 to 1000000\n"
              "s:8:68: \"color\"[2] is 10000000; write a number from 0 to 1000000 (a colour only tints; how "
              "much light "
              "there is belongs to the power, irradiance or radiance)");
}

// ---- quantities ----------------------------------------------------------------------------------

TEST(SceneProblems, BareNumberInPlaceOfAQuantity) {
    EXPECT_EQ(
        problemsOfLight(gratingWith(R"({"type": "slits", "count": 2, "width": 1, "period": 2e-6})")),
        "s:9:81: \"width\" is the bare number 1, which has no unit; write a length such as \"1 um\"\n"
        "s:9:94: \"period\" is the bare number 2e-06, which has no unit; write a length such as \"2 um\"");
    EXPECT_EQ(problemsOfCamera(R"({"position": [0, 0, 3], "target": [0, 0, 0], "fov": 40})"),
              R"(s:2:63: "fov" is the bare number 40, which has no unit; write an angle such as "40 deg")");
}

TEST(SceneProblems, QuantityWithoutOrWithAWrongUnit) {
    EXPECT_EQ(
        problemsOfLight(R"({"type": "point", "position": [0, 0, 0], "power": "5"})"),
        R"(s:8:51: "power" is "5", without a unit; write a power such as "5 W" (units: W, mW, uW or kW))");
    EXPECT_EQ(problemsOfLight(R"({"type": "point", "position": [0, 0, 0], "power": "5 mm"})"),
              R"(s:8:51: "power" is "5 mm", but "mm" is not a unit of power; write W, mW, uW or kW)");
    EXPECT_EQ(problemsOfLight(R"({"type": "point", "position": [0, 0, 0], "power": "much"})"),
              R"(s:8:51: "power" is "much"; write a power such as "5 W" (units: W, mW, uW or kW))");
    EXPECT_EQ(problemsOfLight(R"({"type": "point", "position": [0, 0, 0], "power": true})"),
              R"(s:8:51: "power" is true; write a power such as "5 W")");
    EXPECT_EQ(problemsOfLight(R"({"type": "point", "position": [0, 0, 0], "power": "1e999 W"})"),
              R"(s:8:51: "power" is "1e999 W"; write a power such as "5 W" (units: W, mW, uW or kW))");
}

TEST(SceneProblems, QuantityOutOfRange) {
    EXPECT_EQ(problemsOfLight(R"({"type": "point", "position": [0, 0, 0], "power": "-5 W"})"),
              R"(s:8:51: "power" is "-5 W"; write a power from 0 W to 1e12 W)");
    EXPECT_EQ(
        problemsOfLight(gratingWith(R"({"type": "slits", "count": 0, "width": "0 um", "period": "2 um"})")),
        "s:9:69: \"count\" is 0; write a whole number from 1 to 65536\n"
        "s:9:81: \"width\" is \"0 um\"; write a length from 1 nm to 1e6 m");
    for (const std::string fov : {"0 deg", "180 deg", "4 rad"}) {
        EXPECT_EQ(
            problemsOfCamera(R"({"position": [0, 0, 3], "target": [0, 0, 0], "fov": ")" + fov + "\"}"),
            "s:2:63: \"fov\" is \"" + fov + "\"; write an angle greater than 0 deg and less than 180 deg");
    }
    EXPECT_EQ(
        problemsOfLight(
            R"({"type": "spot", "position": [0, 0, 0], "direction": [0, 1, 0], "angle": "181 deg", "power": "1 W"})"),
        R"(s:8:74: "angle" is "181 deg"; write an angle greater than 0 deg and at most 180 deg)");
}

// ---- names ---------------------------------------------------------------------------------------

TEST(SceneProblems, NamesMustNotBeEmpty) {
    EXPECT_EQ(problemsOf(R"({"fringe": 1, "camera": {"position": [0, 0, 3], "target": [0, 0, 0]},
"materials": {"": {"type": "diffuse"}}})"),
              R"(s:2:15: "" is not a name; write at least one letter)");
    EXPECT_EQ(problemsOfLight(R"({"type": "environment", "radiance": "1 W/m^2/sr", "name": ""})"),
              R"(s:8:59: "name" is empty; write a name, or leave the key out)");
}

TEST(SceneProblems, MaterialThatDoesNotExist) {
    EXPECT_EQ(problemsOfObject(R"({"type": "sphere", "material": "gray", "center": [0, 0, 0], "radius": 1})"),
              R"(s:5:32: no material is named "gray"; did you mean "grey"?)");
    EXPECT_EQ(problemsOfObject(R"({"type": "sphere", "material": "wood", "center": [0, 0, 0], "radius": 1})"),
              R"(s:5:32: no material is named "wood"; write "grey" or "mirror")");
    EXPECT_EQ(problemsOf(R"({"fringe": 1, "camera": {"position": [0, 0, 3], "target": [0, 0, 0]},
"objects": [{"type": "sphere", "material": "wood", "center": [0, 0, 0], "radius": 1}]})"),
              R"(s:2:44: no material is named "wood"; add it to "materials", which is empty)");
}

TEST(SceneProblems, NamesAreUniqueAmongObjectsAndAmongLights) {
    const std::string object =
        R"({"type": "sphere", "name": "a", "material": "grey", "center": [0, 0, 0], "radius": 1})";
    const std::string light = R"({"type": "point", "name": "a", "position": [0, 0, 0], "power": "1 W"})";
    EXPECT_EQ(problemsOf(sceneWith(object, light)), "no problem");
    EXPECT_EQ(problemsOf(sceneWith(object + ",\n" + object)),
              R"(s:6:28: "objects"[0] and [1] both have the name "a"; give each of the objects its own)");
    EXPECT_EQ(problemsOf(sceneWith("", light + ",\n" + light)),
              R"(s:9:27: "lights"[0] and [1] both have the name "a"; give each of the lights its own)");
}

TEST(SceneProblems, OneEnvironmentLightAtMost) {
    const std::string sky = R"({"type": "environment", "radiance": "1 W/m^2/sr"})";
    EXPECT_EQ(problemsOf(sceneWith("", sky + ",\n" + sky)),
              "s:9:10: a second environment light; keep one, and add up their radiances");
}

TEST(SceneProblems, OpticalDiscBelongsOnADisc) {
    EXPECT_EQ(problemsOf(R"({"fringe": 1, "camera": {"position": [0, 0, 3], "target": [0, 0, 0]},
"materials": {"cd": {"type": "optical-disc", "model": "thesis"}},
"objects": [{"type": "sphere", "material": "cd", "center": [0, 0, 0], "radius": 1}]})"),
              R"(s:3:44: "cd" is an optical disc; give it only to objects of type "disc")");
}

TEST(SceneProblems, QuotedTextIsShortAndOnOneLine) {
    EXPECT_EQ(
        problemsOfObject(R"({"type": "a\nb"})"),
        "s:5:10: \"type\" is \"a\\u000ab\"; write \"plane\", \"rectangle\", \"disc\", \"sphere\", \"box\", "
        "\"cylinder\", \"cone\" or \"triangle\"");
    const std::string euros = "\u20ac\u20ac\u20ac\u20ac\u20ac\u20ac\u20ac\u20ac\u20ac\u20ac";
    EXPECT_EQ(problemsOfMaterial("{\"type\": \"" + euros + euros + euros + "\"}"),
              "s:3:30: \"type\" is \"" + euros + euros +
                  "...\"; write \"diffuse\", \"conductor\", \"dielectric\", "
                  "\"emissive\" or \"optical-disc\"");
}

// ---- all at once ---------------------------------------------------------------------------------

TEST(SceneProblems, AreReportedTogetherInTheOrderOfTheFile) {
    try {
        parseScene(R"({
  "lights": [{"type": "spott"}],
  "fringe": 1,
  "objects": [
    {"type": "sphere", "material": "none", "center": [0, 0, 0], "radius": -1, "name": "x"},
    {"type": "disc", "material": "m", "center": [0, 0, 0], "normal": [0, 0, 0], "radius": 1, "name": "x", "extra": 1}
  ],
  "materials": {"m": {"type": "diffuse", "reflectance": 2}},
  "camera": {"position": [0, 0, 0], "target": [0, 0, 0]}
})",
                   "scenes/cd.json");
        FAIL() << "no problem found";
    } catch (const SceneError& error) {
        std::vector<std::string> places;
        for (const Problem& problem : error.problems()) places.push_back(problem.place);
        const std::vector<std::string> expected{
            "scenes/cd.json:2:23",   // type
            "scenes/cd.json:5:36",   // material
            "scenes/cd.json:5:75",   // radius
            "scenes/cd.json:6:70",   // normal, although the object has a key too many and its material is bad
            "scenes/cd.json:6:102",  // name
            "scenes/cd.json:6:107",  // extra
            "scenes/cd.json:8:57",   // reflectance
            "scenes/cd.json:9:47",   // target
        };
        EXPECT_EQ(places, expected) << error.what();
        EXPECT_EQ(error.problems()[7].message,
                  "\"target\" is the same point as \"position\"; write a point that the camera looks at");
    }
}

}  // namespace
}  // namespace fringe::scene
