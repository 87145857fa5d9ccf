// Devices and surfaces that are lost while the preview is open, by a Vulkan layer (losing_layer.cpp).
#include <gtest/gtest.h>
#include <json/json.h>

#include <sstream>

#include "preview/session.hpp"

namespace fringe::preview {
namespace {

class Loss : public testing::Test {
protected:
    // The next work of this kind is lost: "renderer", "window" or "surface".
    void lose(const std::string& what) const { image::putBytes(command(), what); }
    bool isLost() const {
        return becomes([&] { return !std::filesystem::exists(command()); });
    }
    std::filesystem::path command() const { return folder_ / "lose"; }
    std::filesystem::path scene() const { return folder_ / "scene.json"; }
    std::filesystem::path edited() const { return folder_ / "scene-edited.json"; }

    std::unique_ptr<Session> open() const {
        image::putBytes(scene(), image::bytesOf(kScene));
        auto session = std::make_unique<Session>(
            cli::Arguments{"preview", scene().string(), "--samples", "2", "--set", "image.width=300", "--set",
                           "image.height=480"},
            std::make_shared<const Display>(),
            std::map<std::string, std::string>{
                {"VK_LAYER_PATH", FRINGE_LAYERS ":/usr/share/vulkan/explicit_layer.d"},
                {"VK_INSTANCE_LAYERS", "VK_LAYER_FRINGE_losing"},
                {"FRINGE_LOSE", command().string()}});
        EXPECT_TRUE(session->completes());
        return session;
    }

    image::TestFolder folder_;
};

using LossOnDevice = Loss;

// Orbiting makes work for both devices. What was there before is there again, with the change to the scene;
// the second time it is saved.
TEST_F(LossOnDevice, OfTheRenderersDeviceIsMadeGoodOnce) {
    const auto session = open();
    session->click(kMoreSlitsX, kMoreSlitsY);
    session->key("h");
    EXPECT_TRUE(session->completes());
    const Screen before = session->picture();
    lose("renderer");
    session->key("h");
    EXPECT_TRUE(isLost());
    EXPECT_TRUE(becomes([&] { return session->picture().pixels != before.pixels; }));  // the notice
    session->key("h");                                                                 // takes it away
    EXPECT_TRUE(becomes([&] { return session->picture().pixels == before.pixels; }));
    lose("renderer");
    session->key("h");
    const cli::Outcome outcome = session->end();
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("the device was lost while "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("the changed scene is in " + edited().string()), std::string::npos)
        << outcome.err;
    Json::Value saved;
    std::istringstream(image::bytesOf(edited())) >> saved;
    EXPECT_EQ(saved["lights"][1]["aperture"]["count"].asInt(), 2);
}

TEST_F(LossOnDevice, OfTheWindowsDeviceOrSurfaceIsMadeGoodOnce) {
    for (const char* what : {"window", "surface"}) {
        const auto session = open();
        const Screen before = session->picture();
        // A resting window draws itself now and then; a key would take the notice away if it came after that.
        lose(what);
        EXPECT_TRUE(isLost()) << what;
        EXPECT_TRUE(becomes([&] { return session->picture().pixels != before.pixels; })) << what;
        session->key("h");
        EXPECT_TRUE(becomes([&] { return session->picture().pixels == before.pixels; })) << what;
        const cli::Outcome outcome = session->quit();
        EXPECT_EQ(outcome.status, 0) << what;
        EXPECT_EQ(outcome.err, "") << what;
        EXPECT_FALSE(std::filesystem::exists(edited())) << what;
    }
}

}  // namespace
}  // namespace fringe::preview
