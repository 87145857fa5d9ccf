// For a program that was built without glslang.
#include "preview/shader_compiler.hpp"

namespace fringe::preview {

bool canCompileShaders() {
    return false;
}

std::vector<std::uint32_t> compileShader(const std::filesystem::path& /*folder*/,
                                         const render::Variant& /*variant*/) {
    throw ShaderError("this program was built without glslang");
}

}  // namespace fringe::preview
