// Every type of the format becomes the right values of the Scene, and what is left out takes its default.
// Comparisons are exact: the reader only parses decimals and multiplies by a unit, as the expectations do.
#include <gtest/gtest.h>

#include <numbers>

#include "optics/color.hpp"
#include "optics/sources.hpp"
#include "scene/support.hpp"

namespace fringe::scene {
namespace {

using units::cm, units::deg, units::m, units::mm, units::nm, units::um, units::W, units::rad;

Shape shapeOf(std::string_view object) {
    return parseScene(sceneWith(object), "s").objects.at(0).shape;
}

Light lightOf(std::string_view light) {
    return parseScene(sceneWith("", light), "s").lights.at(0);
}

template <class Model>
Model materialOf(std::string_view material) {
    return std::get<Model>(parseScene(sceneWithMaterial(material), "s").materials.at(0).model);
}

// ---- scene, picture and camera -------------------------------------------------------------------

TEST(SceneValues, SmallestSceneTakesEveryDefault) {
    const Scene scene =
        parseScene(R"({"fringe": 1, "camera": {"position": [0, 0, 3], "target": [0, 0, 0]}})", "s");
    EXPECT_EQ(scene.description, "");
    EXPECT_EQ(scene.image.width, 600U);
    EXPECT_EQ(scene.image.height, 600U);
    EXPECT_EQ(scene.image.samples, 1U);
    EXPECT_EQ(scene.image.seed, 0U);
    EXPECT_EQ(scene.image.maxDepth, 8U);
    EXPECT_EQ(scene.image.exposure, 0.0);
    EXPECT_FALSE(scene.image.autoExposure);
    EXPECT_EQ(scene.image.colorSpace, ColorSpace::srgb);
    EXPECT_FALSE(scene.camera.whiteBalance);
    EXPECT_EQ(scene.camera.up, dvec3(0, 1, 0));
    const auto& perspective = std::get<Perspective>(scene.camera.projection);
    EXPECT_EQ(perspective.fov, 40.0 * deg);
    EXPECT_FALSE(perspective.lens);
    EXPECT_TRUE(scene.materials.empty());
    EXPECT_TRUE(scene.objects.empty());
    EXPECT_TRUE(scene.lights.empty());
}

TEST(SceneValues, Image) {
    const Scene scene =
        parseScene(R"({"fringe": 1.0, "$schema": "../fringe.schema.json", "description": "text",
        "image": {"width": 800, "height": 400.0, "samples": 16, "seed": 4294967295, "max_depth": 0, "exposure": -1.5},
        "camera": {"position": [0, 0, 3], "target": [0, 0, 0]}})",
                   "s");
    EXPECT_EQ(scene.description, "text");
    EXPECT_EQ(scene.image.width, 800U);
    EXPECT_EQ(scene.image.height, 400U);
    EXPECT_EQ(scene.image.samples, 16U);
    EXPECT_EQ(scene.image.seed, 4294967295U);
    EXPECT_EQ(scene.image.maxDepth, 0U);
    EXPECT_EQ(scene.image.exposure, -1.5);
}

TEST(SceneValues, PerspectiveCameraWithLens) {
    const Scene scene =
        parseScene(sceneWithCamera(R"({"type": "perspective", "position": [1, 2, 3], "target": [0, 0, 0.5],
        "up": [0, 0, 5], "fov": "0.5 rad", "lens": {"diameter": "5 mm", "focus_distance": "120cm"}})"),
                   "s");
    EXPECT_EQ(scene.camera.position, dvec3(1, 2, 3));
    EXPECT_EQ(scene.camera.target, dvec3(0, 0, 0.5));
    EXPECT_EQ(scene.camera.up, dvec3(0, 0, 1));
    const auto& perspective = std::get<Perspective>(scene.camera.projection);
    EXPECT_EQ(perspective.fov, 0.5 * rad);
    EXPECT_EQ(perspective.lens->diameter, 5.0 * mm);
    EXPECT_EQ(perspective.lens->focusDistance, 120.0 * cm);
}

