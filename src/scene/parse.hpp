// From the text of a scene file to a valid Scene, or to every problem found in it.
// The format is defined in one place, scenes/fringe.schema.json, which is embedded in this library and
// interpreted by it: keys, types, ranges, defaults and units are nowhere else.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace fringe::scene {

struct Problem {
    std::string place;    // "scenes/cd.json:14:9", or "--set lights.a.beam.power=5mW"
    std::string message;  // what is wrong; what would be right
};

// The scene cannot be used. what() has one line "place: message" for each problem.
class SceneError : public std::runtime_error {
public:
    explicit SceneError(std::vector<Problem> problems);  // at least one

    const std::vector<Problem>& problems() const { return problems_; }

private:
    std::vector<Problem> problems_;
};

// A value set from outside the file. The segments of `path`, between dots, are keys; an element of an array
// goes by its "name" or its index. `value` is read as JSON, or as a plain string where it is not JSON.
struct Override {
    std::string path;   // "lights.lamp.power"
    std::string value;  // "5 mW"
};

// Reads `text` (UTF-8 JSON with comments). `fileName` stands in the places of problems, and the files that
// the scene names are looked for in its folder, whether the file or an override names them. The overrides
// apply in their order, before anything is checked. Materials come in the alphabetical order of their names,
// objects and lights in that of the file. Lines and columns count from 1, columns in characters.
// Throws SceneError with every problem found, in the order of the file, then of the overrides.
Scene parseScene(std::string_view text, const std::string& fileName,
                 std::span<const Override> overrides = {});

// The JSON Schema of scene files: scenes/fringe.schema.json as it was when the library was built.
std::string_view schemaText();

}  // namespace fringe::scene
