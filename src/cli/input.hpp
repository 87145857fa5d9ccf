// Scene files from disk, with the overrides of the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "scene/parse.hpp"

namespace fringe::cli {

// The file or an option is not what it should be; the message says so.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct SceneSource {
    std::string file;
    std::vector<std::string> overrides;  // as given: "PATH=VALUE"
    std::string tolerance;               // as given: a value for image.tolerance; empty: the scene's
};

// The positional SCENE, the repeatable --set, and --tolerance.
void addSceneOptions(CLI::App& command, SceneSource& source);

// Throws InputError.
std::string readTextFile(const std::string& path);

// The overrides in their order. Throws InputError.
std::vector<scene::Override> overridesOf(const SceneSource& source);

// Throws InputError or scene::SceneError.
scene::Scene parseSource(const SceneSource& source, const std::string& text);

}  // namespace fringe::cli