TEST(SceneValues, OrthographicCamera) {
    const Scene scene = parseScene(
        sceneWithCamera(
            R"({"type": "orthographic", "position": [0, 0, 3], "target": [0, 0, 0], "height": 2.5})"),
        "s");
    EXPECT_EQ(std::get<Orthographic>(scene.camera.projection).height, 2.5);
}

// ---- materials -----------------------------------------------------------------------------------

TEST(SceneValues, Diffuse) {
    EXPECT_EQ(materialOf<Diffuse>(R"({"type": "diffuse"})").reflectance, optics::constantCurve(0.75));
    EXPECT_EQ(materialOf<Diffuse>(R"({"type": "diffuse", "reflectance": 0.5})").reflectance,
              optics::constantCurve(0.5));
    EXPECT_EQ(materialOf<Diffuse>(R"({"type": "diffuse", "reflectance": [1, 0, 0.25]})").reflectance,
              optics::reflectanceCurve({1, 0, 0.25}));
}

TEST(SceneValues, ConductorOfEveryMetal) {
    EXPECT_EQ(materialOf<Conductor>(R"({"type": "conductor", "metal": "aluminium"})").metal,
              Metal::aluminium);
    EXPECT_EQ(materialOf<Conductor>(R"({"type": "conductor", "metal": "silver"})").metal, Metal::silver);
    EXPECT_EQ(materialOf<Conductor>(R"({"type": "conductor", "metal": "gold"})").metal, Metal::gold);
    EXPECT_EQ(materialOf<Conductor>(R"({"type": "conductor", "metal": "copper"})").metal, Metal::copper);
}

TEST(SceneValues, Dielectric) {
    EXPECT_EQ(materialOf<Dielectric>(R"({"type": "dielectric"})").ior, 1.5);
    EXPECT_EQ(materialOf<Dielectric>(R"({"type": "dielectric", "ior": 1.33})").ior, 1.33);
}

TEST(SceneValues, Emissive) {
    const auto plain = materialOf<Emissive>(R"({"type": "emissive", "radiance": "10 W/m^2/sr"})");
    EXPECT_EQ(plain.radiance.si, 10.0);
    EXPECT_EQ(plain.spectrum.density, optics::namedSpectrum("D65")->density);
    EXPECT_FALSE(plain.twoSided);
    const auto full = materialOf<Emissive>(
        R"({"type": "emissive", "radiance": "1 W/m^2/sr", "color": [1, 0.5, 0], "two_sided": true})");
    const optics::Spectrum d65 = *optics::namedSpectrum("D65");
    EXPECT_EQ(full.spectrum.density, optics::filtered(d65, optics::reflectanceCurve({1, 0.5, 0})).density);
    EXPECT_TRUE(full.twoSided);
}

// ---- objects -------------------------------------------------------------------------------------

