// Small scenes, and the problems of scenes as one text.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "scene/parse.hpp"

namespace fringe::scene {

// A scene with the materials "grey" and "mirror" and whatever else is given. The objects begin on line 5,
// the lights on line 8, both in column 1.
inline std::string sceneWith(std::string_view objects, std::string_view lights = "") {
    return fmt::format(R"({{"fringe": 1,
"camera": {{"position": [0, 0, 3], "target": [0, 0, 0]}},
"materials": {{"grey": {{"type": "diffuse"}}, "mirror": {{"type": "conductor", "metal": "silver"}}}},
"objects": [
{}
],
"lights": [
{}
]}}
)",
                       objects, lights);
}

// The same with one material, on line 3 from column 20.
inline std::string sceneWithMaterial(std::string_view material) {
    return fmt::format(R"({{"fringe": 1,
"camera": {{"position": [0, 0, 3], "target": [0, 0, 0]}},
"materials": {{"it": {}}}}}
)",
                       material);
}

// The same with one camera, on line 2 from column 11.
inline std::string sceneWithCamera(std::string_view camera) {
    return fmt::format("{{\"fringe\": 1,\n\"camera\": {}}}\n", camera);
}

// What parseScene says, or "no problem".
inline std::string problemsOf(std::string_view text, const std::vector<Override>& overrides = {}) {
    try {
        parseScene(text, "s", overrides);
        return "no problem";
    } catch (const SceneError& error) {
        return error.what();
    }
}

inline std::string problemsOfObject(std::string_view object) {
    return problemsOf(sceneWith(object));
}
inline std::string problemsOfLight(std::string_view light) {
    return problemsOf(sceneWith("", light));
}
inline std::string problemsOfCamera(std::string_view camera) {
    return problemsOf(sceneWithCamera(camera));
}

}  // namespace fringe::scene
