// The renderer's shader from its source text, while the program runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "render/variant.hpp"

namespace fringe::preview {

// The source is not what it should be; the message has a line for each problem, with file and line.
class ShaderError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The file of a folder of shaders that all the others are included by.
inline constexpr const char* kMainShader = "render.comp";

// Whether the program was built with a compiler.
bool canCompileShaders();

// The SPIR-V of this variant of `folder`/render.comp. Throws ShaderError. One thread at a time.
std::vector<std::uint32_t> compileShader(const std::filesystem::path& folder, const render::Variant& variant);

}  // namespace fringe::preview