TEST(SceneValues, ObjectsKeepNameOrderAndMaterial) {
    const Scene scene = parseScene(sceneWith(R"(
        {"type": "sphere", "name": "b", "center": [0, 0, 0], "radius": 1, "material": "mirror"},
        {"type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "grey"})"),
                                   "s");
    ASSERT_EQ(scene.objects.size(), 2U);
    EXPECT_EQ(scene.objects[0].name, "b");
    EXPECT_EQ(scene.materials.at(scene.objects[0].material).name, "mirror");
    EXPECT_EQ(scene.objects[1].name, "");
    EXPECT_EQ(scene.materials.at(scene.objects[1].material).name, "grey");
}

TEST(SceneValues, Plane) {
    const auto plane = std::get<Plane>(
        shapeOf(R"({"type": "plane", "material": "grey", "point": [1, 2, 3], "normal": [0, 0, -2]})"));
    EXPECT_EQ(plane.point, dvec3(1, 2, 3));
    EXPECT_EQ(plane.normal, dvec3(0, 0, -1));
}

TEST(SceneValues, Rectangle) {
    const auto rectangle = std::get<Rectangle>(shapeOf(
        R"({"type": "rectangle", "material": "grey", "center": [1, 2, 3], "u": [2, 0, 0], "v": [0, 0, 3]})"));
    EXPECT_EQ(rectangle.center, dvec3(1, 2, 3));
    EXPECT_EQ(rectangle.u, dvec3(2, 0, 0));
    EXPECT_EQ(rectangle.v, dvec3(0, 0, 3));
}

TEST(SceneValues, Disc) {
    const auto disc = std::get<Disc>(shapeOf(
        R"({"type": "disc", "material": "grey", "center": [1, 2, 3], "normal": [3, 0, 0], "radius": 2})"));
    EXPECT_EQ(disc.center, dvec3(1, 2, 3));
    EXPECT_EQ(disc.normal, dvec3(1, 0, 0));
    EXPECT_EQ(disc.radius, 2.0);
    EXPECT_EQ(disc.innerRadius, 0.0);
    const auto ring = std::get<Disc>(shapeOf(
        R"({"type": "disc", "material": "grey", "center": [0, 0, 0], "normal": [0, 1, 0], "radius": 2, "inner_radius": 1})"));
    EXPECT_EQ(ring.innerRadius, 1.0);
}

TEST(SceneValues, Sphere) {
    const auto sphere = std::get<Sphere>(
        shapeOf(R"({"type": "sphere", "material": "grey", "center": [1, 2, 3], "radius": 2})"));
    EXPECT_EQ(sphere.center, dvec3(1, 2, 3));
    EXPECT_EQ(sphere.radius, 2.0);
}

TEST(SceneValues, Box) {
    const auto box = std::get<Box>(shapeOf(
        R"({"type": "box", "material": "grey", "center": [1, 2, 3], "u": [1, 0, 0], "v": [0, 0, 2], "w": [0, 3, 0]})"));
    EXPECT_EQ(box.center, dvec3(1, 2, 3));
    EXPECT_EQ(box.u, dvec3(1, 0, 0));
    EXPECT_EQ(box.v, dvec3(0, 0, 2));
    EXPECT_EQ(box.w, dvec3(0, 3, 0));
}

TEST(SceneValues, Cylinder) {
    const auto cylinder = std::get<Cylinder>(shapeOf(
        R"({"type": "cylinder", "material": "grey", "base": [0, 0, 0], "top": [0, 2, 0], "radius": 0.5})"));
    EXPECT_EQ(cylinder.base, dvec3(0, 0, 0));
    EXPECT_EQ(cylinder.top, dvec3(0, 2, 0));
    EXPECT_EQ(cylinder.radius, 0.5);
    EXPECT_TRUE(cylinder.capped);
    EXPECT_FALSE(std::get<Cylinder>(shapeOf(R"({"type": "cylinder", "material": "grey", "base": [0, 0, 0],
        "top": [0, 2, 0], "radius": 0.5, "capped": false})"))
                     .capped);
}

TEST(SceneValues, Cone) {
    const auto cone = std::get<Cone>(shapeOf(
        R"({"type": "cone", "material": "grey", "base": [0, 0, 0], "apex": [0, 2, 0], "radius": 0.5})"));
    EXPECT_EQ(cone.base, dvec3(0, 0, 0));
    EXPECT_EQ(cone.apex, dvec3(0, 2, 0));
    EXPECT_EQ(cone.radius, 0.5);
    EXPECT_TRUE(cone.capped);
    EXPECT_FALSE(std::get<Cone>(shapeOf(R"({"type": "cone", "material": "grey", "base": [0, 0, 0],
        "apex": [0, 2, 0], "radius": 0.5, "capped": false})"))
                     .capped);
}

TEST(SceneValues, Triangle) {
    const auto triangle = std::get<Triangle>(shapeOf(
        R"({"type": "triangle", "material": "grey", "vertices": [[1, 0, 0], [0, 2, 0], [0, 0, 3]]})"));
    EXPECT_EQ(triangle.vertices[0], dvec3(1, 0, 0));
    EXPECT_EQ(triangle.vertices[1], dvec3(0, 2, 0));
    EXPECT_EQ(triangle.vertices[2], dvec3(0, 0, 3));
}

// ---- lights --------------------------------------------------------------------------------------

TEST(SceneValues, PointLight) {
    const Light light = lightOf(
        R"({"type": "point", "name": "lamp", "color": [1, 0.5, 0], "position": [1, 2, 3], "power": "40 W"})");
    EXPECT_EQ(light.name, "lamp");
    EXPECT_EQ(light.color, Rgb(1, 0.5, 0));
    EXPECT_EQ(std::get<PointLight>(light.model).position, dvec3(1, 2, 3));
    EXPECT_EQ(std::get<PointLight>(light.model).power, 40.0 * W);
}

TEST(SceneValues, NameAndColorOfALightHaveDefaults) {
    const Light light = lightOf(R"({"type": "point", "position": [1, 2, 3], "power": "40 W"})");
    EXPECT_EQ(light.name, "");
    EXPECT_EQ(light.color, Rgb(1));
}

TEST(SceneValues, SpotLight) {
    const auto spot =
        std::get<SpotLight>(lightOf(R"({"type": "spot", "position": [1, 2, 3], "direction": [0, -2, 0],
        "angle": "30 deg", "inner_angle": "20 deg", "power": "500 mW"})")
                                .model);
    EXPECT_EQ(spot.position, dvec3(1, 2, 3));
    EXPECT_EQ(spot.direction, dvec3(0, -1, 0));
    EXPECT_EQ(spot.angle, 30.0 * deg);
    EXPECT_EQ(spot.innerAngle, 20.0 * deg);
    EXPECT_EQ(spot.power, 500.0 * (1e-3 * W));
    const auto sharp =
        std::get<SpotLight>(lightOf(R"({"type": "spot", "position": [0, 0, 0], "direction": [0, -2, 0],
        "angle": "180 deg", "power": "0 W"})")
                                .model);
    EXPECT_EQ(sharp.innerAngle, 180.0 * deg);
}

