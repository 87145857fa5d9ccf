#include "cli/input.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fringe::cli {

void addSceneOptions(CLI::App& command, SceneSource& source) {
    command.add_option("SCENE", source.file, "scene file")->required();
    command
        .add_option(
            "--set", source.overrides,
            "PATH=VALUE: override a value of the scene, as in lights.lamp.power=5W or image.samples=16")
        ->allow_extra_args(false);
    command
        .add_option(
            "--tolerance", source.tolerance,
            "error of each grating's light that is accepted, as a share of its brightest place, 1e-5 to "
            "0.1: short for --set image.tolerance=")
        ->option_text("SHARE");
}

std::string readTextFile(const std::string& path) {
    if (std::filesystem::is_directory(path)) throw InputError(path + ": is a folder; give a scene file");
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (file) text << file.rdbuf();
    if (!file) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
    return std::move(text).str();
}

std::vector<scene::Override> overridesOf(const SceneSource& source) {
    std::vector<scene::Override> overrides;
    for (const std::string& given : source.overrides) {
        const std::size_t equals = given.find('=');
        if (equals == std::string::npos) {
            throw InputError(
                fmt::format("--set {}: has no \"=\"; write PATH=VALUE, as in image.samples=16", given));
        }
        overrides.push_back({given.substr(0, equals), given.substr(equals + 1)});
    }
    if (!source.tolerance.empty()) overrides.push_back({"image.tolerance", source.tolerance});
    return overrides;
}

scene::Scene parseSource(const SceneSource& source, const std::string& text) {
    return scene::parseScene(text, source.file, overridesOf(source));
}

}  // namespace fringe::cli
