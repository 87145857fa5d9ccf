#include "preview/live_shaders.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compile/interface.hpp"
#include "gpu/shader_interface.hpp"
#include "preview/shader_compiler.hpp"

namespace fringe::preview {
namespace {

// What the program has for this variant. Its own shaders have no names.
gpu::ShaderInterface offeredFor(const render::Variant& variant) {
    gpu::ShaderInterface offered = gpu::interfaceOf(render::embeddedShader(variant));
#define NAME(id, name) offered.constants[id] = #name;
    FRINGE_SPECIALISATION(NAME)
#undef NAME
    return offered;
}

}  // namespace

LiveShaders::LiveShaders(std::filesystem::path folder) : folder_(std::move(folder)) {}

const LiveShaders::Shader& LiveShaders::of(const render::Variant& variant, std::uint64_t version) {
    auto found = std::find_if(shaders_.begin(), shaders_.end(),
                              [&](const auto& known) { return known.first == variant; });
    if (found == shaders_.end()) found = shaders_.insert(found, {variant, {}});
    Shader& shader = found->second;
    if (shader.version == version) return shader;
    shader.version = version;
    shader.error.clear();
    try {
        auto code = compileShader(folder_, variant);
        const std::string problem = gpu::misfit(gpu::interfaceOf(code), offeredFor(variant));
        if (!problem.empty()) {
            throw ShaderError(
                fmt::format("{} does not fit this program: {}; change it back, or build the program again",
                            (folder_ / kMainShader).string(), problem));
        }
        // A comment that has changed changes nothing.
        if (!shader.code || *shader.code != code)
            shader.code = std::make_shared<const std::vector<std::uint32_t>>(std::move(code));
    } catch (const ShaderError& error) {
        shader.error = error.what();
    }
    return shader;
}

}  // namespace fringe::preview