TEST(SceneValues, DirectionalLight) {
    const auto sun = std::get<DirectionalLight>(
        lightOf(R"({"type": "directional", "direction": [0, -1, 0], "irradiance": "100 mW/cm^2"})").model);
    EXPECT_EQ(sun.direction, dvec3(0, -1, 0));
    EXPECT_EQ(sun.irradiance.si, 1000.0);
    EXPECT_EQ(sun.angularSize.si, 0.0);
    EXPECT_EQ(std::get<DirectionalLight>(lightOf(R"({"type": "directional", "direction": [0, -1, 0],
        "irradiance": "1 W/m^2", "angular_size": "0.5 deg"})")
                                             .model)
                  .angularSize,
              0.5 * deg);
}

TEST(SceneValues, AreaLightOfEveryShape) {
    const auto rectangle =
        std::get<AreaLight>(lightOf(R"({"type": "area", "power": "5 W", "shape": {"type": "rectangle",
        "center": [0, 1, 0], "u": [1, 0, 0], "v": [0, 0, 1]}})")
                                .model);
    EXPECT_EQ(std::get<Rectangle>(rectangle.shape).v, dvec3(0, 0, 1));
    EXPECT_EQ(rectangle.power, 5.0 * W);
    EXPECT_FALSE(rectangle.twoSided);
    const auto disc =
        std::get<AreaLight>(lightOf(R"({"type": "area", "power": "5 W", "two_sided": true, "shape":
        {"type": "disc", "center": [0, 1, 0], "normal": [0, -1, 0], "radius": 2, "inner_radius": 1}})")
                                .model);
    EXPECT_EQ(std::get<Disc>(disc.shape).innerRadius, 1.0);
    EXPECT_TRUE(disc.twoSided);
    const auto sphere = std::get<AreaLight>(
        lightOf(
            R"({"type": "area", "power": "5 W", "shape": {"type": "sphere", "center": [0, 1, 0], "radius": 2}})")
            .model);
    EXPECT_EQ(std::get<Sphere>(sphere.shape).radius, 2.0);
}

TEST(SceneValues, EnvironmentLight) {
    const auto sky =
        std::get<EnvironmentLight>(lightOf(R"({"type": "environment", "radiance": "2 W/m^2/sr"})").model);
    EXPECT_EQ(sky.radiance.si, 2.0);
}

