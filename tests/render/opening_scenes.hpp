// Scenes of one opening and a wall that it lights, for the tests of openings.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "image/image.hpp"
#include "optics/aperture.hpp"
#include "scene/scene.hpp"

namespace fringe::testing {

// JSON of a scene's parts, of its beam and its grating the keys alone.
struct OpeningScene {
    const char* name;
    const char* aperture;
    const char* beam = R"("diameter": "200 um")";
    const char* wall = R"({ "type": "diffuse", "reflectance": 0.8 })";
    double height = 0.3;               // metres of the wall that the picture shows
    const char* more = "";             // keys of the grating
    const char* normal = "[0, 0, 1]";  // of the wall
};
std::ostream& operator<<(std::ostream& out, const OpeningScene& scene);

// A wall 1 m in front of the opening, which is near the middle of the picture of 300 x 300 pixels.
scene::Scene parsed(const OpeningScene& scene);
scene::Grating& gratingOf(scene::Scene& scene);

// A letter F, of neither symmetry, with some grey.
optics::MaskAperture letter(units::Length pixel);

double largest(const image::Pixel& pixel);

inline constexpr const char* kCircle = R"({ "type": "circle", "diameter": "2 um" })";
inline constexpr const char* kWhite = R"({ "type": "diffuse", "reflectance": 0.8 })";
inline constexpr const char* kHexagon = R"({ "type": "polygon", "sides": 6, "diameter": "20 um" })";

}  // namespace fringe::testing
