// The example of docs/scene-format.md: it works, and however it is damaged the reader neither crashes nor
// throws anything but SceneError. The scenes that come with Fringe work too. Plus the time that a large scene
// takes.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene/support.hpp"

namespace fringe::scene {
namespace {

std::string exampleOfThePage() {
    std::ifstream file(FRINGE_SOURCE_DIR "/docs/scene-format.md", std::ios::binary);
    std::ostringstream page;
    page << file.rdbuf();
    const std::string text = page.str();
    const std::string_view open = "```jsonc\n";
    const std::size_t begin = text.find(open) + open.size();
    return text.substr(begin, text.find("```", begin) - begin);
}

// True if the text is a scene, false if it has problems; anything else that is thrown fails the test.
bool isScene(std::string_view text) {
    try {
        parseScene(text, "s");
        return true;
    } catch (const SceneError& error) {
        EXPECT_FALSE(error.problems().empty());
        for (const Problem& problem : error.problems()) {
            EXPECT_EQ(problem.place.substr(0, 2), "s:");
            EXPECT_FALSE(problem.message.empty());
        }
        return false;
    }
}

TEST(SceneExample, IsAScene) {
    const Scene scene = parseScene(exampleOfThePage(), "s");
    EXPECT_EQ(scene.objects.size(), 2U);
    EXPECT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.materials.size(), 2U);
}

TEST(SceneExample, EveryShippedSceneIsSound) {
    std::size_t scenes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(FRINGE_SOURCE_DIR "/scenes")) {
        const std::filesystem::path& path = entry.path();
        if (path.extension() != ".json" || path.filename() == "fringe.schema.json") continue;
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        EXPECT_NO_THROW(parseScene(text.str(), path.string())) << path;
        ++scenes;
    }
    EXPECT_GT(scenes, 0U);
}

TEST(SceneExample, EveryTruncationIsAProblem) {
    std::string example = exampleOfThePage();
    example.erase(example.find_last_of('}') + 1);
    for (std::size_t length = 0; length < example.size(); ++length) {
        EXPECT_FALSE(isScene(std::string_view(example).substr(0, length))) << length;
    }
}

TEST(SceneExample, EveryDeletionOfAByteIsASceneOrAProblem) {
    const std::string example = exampleOfThePage();
    std::size_t scenes = 0;
    for (std::size_t at = 0; at < example.size(); ++at) {
        std::string damaged = example;
        damaged.erase(at, 1);
        if (isScene(damaged)) ++scenes;
    }
    EXPECT_GT(scenes, 0U);  // spaces, digits, letters of texts
    EXPECT_LT(scenes, example.size());
}

TEST(SceneExample, EveryReplacementOfAByteIsASceneOrAProblem) {
    const std::string example = exampleOfThePage();
    for (const char replacement : {'\0', '"', '{', ']', '-', '9', '\\', '/', '\xC3'}) {
        for (std::size_t at = 0; at < example.size(); ++at) {
            std::string damaged = example;
            damaged[at] = replacement;
            isScene(damaged);
        }
    }
}

std::string manySpheres(int count, std::string_view radius) {
    std::string objects;
    for (int i = 0; i < count; ++i) {
        objects += fmt::format(
            R"({}{{"type": "sphere", "name": "s{}", "center": [{}, 0.123456, -0.5], "radius": {}, "material": "grey"}})",
            i == 0 ? "" : ", ", i, i * 1e-5, radius);
    }
    return sceneWith(objects);  // all on one line, so that counting columns could be quadratic
}

double secondsToRead(const std::string& text) {
    const auto start = std::chrono::steady_clock::now();
    isScene(text);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Twenty times the spheres, each with a problem, take twenty times as long if all is linear, and four hundred
// times if any of it is quadratic. The limit lies between the two with room for a busy machine.
TEST(SceneExample, TimeGrowsInProportion) {
    const std::string small = manySpheres(1'000, "-1");
    const std::string large = manySpheres(20'000, "-1");
    secondsToRead(small);  // reads the schema
    EXPECT_LT(secondsToRead(large), 100 * secondsToRead(small));
}

}  // namespace
}  // namespace fringe::scene
