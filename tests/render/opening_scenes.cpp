#include "render/opening_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/parse.hpp"

namespace fringe::testing {

std::ostream& operator<<(std::ostream& out, const OpeningScene& scene) {
    return out << scene.name;
}

scene::Scene parsed(const OpeningScene& c) {
    const std::string text = fmt::format(R"({{
  "fringe": 1,
  "image": {{ "width": 300, "height": 300 }},
  "camera": {{ "type": "orthographic", "position": [0, 0, 0.5], "target": [0, 0, -1], "height": {} }},
  "materials": {{ "wall": {} }},
  "objects": [{{ "type": "plane", "point": [0, 0, -1], "normal": {}, "material": "wall" }}],
  "lights": [{{ "type": "grating", "position": [0.01, 0.005, 0], "normal": [0, 0, -1], "slit_direction": [0.2, 1, 0],
    "aperture": {}, "beam": {{ "power": "1 W", {} }}{} }}]
}})",
                                         c.height, c.wall, c.normal, c.aperture, c.beam, c.more);
    return scene::parseScene(text, c.name);
}

scene::Grating& gratingOf(scene::Scene& scene) {
    return std::get<scene::Grating>(scene.lights.front().model);
}

optics::MaskAperture letter(units::Length pixel) {
    optics::MaskAperture mask{12, 16, pixel, {}};
    for (std::uint32_t y = 0; y < mask.rows; ++y) {
        for (std::uint32_t x = 0; x < mask.columns; ++x) {
            const bool open = (x >= 2 && x < 5) || (y < 3 && x >= 2) || (y >= 6 && y < 9 && x >= 2 && x < 9);
            mask.transmission.push_back(open ? 1.0F : y > 12 ? 0.3F : 0.0F);
        }
    }
    return mask;
}

double largest(const image::Pixel& pixel) {
    return std::max({std::abs(pixel.x), std::abs(pixel.y), std::abs(pixel.z)});
}

}  // namespace fringe::testing
