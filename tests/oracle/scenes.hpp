// Small scenes for the tests of the reference renderer.
#pragma once

#include "oracle/world.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

inline constexpr scene::Slits kThreeSlits{3, 1.0 * units::um, 2.0 * units::um};

// Looks from (0, 0, 2) along -z, 45 degrees up and down, at nothing. Odd sides: the middle pixel sees the z
// axis.
inline scene::Scene emptyScene(std::uint32_t side = 5) {
    scene::Scene scene;
    scene.image.width = side;
    scene.image.height = side;
    scene.camera = {
        {0.0, 0.0, 2.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, scene::Perspective{90.0 * units::deg, {}}, {}};
    return scene;
}

template <class Model>
void addObject(scene::Scene& scene, const scene::Shape& shape, const Model& model) {
    scene.materials.push_back({"", model});
    scene.objects.push_back({"", shape, static_cast<std::uint32_t>(scene.materials.size() - 1)});
}

// D65 is white light: on grey surfaces every channel of its sRGB is the radiance. `color` is what models of
// the thesis use of a light.
template <class Model>
void addLight(scene::Scene& scene, const Model& model, const scene::Rgb& color = scene::Rgb(1.0)) {
    scene.lights.push_back({"", color, d65(), model});
}

inline scene::Diffuse grey(double reflectance) {
    return {{{kFirst_nm, reflectance}, {kLast_nm, reflectance}}};
}

inline scene::Rgb rgbOf(const Xyz& xyz) {
    return glm::inverse(xyzFromRgb()) * xyz;
}

// A square in a plane z = const, seen from +z; `half` its half side.
inline scene::Rectangle squareFacingZ(double z, double half) {
    return {{0.0, 0.0, z}, {half, 0.0, 0.0}, {0.0, half, 0.0}};
}

inline scene::Emissive glowing(double radiance, bool twoSided = false) {
    return {radiance * units::W_per_m2_sr, d65(), twoSided};
}

inline scene::ThesisGrating gratingAt(const dvec3& position, const dvec3& normal, const dvec3& slitDirection,
                                      scene::Faults faults = scene::Faults::limit) {
    return {position, normal, slitDirection, kThreeSlits, 0.5 * units::m, 1.0 * units::W, true, faults};
}

}  // namespace fringe::oracle
