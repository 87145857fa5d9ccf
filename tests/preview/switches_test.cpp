// What switches leave of a scene.
#include "preview/switches.hpp"

#include <gtest/gtest.h>

#include "scene/parse.hpp"

namespace fringe::preview {
namespace {

scene::Scene glassRoom() {
    return scene::parseScene(R"({
      "fringe": 1,
      "camera": { "position": [0, 0, 3], "target": [0, 0, 0], "fov": "40 deg" },
      "materials": {
        "glass": { "type": "dielectric", "ior": 1.5 },
        "wall": { "type": "diffuse", "reflectance": 0.5 } },
      "objects": [
        { "type": "plane", "point": [0, 0, -1], "normal": [0, 0, 1], "material": "wall" },
        { "type": "sphere", "center": [0, 0, 0], "radius": 0.5, "material": "glass" } ],
      "lights": [
        { "name": "daylight", "type": "point", "position": [0, 1, 2], "power": "2 W" },
        { "name": "laser", "type": "point", "position": [1, 1, 2], "power": "2 W",
          "spectrum": { "type": "laser", "wavelength": "532 nm" } } ] })",
                             "glassRoom.json");
}

TEST(Switches, LeaveASceneAsItIsUnlessTheySaySo) {
    const scene::Scene scene = switched(glassRoom(), {});
    EXPECT_EQ(scene.lights.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<scene::Dielectric>(scene.materials[0].model));
}

TEST(Switches, TurnLightsOff) {
    const scene::Scene scene = switched(glassRoom(), {.darkLights = {0}});
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].name, "laser");
}

TEST(Switches, MakeGlassMatt) {
    const scene::Scene scene = switched(glassRoom(), {.mattOnly = true});
    for (const scene::Material& material : scene.materials)
        EXPECT_TRUE(std::holds_alternative<scene::Diffuse>(material.model));
}

TEST(Switches, LeaveOutShadows) {
    EXPECT_TRUE(switched(glassRoom(), {}).castsShadows);
    EXPECT_FALSE(switched(glassRoom(), {.noShadows = true}).castsShadows);
}

// Of daylight a band has its share, whose parts add up to the whole; of a laser it has all or nothing.
TEST(Switches, LeaveTheLightOfABand) {
    const auto power = [](double wavelength_nm, std::size_t light) {
        const optics::Spectrum spectrum =
            switched(glassRoom(), {.wavelength_nm = wavelength_nm}).lights[light].spectrum;
        EXPECT_TRUE(spectrum.density.empty());
        EXPECT_EQ(spectrum.lines.size(), 1U);
        EXPECT_NEAR(spectrum.lines[0].wavelength / units::nm, wavelength_nm, 1e-9);
        return spectrum.lines[0].power;
    };
    double sum = 0.0;
    for (double middle = 385.0; middle < 780.0; middle += kBand_nm) sum += power(middle, 0);
    EXPECT_NEAR(sum, 1.0, 1e-9);
    EXPECT_NEAR(power(530.0, 1), 1.0, 1e-12);
    EXPECT_EQ(power(550.0, 1), 0.0);
}

}  // namespace
}  // namespace fringe::preview
