// The renderer's shaders from a folder of their source, compiled again when that changes; what cannot be
// compiled leaves the last that could in its place, or in the beginning the program's own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "render/progressive.hpp"

namespace fringe::preview {

class LiveShaders {
public:
    explicit LiveShaders(std::filesystem::path folder);

    struct Shader {
        std::uint64_t version = 0;
        render::ShaderCode code;  // null: the program's own
        std::string error;        // why the code is not that of the files
    };

    // The shader as the files are now. `version`, not 0: another number for other texts.
    const Shader& of(const render::Variant& variant, std::uint64_t version);

private:
    std::filesystem::path folder_;
    std::list<std::pair<render::Variant, Shader>> shaders_;  // of the variants asked for so far
};

}  // namespace fringe::preview
