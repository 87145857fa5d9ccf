// The preview from outside: a window of a virtual display, a mouse, a keyboard, and the pixels of the screen.
#include <gtest/gtest.h>
#include <json/json.h>

#include <array>
#include <cmath>
#include <memory>
#include <sstream>

#include "image/color_space.hpp"
#include "image/reader.hpp"
#include "preview/session.hpp"

namespace fringe::preview {
namespace {

using cli::Arguments;

Arguments previewOf(const std::string& scene, const Arguments& more = {}) {
    Arguments arguments{"preview",         scene,   "--samples",       "4", "--set",
                        "image.width=500", "--set", "image.height=480"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

// Where two pictures differ by more than one code of 255.
double shareOfDifferent(const Screen& a, const Screen& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        int most = 0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            most = std::max(most, std::abs(int{a.pixels[i][channel]} - int{b.pixels[i][channel]}));
        if (most > 1) ++different;
    }
    return static_cast<double>(different) / static_cast<double>(a.pixels.size());
}

// The window without its panel.
Screen pictureOf(const Session& session) {
    const Screen window = session.picture();
    Screen picture{window.width - kPanel, window.height, {}};
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) picture.pixels.push_back(window.at(kPanel + x, y));
    return picture;
}

// In the codes of a PNG file.
Screen fileOf(const std::filesystem::path& file) {
    const image::Picture picture = image::readImage(file);
    Screen screen{picture.width, picture.height, {}};
    for (const image::RgbPixel& pixel : picture.pixels) {
        const auto code = [](float linear) {
            return static_cast<std::uint8_t>(std::lround(255.0 * image::encodeSrgb(double{linear})));
        };
        screen.pixels.push_back({code(pixel.r), code(pixel.g), code(pixel.b)});
    }
    return screen;
}

// What `fringe render` writes.
Screen rendered(const Session& session, const std::string& scene = kScene, const Arguments& more = {}) {
    const std::string file = (session.folder() / "rendered.png").string();
    Arguments arguments{
        "render",         scene, "-o", file, "--set", "image.width=500", "--set", "image.height=480", "--set",
        "image.samples=4"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expectDone(cli::run(arguments));
    return fileOf(file);
}

// Values in uniforms round otherwise than compiled ones: at silhouettes a unit in the last place decides what
// a pixel shows, in one of a thousand (tests/render/pipelines_test.cpp).
constexpr double kSilhouettes = 1e-3;

// Whether the window comes to show this picture, but for this share of its pixels. What it shows right after
// an event may be what was there before.
bool comesToShow(const Session& session, const Screen& expected, double share = kSilhouettes) {
    return becomes([&] { return shareOfDifferent(pictureOf(session), expected) <= share; });
}

// Whether it comes to show another picture than this one, in so many pixels.
bool comesToDiffer(const Session& session, const Screen& from, double share) {
    return becomes([&] { return shareOfDifferent(pictureOf(session), from) > share; });
}

bool comesToExist(const std::filesystem::path& file) {
    return becomes([&] { return std::filesystem::exists(file); });
}

TEST(WindowOnDevice, ShowsWhatRenderWrites) {
    Session session(previewOf(kScene));
    ASSERT_TRUE(session.completes()) << session.title();
    EXPECT_LE(shareOfDifferent(pictureOf(session), rendered(session)), kSilhouettes);
    expectDone(session.quit());
}

TEST(WindowOnDevice, OrbitsAndComesHome) {
    Session session(previewOf(kScene));
    ASSERT_TRUE(session.completes());
    const Screen home = pictureOf(session);
    session.drag(kPanel + 200, 200, kPanel + 300, 220);
    EXPECT_TRUE(comesToDiffer(session, home, 0.2));
    session.key("h");
    EXPECT_TRUE(comesToShow(session, home, 0.0));
    expectDone(session.quit());
}

TEST(WindowOnDevice, SurvivesResizingAndHiding) {
    Session session(previewOf(kScene));
    ASSERT_TRUE(session.completes());
    const Screen before = pictureOf(session);
    for (const int size : {700, 500, 900}) session.resize(size, size - 200);
    session.resize(kPanel + 1, 1);
    session.hide();
    session.show();
    session.resize(kPanel + 500, 480);
    EXPECT_TRUE(comesToShow(session, before, 0.0));
    expectDone(session.quit());
}

TEST(WindowOnDevice, TwoOfThemDoNotDisturbEachOther) {
    const auto display = std::make_shared<const Display>();
    // Side by side on the screen.
    const Arguments small = previewOf(kScene, {"--set", "image.width=280", "--set", "image.height=280"});
    Session first(small, display);
    Session second(small, display);
    second.move(kPanel + 300, 0);
    ASSERT_TRUE(first.completes());
    ASSERT_TRUE(second.completes());
    const Screen home = pictureOf(first);
    EXPECT_TRUE(comesToShow(second, home, 0.0));
    second.drag(kPanel + 100, 200, kPanel + 200, 220);
    EXPECT_TRUE(comesToDiffer(second, home, 0.1));
    EXPECT_TRUE(comesToShow(first, home, 0.0));
    expectDone(second.quit());
    first.key("h");
    EXPECT_TRUE(comesToShow(first, home, 0.0));
    expectDone(first.quit());
}

// Of twice the usual density: the panel takes twice as many pixels, and the window stays within the screen.
TEST(WindowOnDevice, FollowsTheDensityOfTheDisplay) {
    const auto display = std::make_shared<const Display>();
    display->setDensity(192);
    Session session(previewOf(kScene), display);
    ASSERT_TRUE(session.completes());
    const std::array<std::uint8_t, 3> background{28, 28, 28};
    EXPECT_TRUE(becomes([&] {
        const Screen window = session.picture();
        return window.width <= 1280 && window.height <= 900 && window.width > 3 * kPanel &&
               window.at(2 * kPanel - 10, 5) != background && window.at(2 * kPanel + 10, 5) == background;
    }));
    expectDone(session.quit());
}

TEST(WindowOnDevice, TellsHowQuickItWas) {
    Session session(previewOf(kScene, {"--stats", "stats.json"}));
    ASSERT_TRUE(session.completes());
    session.drag(kPanel + 200, 200, kPanel + 300, 220);
    ASSERT_TRUE(session.completes());
    const std::filesystem::path file = session.folder() / "stats.json";
    expectDone(session.quit());
    Json::Value stats;
    std::istringstream(image::bytesOf(file)) >> stats;
    EXPECT_GT(stats["first_picture_ms"].asDouble(), 0.0);
    EXPECT_GT(stats["camera_latency_ms"]["count"].asInt(), 3);
    EXPECT_GT(stats["longest_busy_ms"].asDouble(), 0.0);
}

// A scene file that may be changed.
class SceneFile {
public:
    SceneFile() { write(image::bytesOf(kScene)); }

    std::string path(const std::string& name = "scene.json") const { return (folder_ / name).string(); }
    void write(const std::string& text) const { image::putBytes(folder_ / "scene.json", text); }

    // With every `from` made `to`.
    void replace(const std::string& from, const std::string& to) const {
        std::string text = image::bytesOf(path());
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
        write(text);
    }

private:
    image::TestFolder folder_;
};

// Places of widgets in the panel, in pixels of the window.
constexpr int kExposureX = 107, kExposureY = 41;  // the middle of the slider

TEST(WindowOnDevice, AKnobChangesTheSceneWhichCanBeSaved) {
    const SceneFile file;
    Session session(previewOf(file.path()));
    ASSERT_TRUE(session.completes());
    const Screen before = pictureOf(session);
    session.click(kMoreSlitsX, kMoreSlitsY);
    session.key("ctrl+s");
    ASSERT_TRUE(comesToExist(file.path("scene-edited.json")));
    Json::Value saved;
    std::istringstream(image::bytesOf(file.path("scene-edited.json"))) >> saved;
    EXPECT_EQ(saved["lights"][1]["aperture"]["count"].asInt(), 2);
    const Screen expected = rendered(session, file.path("scene-edited.json"));
    EXPECT_GT(shareOfDifferent(expected, before), 0.01);
    // Takes the notice away that the file is written; a slow driver may show that after the first time.
    session.key("h");
    const bool isShown = comesToShow(session, expected);
    if (!isShown) session.key("h");
    EXPECT_TRUE(isShown || comesToShow(session, expected));
    expectDone(session.quit());
}

// Ctrl may go up before the other key of a command, which is then no key to fly with.
TEST(WindowOnDevice, ACommandDoesNotFly) {
    const SceneFile file;
    Session session(previewOf(file.path()));
    ASSERT_TRUE(session.completes());
    const Screen before = pictureOf(session);
    session.display().tool("keydown ctrl keydown s keyup ctrl sleep 0.3 keyup s");
    ASSERT_TRUE(comesToExist(file.path("scene-edited.json")));
    EXPECT_LT(shareOfDifferent(pictureOf(session), before), 0.1);  // the notice that it is saved
    Json::Value saved, scene;
    std::istringstream(image::bytesOf(file.path("scene-edited.json"))) >> saved;
    std::istringstream(image::bytesOf(kScene)) >> scene;
    EXPECT_EQ(saved["camera"], scene["camera"]);
    expectDone(session.quit());
}

TEST(WindowOnDevice, ASliderIsFollowedAndItsDelayReported) {
    Session session(previewOf(kScene, {"--stats", "stats.json"}));
    ASSERT_TRUE(session.completes());
    const Screen before = pictureOf(session);
    session.drag(kExposureX, kExposureY, kExposureX + 12, kExposureY);  // some two stops
    EXPECT_TRUE(comesToDiffer(session, before, 0.2));
    const std::filesystem::path file = session.folder() / "stats.json";
    expectDone(session.quit());
    Json::Value stats;
    std::istringstream(image::bytesOf(file)) >> stats;
    EXPECT_GT(stats["knob_latency_ms"]["count"].asInt(), 3);
}

TEST(WindowOnDevice, AChangedFileIsReadAgainAndABrokenOneIsNot) {
    const SceneFile file;
    Session session(previewOf(file.path()));
    ASSERT_TRUE(session.completes());
    const Screen before = pictureOf(session);
    const std::string good = image::bytesOf(file.path());
    file.write(good.substr(0, good.size() / 2));
    EXPECT_TRUE(comesToDiffer(session, before, 0.0));
    EXPECT_LT(shareOfDifferent(pictureOf(session), before), 0.2);  // a message in its lower part
    file.write(good);
    file.replace("\"width\": \"1 um\"", "\"width\": \"0.7 um\"");
    EXPECT_TRUE(comesToShow(session, rendered(session, file.path())));
    // One that is gone is told of, and the scene stays until it is back, as editors do that write another and
    // rename it.
    const Screen changed = pictureOf(session);
    std::filesystem::remove(file.path());
    EXPECT_TRUE(comesToDiffer(session, changed, 0.0));
    EXPECT_LT(shareOfDifferent(pictureOf(session), changed), 0.2);
    image::putBytes(file.path("other.json"), good);
    std::filesystem::rename(file.path("other.json"), file.path());
    EXPECT_TRUE(comesToShow(session, before));
    expectDone(session.quit());
}

// Half the radiance is a stop less of exposure, to the bit.
TEST(WindowOnDevice, AnEditedShaderIsCompiledAndABrokenOneIsNot) {
    if (!FRINGE_COMPILES_SHADERS) GTEST_SKIP() << "built without the glslang library";
    const image::TestFolder folder;
    for (const auto& entry : std::filesystem::directory_iterator(FRINGE_SOURCE_DIR "/shaders"))
        std::filesystem::copy(entry.path(), folder.path());
    Session session(previewOf(kScene, {"--shaders", folder.path().string()}));
    ASSERT_TRUE(session.completes());
    EXPECT_TRUE(comesToShow(session, rendered(session)));
    const Screen before = pictureOf(session);
    const std::string good = image::bytesOf(folder / "render.glsl");
    const std::string sum = "result.sum += sample_.radiance;";
    const auto edit = [&](const std::string& to) {
        std::string text = good;
        image::putBytes(folder / "render.glsl", text.replace(text.find(sum), sum.size(), to));
    };
    edit("result.sum += ;");
    EXPECT_TRUE(comesToDiffer(session, before, 0.0));
    EXPECT_LT(shareOfDifferent(pictureOf(session), before), 0.2);  // a message in its lower part
    edit("result.sum += 0.5 * sample_.radiance;");
    EXPECT_TRUE(comesToShow(session, rendered(session, kScene, {"--set", "image.exposure=-1"})));
    expectDone(session.quit());
}

TEST(WindowOnDevice, SavesThePictureThatItShows) {
    Session session(previewOf(kScene));
    ASSERT_TRUE(session.completes());
    const Screen shown = pictureOf(session);
    session.key("p");
    ASSERT_TRUE(comesToExist(session.folder() / "figure-24-preview.png"));
    ASSERT_TRUE(comesToExist(session.folder() / "figure-24-preview.exr"));
    EXPECT_EQ(fileOf(session.folder() / "figure-24-preview.png").pixels, shown.pixels);
    EXPECT_EQ(image::readImage(session.folder() / "figure-24-preview.exr").width, 500U);
    expectDone(session.quit());
}

TEST(Window, WithoutADisplayIsAClearError) {
    for (const char* display : {"", ":12345"}) {
        const cli::Outcome outcome = cli::run(previewOf(kScene), {.environment = {{"DISPLAY", display}}});
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err.find("there is no display"), std::string::npos) << outcome.err;
    }
}

TEST(Window, IsNotOpenedForAFolderWithoutShaders) {
    const cli::Outcome outcome = cli::run(previewOf(kScene, {"--shaders", FRINGE_SOURCE_DIR "/docs"}));
    EXPECT_EQ(outcome.status, FRINGE_COMPILES_SHADERS ? 1 : 2);
    const std::string reason = FRINGE_COMPILES_SHADERS ? "there is no render.comp" : "glslang-dev";
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
}

TEST(Window, IsNotOpenedForAWrongScene) {
    const cli::Outcome outcome = cli::run(previewOf(kScene, {"--set", "image.nosuch=1"}));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("nosuch"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace fringe::preview
