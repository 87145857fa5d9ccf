// Shaders from a folder: what is made of good ones, and what is said of others.
#include "preview/live_shaders.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "image/pictures.hpp"
#include "preview/shader_compiler.hpp"

namespace fringe::preview {
namespace {

// A copy of the renderer's shaders.
class LiveShadersTest : public testing::Test {
protected:
    void SetUp() override {
        if (!canCompileShaders()) GTEST_SKIP() << "built without the glslang library";
        for (const auto& entry : std::filesystem::directory_iterator(FRINGE_SOURCE_DIR "/shaders"))
            std::filesystem::copy(entry.path(), folder_.path());
    }

    std::filesystem::path file(const std::string& name) const { return folder_ / name; }

    // With the first `from` made `to`.
    void replace(const std::string& name, const std::string& from, const std::string& to) const {
        std::string text = image::bytesOf(file(name));
        ASSERT_NE(text.find(from), std::string::npos);
        image::putBytes(file(name), text.replace(text.find(from), from.size(), to));
    }

    const LiveShaders::Shader& next() { return shaders_.of(kPlain, ++version_); }

    void expectError(const std::string& part) {
        const std::string error = next().error;
        EXPECT_NE(error.find(part), std::string::npos) << error;
    }

    static constexpr render::Variant kPlain{};
    image::TestFolder folder_;
    LiveShaders shaders_{folder_.path()};
    std::uint64_t version_ = 0;
};

TEST_F(LiveShadersTest, AreThoseOfTheProgramIfNobodyEditsThem) {
    for (const render::Variant& variant : {kPlain, render::Variant{false, true, true, false, true}}) {
        const LiveShaders::Shader& shader = shaders_.of(variant, 1);
        EXPECT_EQ(shader.error, "");
        EXPECT_NE(shader.code, nullptr);
    }
}

TEST_F(LiveShadersTest, StayThoseThatCouldBeCompiledLast) {
    const render::ShaderCode good = next().code;
    replace("slits.glsl", "{", "{ int broken = nothing;");
    expectError("'nothing' : undeclared identifier");
    EXPECT_EQ(next().code, good);
    replace("slits.glsl", "int broken = nothing;", "/* a comment */");
    EXPECT_EQ(next().code, good);
    EXPECT_EQ(next().error, "");
    replace("trace.glsl", "bool blocked = false;", "bool blocked = true;");
    EXPECT_NE(next().code, good);
}

TEST_F(LiveShadersTest, AreToldWhereTheyAreWrong) {
    const std::string text = image::bytesOf(file("lights.glsl"));
    const std::size_t lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    image::putBytes(file("lights.glsl"), text + "\nfloat half(float x) { return x / ; }\n");
    expectError("lights.glsl:" + std::to_string(lines + 2) + ":");
    image::putBytes(file("lights.glsl"), text);
    std::filesystem::remove(file("beam.glsl"));
    expectError("render.glsl:");
    expectError("header name: beam.glsl");
    std::filesystem::remove(file("render.comp"));
    expectError(file("render.comp").string() + " cannot be read");
    EXPECT_EQ(next().code, nullptr);
}

TEST_F(LiveShadersTest, AreRefusedWhereTheyDoNotFitTheProgram) {
    const auto refused = [&](const std::string& name, const std::string& from, const std::string& to,
                             const std::string& reason) {
        const std::string text = image::bytesOf(file(name));
        replace(name, from, to);
        expectError(reason);
        image::putBytes(file(name), text);
    };
    refused("render.glsl", "local_size_y = 8", "local_size_y = 4", "its workgroups are 8 x 4 x 1");
    refused("bindings.glsl", "binding = 3)", "binding = 30)",
            "nothing for set 0, binding 30 (RectangleBlock)");
    refused("bindings.glsl", "uint firstRow;", "uint firstRow; uint added;",
            "binding 1 (FilmBlock) is laid out");
    refused("specialisation.h", "X(10, HAS_DIFFUSE)", "X(99, HAS_DIFFUSE)", "no constant 99 (HAS_DIFFUSE)");
    refused("specialisation.h", "X(11, HAS_CONDUCTORS)           \\\n    X(12, HAS_DIELECTRICS)",
            "X(11, HAS_DIELECTRICS) \\\n    X(12, HAS_CONDUCTORS)",
            "constant 11 is HAS_DIELECTRICS, but HAS_CONDUCTORS");
    refused("render.glsl", "void main() {", "void main() { if (double(firstRow) > 1e9) return;",
            "capability 10");
    EXPECT_EQ(next().error, "");
    // Tables are bound only where gratings need them.
    replace("render.glsl", "result.state += 1u;", "result.state += 1u + responseEntry(0u).x;");
    expectError("nothing for set 0, binding 17 (responses)");
}

}  // namespace
}  // namespace fringe::preview
