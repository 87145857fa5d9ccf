// By the glslang library and SPIRV-Tools, with the options that the build gives to glslangValidator and
// spirv-opt (shaders/CMakeLists.txt).
#include "preview/shader_compiler.hpp"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <spirv-tools/optimizer.hpp>
#include <sstream>

namespace fringe::preview {
namespace {

std::optional<std::string> textOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    return stream ? std::optional(std::move(text)) : std::nullopt;
}

// The files beside render.comp.
class Includer : public glslang::TShader::Includer {
public:
    explicit Includer(std::filesystem::path folder) : folder_(std::move(folder)) {}

    IncludeResult* includeLocal(const char* name, const char* /*includer*/, std::size_t /*depth*/) override {
        const std::filesystem::path file = folder_ / name;
        auto text = textOf(file);
        if (!text) return nullptr;  // glslang then says where it is included
        auto& kept = texts_.emplace_back(std::make_unique<std::string>(std::move(*text)));
        return results_
            .emplace_back(std::make_unique<IncludeResult>(name, kept->data(), kept->size(), nullptr))
            .get();
    }

    void releaseInclude(IncludeResult* /*result*/) override {}  // all at the end

private:
    std::filesystem::path folder_;
    std::vector<std::unique_ptr<std::string>> texts_;
    std::vector<std::unique_ptr<IncludeResult>> results_;
};

// Without the count of errors in the end, and no longer than a window has room for.
[[noreturn]] void fail(const char* log) {
    constexpr int kMostLines = 5;
    std::istringstream lines(log);
    std::string message;
    int count = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.find("compilation error") != std::string::npos) continue;
        if (++count > kMostLines) break;
        message += (count > 1 ? "\n" : "") + line;
    }
    throw ShaderError(message.empty() ? "glslang does not say what is wrong" : message);
}

// As the build does it: a driver then gets to see the same, and no bindings that this variant has no use for.
std::vector<std::uint32_t> optimised(const std::vector<std::uint32_t>& spirv) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
    optimizer.SetMessageConsumer([](auto...) {});  // remarks about what it could not inline
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);  // glslang's word is taken for it
    std::vector<std::uint32_t> result;
    const bool isDone = optimizer.RegisterPassesFromFlags({FRINGE_SPIRV_PASSES}) &&
                        optimizer.Run(spirv.data(), spirv.size(), &result, options);
    if (!isDone) throw ShaderError("SPIRV-Tools cannot read what glslang has made of the shader");
    return result;
}

}  // namespace

bool canCompileShaders() {
    return true;
}

std::vector<std::uint32_t> compileShader(const std::filesystem::path& folder,
                                         const render::Variant& variant) {
    static const bool isReady = glslang::InitializeProcess();
    if (!isReady) throw ShaderError("glslang cannot start");
    const auto text = textOf(folder / kMainShader);
    if (!text) throw ShaderError((folder / kMainShader).string() + " cannot be read");
    const std::string definitions = fmt::format(
        "#define BANDED {:d}\n#define SLITS {:d}\n#define OPENINGS {:d}\n#define DISCS {:d}\n#define TREE "
        "{:d}\n",
        variant.banded, variant.slits, variant.openings, variant.discs, variant.tree);

    glslang::TShader shader(EShLangCompute);
    const char* source = text->data();
    const auto length = static_cast<int>(text->size());
    shader.setStringsWithLengthsAndNames(&source, &length, &kMainShader, 1);
    shader.setPreamble(definitions.c_str());
    constexpr int kVulkanSemantics = 100;  // the version of GLSL's dialect for Vulkan
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, kVulkanSemantics);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
    constexpr auto kRules = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    Includer includer(folder);
    if (!shader.parse(GetDefaultResources(), kVulkanSemantics, false, kRules, includer))
        fail(shader.getInfoLog());
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(kRules)) fail(program.getInfoLog());
    std::vector<std::uint32_t> spirv;
    glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), spirv);
    return optimised(spirv);
}

}  // namespace fringe::preview