TEST(SceneValues, GratingLight) {
    const auto grating =
        std::get<ThesisGrating>(lightOf(R"({"type": "grating", "model": "thesis", "position": [0, 0, 1],
        "normal": [0, 0, -2], "slit_direction": [0, 3, 0],
        "aperture": {"type": "slits", "count": 5, "width": "1 um", "period": "2000 nm"}, "beam": {"diameter": "200 mm"}})")
                                    .model);
    EXPECT_EQ(grating.position, dvec3(0, 0, 1));
    EXPECT_EQ(grating.normal, dvec3(0, 0, -1));
    EXPECT_EQ(grating.slitDirection, dvec3(0, 1, 0));
    EXPECT_EQ(grating.slits.count, 5U);
    EXPECT_EQ(grating.slits.width, 1.0 * um);
    EXPECT_EQ(grating.slits.period, 2000.0 * nm);
    EXPECT_EQ(grating.beamDiameter, 200.0 * mm);
    EXPECT_EQ(grating.power, 1.0 * W);
    EXPECT_TRUE(grating.attenuated);
    EXPECT_EQ(grating.faults, Faults::limit);
}

TEST(SceneValues, GratingLightWithEveryOption) {
    const auto grating =
        std::get<ThesisGrating>(lightOf(R"({"type": "grating", "model": "thesis", "position": [0, 0, 1],
        "normal": [0, 0, -1], "slit_direction": [0, 1, 0], "attenuation": "none", "faults": "as-printed",
        "aperture": {"type": "slits", "count": 1, "width": "3 um", "period": "2 um"},
        "beam": {"diameter": "0.2 m", "power": "5 W"}})")
                                    .model);
    EXPECT_EQ(grating.slits.width, 3.0 * um);  // of a single slit the period means nothing
    EXPECT_EQ(grating.beamDiameter, 0.2 * m);
    EXPECT_EQ(grating.power, 5.0 * W);
    EXPECT_FALSE(grating.attenuated);
    EXPECT_EQ(grating.faults, Faults::asPrinted);
}

// ---- what the reader straightens -----------------------------------------------------------------

// Normalising rounds each component once or twice: a few units of 2^-53.
constexpr double kRounding = 1e-15;

TEST(SceneValues, DirectionsOfAnyLengthAreNormalised) {
    for (const std::string_view normal : {"[1, 1, 0]", "[1e-300, 1e-300, 0]", "[1e300, 1e300, 0]"}) {
        const auto plane = std::get<Plane>(shapeOf(fmt::format(
            R"({{"type": "plane", "material": "grey", "point": [0, 0, 0], "normal": {}}})", normal)));
        EXPECT_NEAR(plane.normal.x, std::numbers::sqrt2 / 2, kRounding) << normal;
        EXPECT_NEAR(plane.normal.y, std::numbers::sqrt2 / 2, kRounding) << normal;
        EXPECT_EQ(plane.normal.z, 0.0) << normal;
    }
}

TEST(SceneValues, SlitDirectionIsProjectedOntoTheGrating) {
    const auto grating =
        std::get<ThesisGrating>(lightOf(R"({"type": "grating", "model": "thesis", "position": [0, 0, 1],
        "normal": [0, 0, -1], "slit_direction": [0, 1, 1],
        "aperture": {"type": "slits", "count": 5, "width": "1 um", "period": "2 um"}, "beam": {"diameter": "200 mm"}})")
                                    .model);
    EXPECT_NEAR(grating.slitDirection.y, 1.0, kRounding);
    EXPECT_NEAR(grating.slitDirection.z, 0.0, kRounding);
}

TEST(SceneValues, EdgesOfFourDigitsAreMadePerpendicular) {
    const auto rectangle = std::get<Rectangle>(shapeOf(
        R"({"type": "rectangle", "material": "grey", "center": [0, 0, 0], "u": [1, 0, 0], "v": [0.00009, 1, 0]})"));
    EXPECT_EQ(rectangle.u, dvec3(1, 0, 0));
    EXPECT_EQ(rectangle.v, dvec3(0, 1, 0));
}

}  // namespace
}  // namespace fringe::scene
