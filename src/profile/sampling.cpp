#include "profile/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fringe::profile {
namespace {

// How far above the surface the picture is taken: clear of the line's tolerance and of where rays leave a
// surface in single precision, 4e-6 of the largest coordinate.
double liftOver(const SurfaceLine& line) {
    const dvec3 size = glm::max(glm::abs(line.from), glm::abs(line.to));
    return 2.0 * kSurfaceTolerance + 1e-4 * std::max({size.x, size.y, size.z});
}

}  // namespace

scene::Scene lineScene(scene::Scene scene, const SurfaceLine& line, std::uint32_t samples) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const scene::Light& light = scene.lights[i];
        if (std::holds_alternative<scene::ThesisGrating>(light.model)) {
            throw LineError(fmt::format(
                "lights[{}] follows the thesis, which has no irradiance; give it \"model\": \"physical\"",
                i));
        }
    }
    for (scene::Material& material : scene.materials) {
        if (!std::holds_alternative<scene::Emissive>(material.model))
            material.model = scene::Diffuse{optics::constantCurve(1.0)};
    }
    const dvec3 above = line.at(0.5) + liftOver(line) * line.normal;
    const dvec3 right = (line.to - line.from) / line.length();
    scene.camera = {above,
                    above - line.normal,
                    glm::cross(line.normal, right),
                    scene::Orthographic{line.length() / samples},
                    {}};
    scene.image.width = samples;
    scene.image.height = 1;
    return scene;
}

}  // namespace fringe::profile
