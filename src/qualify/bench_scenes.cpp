#include "qualify/bench_scenes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <random>

namespace fringe::qualify {
namespace {

std::string rectangle(const char* center, const char* u, const char* v, const char* material) {
    return fmt::format(R"({{"type": "rectangle", "center": {}, "u": {}, "v": {}, "material": "{}"}})", center,
                       u, v, material);
}

constexpr const char* kLamp = R"({"type": "point", "position": [0, 0.9, 0.3], "power": "4 W"})";

constexpr const char* kThesisBeam =
    R"("model": "thesis", "attenuation": "circular", "beam": {"diameter": "200 mm"})";

constexpr const char* kDaylight =
    R"("efficiency": 1, "beam": {"profile": "rectangle", "width": "1 mm", "height": "200 mm",
        "power": "0.3 W", "spectrum": "D65"})";

std::string slits(const std::string& position, double z, std::uint32_t count, const char* beam) {
    return fmt::format(
        R"({{"type": "grating", "position": {}, "normal": [0, 0, {}], "slit_direction": [0, 1, 0],
            "aperture": {{"type": "slits", "count": {}, "width": "1 um", "period": "2 um"}}, {}}})",
        position, z, count, beam);
}

}  // namespace

std::string SceneParts::text() const {
    return fmt::format(
        R"({{"fringe": 1, "image": {{"width": {0}, "height": {0}, "samples": {1}}}, "camera": {2},
            "materials": {{{3}}}, "objects": [{4}], "lights": [{5}]}})",
        size, samples, camera, fmt::join(materials, ", "), fmt::join(objects, ",\n"),
        fmt::join(lights, ",\n"));
}

SceneParts roomScene() {
    SceneParts scene;
    scene.camera = R"({"position": [-0.45, 0.1, 3.3], "target": [0.12, -0.02, -0.4], "fov": "38 deg"})";
    scene.materials = {R"("white": {"type": "diffuse", "reflectance": 0.75})",
                       R"("red": {"type": "diffuse", "reflectance": [0.6, 0.06, 0.05]})",
                       R"("green": {"type": "diffuse", "reflectance": [0.12, 0.45, 0.1]})"};
    scene.objects = {rectangle("[0, 0, -1]", "[1, 0, 0]", "[0, 1, 0]", "white"),
                     rectangle("[0, -1, 0]", "[0, 0, 1]", "[1, 0, 0]", "white"),
                     rectangle("[0, 1, 0]", "[1, 0, 0]", "[0, 0, 1]", "white"),
                     rectangle("[-1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]", "red"),
                     rectangle("[1, 0, 0]", "[0, 0, 1]", "[0, 1, 0]", "green")};
    scene.lights = {kLamp};
    return scene;
}

SceneParts fiveGratingsScene(GratingModel model) {
    SceneParts scene = roomScene();
    const char* beam = model == GratingModel::thesis ? kThesisBeam : kDaylight;
    for (std::uint32_t count = 1; count <= 5; ++count) {
        const double y = 0.34 * (3.0 - count);
        scene.lights.push_back(slits(fmt::format("[0.35, {:.2f}, 0.25]", y), -1, count, beam));
    }
    return scene;
}

SceneParts softScene() {
    SceneParts scene = roomScene();
    scene.size = 200;
    scene.camera =
        R"({"position": [-0.45, 0.1, 3.3], "target": [0.12, -0.02, -0.4], "fov": "38 deg",
            "lens": {"diameter": "60 mm", "focus_distance": "3.5 m"}})";
    scene.objects.push_back(
        R"({"type": "sphere", "center": [-0.4, -0.65, -0.2], "radius": 0.35, "material": "white"})");
    scene.lights = {
        R"({"type": "area", "power": "5 W",
            "shape": {"type": "rectangle", "center": [0, 0.99, 0], "u": [0.3, 0, 0], "v": [0, 0, 0.3]}})",
        slits("[0.35, 0, 0.25]", -1, 5, kDaylight)};
    return scene;
}

SceneParts manyGratingsScene(std::uint32_t count, bool hidden) {
    SceneParts scene = roomScene();
    const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t row = i / columns, column = i % columns;
        const double x = -0.9 + 1.8 * (column + 0.5) / columns;
        const double y = -0.9 + 1.8 * (row + 0.5) / columns;
        const std::string beam = fmt::format(
            R"("efficiency": 1, "beam": {{"profile": "gaussian", "diameter": "40 mm", "power": "{:g} W",
                "spectrum": {{"type": "laser", "wavelength": "632.8 nm"}}}})",
            1.0 / count);
        scene.lights.push_back(slits(fmt::format("[{:.4f}, {:.4f}, {}]", x, y, hidden ? 6.0 : 0.25),
                                     hidden ? 1 : -1, 2, beam.c_str()));
    }
    return scene;
}

SceneParts spheresScene(std::uint32_t count) {
    SceneParts scene;
    scene.camera = R"({"position": [0, 0.6, 4.5], "target": [0, -0.2, 0], "fov": "40 deg"})";
    scene.materials = {R"("white": {"type": "diffuse", "reflectance": 0.7})"};
    scene.objects = {rectangle("[0, -1.2, 0]", "[4, 0, 0]", "[0, 0, 4]", "white")};
    scene.lights = {R"({"type": "point", "position": [1.5, 3, 2], "power": "120 W"})"};
    const double radius = 0.3 * std::cbrt(10.0 / count);
    std::mt19937 random(1);  // its sequence is part of the language's standard, distributions are not
    const auto coordinate = [&] { return 2.0 * random() / double{std::mt19937::max()} - 1.0; };
    for (std::uint32_t i = 0; i < count; ++i) {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        scene.objects.push_back(fmt::format(
            R"({{"type": "sphere", "center": [{:.6f}, {:.6f}, {:.6f}], "radius": {:.6f}, "material": "white"}})",
            x, y, z, radius));
    }
    return scene;
}

SceneParts emptyScene() {
    SceneParts scene;
    scene.camera = R"({"position": [0, 0, 1], "target": [0, 0, 0]})";
    return scene;
}

}  // namespace fringe::qualify
