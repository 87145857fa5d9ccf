#include "qualify/skip_features.hpp"

#include <fmt/format.h>

namespace fringe::qualify {
namespace {

constexpr std::string_view kShadows = "shadows", kSlits = "slit gratings";

// A shape behind the camera.
std::string shape(std::string_view type, std::string_view place, std::string_view material = "white") {
    return fmt::format(R"({{"type": "{}", {}, "material": "{}"}})", type, place, material);
}

// The usual shape, of a material.
std::string rectangle(std::string_view material) {
    return shape("rectangle", R"("center": [0, 0, 6], "u": [0.1, 0, 0], "v": [0, 0.1, 0])", material);
}

std::string areaLight(std::string_view lamp) {
    return fmt::format(R"({{"type": "area", "power": "1e-12 W", "shape": {{{}}}}})", lamp);
}

constexpr const char* kLaser =
    R"("efficiency": 1, "beam": {"diameter": "1 mm", "power": "1 mW",
                                 "spectrum": {"type": "laser", "wavelength": "632.8 nm"}})";
constexpr const char* kDaylightBeam =
    R"("efficiency": 1, "beam": {"diameter": "1 mm", "power": "1 mW", "spectrum": "D65"})";
constexpr const char* kThesis = R"("model": "thesis", "beam": {"diameter": "200 mm"})";
constexpr const char* kThreeSlits = R"("type": "slits", "count": 3, "width": "1 um", "period": "2 um")";

// A grating behind the camera that shines away.
std::string grating(std::string_view aperture, std::string_view beam) {
    return fmt::format(
        R"({{"type": "grating", "position": [0, 0, 6], "normal": [0, 0, 1], "slit_direction": [0, 1, 0],
            "aperture": {{{}}}, {}}})",
        aperture, beam);
}

std::vector<SkipFeature> makeFeatures() {
    return {
        {.name = kShadows, .without = kRoom, .object = rectangle("white")},
        {.name = "mirrors",
         .without = kShadows,
         .material = R"("gold": {"type": "conductor", "metal": "gold"})",
         .object = rectangle("gold")},
        {.name = "glass",
         .without = kShadows,
         .material = R"("glass": {"type": "dielectric", "ior": 1.5})",
         .object = rectangle("glass")},
        {.name = "glowing surfaces",
         .without = kShadows,
         .material = R"("glow": {"type": "emissive", "radiance": "1 W/m^2/sr"})",
         .object = rectangle("glow")},
        {.name = "planes",
         .without = kShadows,
         .object = shape("plane", R"("point": [0, 0, 6], "normal": [0, 0, -1])")},
        {.name = "discs",
         .without = kShadows,
         .object = shape("disc", R"("center": [0, 0, 6], "normal": [0, 0, 1], "radius": 0.1)")},
        {.name = "spheres",
         .without = kShadows,
         .object = shape("sphere", R"("center": [0, 0, 6], "radius": 0.1)")},
        {.name = "boxes",
         .without = kShadows,
         .object =
             shape("box", R"("center": [0, 0, 6], "u": [0.1, 0, 0], "v": [0, 0.1, 0], "w": [0, 0, 0.1])")},
        {.name = "cylinders",
         .without = kShadows,
         .object = shape("cylinder", R"("base": [0, 0, 6], "top": [0, 0.1, 6], "radius": 0.1)")},
        {.name = "cones",
         .without = kShadows,
         .object = shape("cone", R"("base": [0, 0, 6], "apex": [0, 0.1, 6], "radius": 0.1)")},
        {.name = "triangles",
         .without = kShadows,
         .object = shape("triangle", R"("vertices": [[0, 0, 6], [0.1, 0, 6], [0, 0.1, 6]])")},
        {.name = "area lights",
         .without = kRoom,
         .light =
             areaLight(R"("type": "rectangle", "center": [0, 0, 6], "u": [0.1, 0, 0], "v": [0, 0.1, 0])")},
        {.name = "spot lights",
         .without = kRoom,
         .light = R"({"type": "spot", "position": [0, 0, 6], "direction": [0, 0, 1], "angle": "20 deg",
                      "power": "1 W"})"},
        {.name = "directional lights",
         .without = kRoom,
         .light = R"({"type": "directional", "direction": [0.2, -1, -0.4], "irradiance": "1e-12 W/m^2"})"},
        {.name = "sky",
         .without = kRoom,
         .light = R"({"type": "environment", "radiance": "1e-12 W/m^2/sr"})"},
        {.name = "thesis gratings", .without = kRoom, .light = grating(kThreeSlits, kThesis)},
        {.name = kSlits, .without = kRoom, .light = grating(kThreeSlits, kLaser)},
        {.name = "spectral tables", .without = kSlits, .light = grating(kThreeSlits, kDaylightBeam)},
        {.name = "round apertures",
         .without = kRoom,
         .light = grating(R"("type": "circle", "diameter": "50 um")", kLaser)},
        {.name = "polygonal apertures",
         .without = kRoom,
         .light = grating(R"("type": "polygon", "sides": 5, "diameter": "50 um")", kLaser)},
        {.name = "optical discs",
         .without = kShadows,
         .material = R"("cd": {"type": "optical-disc", "medium": "cd"})",
         .object = shape(
             "disc", R"("center": [0, 0, 6], "normal": [0, 0, 1], "radius": 0.06, "inner_radius": 0.0075)",
             "cd")},
        {.name = "depth of field", .without = kRoom, .lens = true},
    };
}

}  // namespace

const std::vector<SkipFeature>& skipFeatures() {
    static const std::vector<SkipFeature> features = makeFeatures();
    return features;
}

void add(const SkipFeature& feature, SceneParts& scene) {
    if (!feature.material.empty()) scene.materials.push_back(feature.material);
    if (!feature.object.empty()) scene.objects.push_back(feature.object);
    if (!feature.light.empty()) scene.lights.push_back(feature.light);
    if (feature.lens) {
        const std::string lens = R"(, "lens": {"diameter": "1 nm", "focus_distance": "3.5 m"}})";
        scene.camera.replace(scene.camera.rfind('}'), 1, lens);
    }
}

}  // namespace fringe::qualify
