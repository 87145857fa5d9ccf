// The preview from outside: a window of a virtual display, a mouse, a keyboard, and the pixels of the screen.
#include <gtest/gtest.h>
#include <json/json.h>

#include <cmath>
#include <sstream>

#include "image/color_space.hpp"
#include "image/reader.hpp"
#include "preview/session.hpp"

namespace fringe::preview {
namespace {

using cli::Arguments;

constexpr int kPanel = 340;  // pixels, of the window's left

const std::string kScene = FRINGE_SOURCE_DIR "/scenes/thesis/figure-24.json";

Arguments previewOf(const std::string& scene, const Arguments& more = {}) {
    Arguments arguments{"preview",         scene,   "--samples",       "4", "--set",
                        "image.width=500", "--set", "image.height=480"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

void expectDone(const cli::Outcome& outcome) {
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
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

// What `fringe render` writes, in the codes of its file.
Screen rendered(const Session& session, const Arguments& more = {}) {
    const std::string file = (session.folder() / "rendered.png").string();
    Arguments arguments{
        "render", kScene,           "-o", file, "--set", "image.width=500", "--set", "image.height=480",
        "--set",  "image.samples=4"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expectDone(cli::run(arguments));
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

// Values in uniforms round otherwise than compiled ones: at silhouettes a unit in the last place decides what
// a pixel shows, in one of a thousand (tests/render/pipelines_test.cpp).
constexpr double kSilhouettes = 1e-3;

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
    ASSERT_TRUE(session.completes());
    const Screen orbited = pictureOf(session);
    EXPECT_GT(shareOfDifferent(orbited, home), 0.2);
    session.key("h");
    ASSERT_TRUE(session.completes());
    EXPECT_EQ(shareOfDifferent(pictureOf(session), home), 0.0);
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
    ASSERT_TRUE(session.completes());
    EXPECT_EQ(shareOfDifferent(pictureOf(session), before), 0.0);
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

TEST(Window, WithoutADisplayIsAClearError) {
    for (const char* display : {"", ":12345"}) {
        const cli::Outcome outcome = cli::run(previewOf(kScene), {.environment = {{"DISPLAY", display}}});
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err.find("there is no display"), std::string::npos) << outcome.err;
    }
}

TEST(Window, IsNotOpenedForAWrongScene) {
    const cli::Outcome outcome = cli::run(previewOf(kScene, {"--set", "image.nosuch=1"}));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("nosuch"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace fringe::preview
