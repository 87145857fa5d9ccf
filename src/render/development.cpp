#include "render/development.hpp"

#include <cassert>

#include "optics/color.hpp"
#include "optics/spectrum.hpp"

namespace fringe::render {

image::ColorSpace colorSpaceOf(const scene::Image& image) {
    switch (image.colorSpace) {
        case scene::ColorSpace::srgb:
            return image::ColorSpace::srgb;
        case scene::ColorSpace::displayP3:
            return image::ColorSpace::displayP3;
        case scene::ColorSpace::rec2020:
            return image::ColorSpace::rec2020;
    }
    assert(false);
    return image::ColorSpace::srgb;
}

std::optional<image::Development> developmentOf(const scene::Scene& scene) {
    image::Development development{.colorSpace = colorSpaceOf(scene.image)};
    if (scene.camera.whiteBalance) {
        const glm::dvec3 light = optics::xyzPerWatt(*scene.camera.whiteBalance, optics::constantCurve(1.0));
        // As bright as display white: balance changes colours alone.
        const auto matrix = image::adaptation(light / light.y, image::displayWhite());
        if (!matrix) return std::nullopt;
        development.whiteBalance = *matrix;
    }
    return development;
}

}  // namespace fringe::render
