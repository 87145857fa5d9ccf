// Which device renders, and what is said when none can.
#include "cli/support.hpp"

namespace fringe::cli {
namespace {

const Surroundings kNoDriver{.environment = {{"VK_DRIVER_FILES", "/nonexistent"}}};

TEST(NoDriver, IsTheMachinesFaultAndSaysWhatToInstall) {
    const TestFolder folder;
    Surroundings here = kNoDriver;
    here.folder = folder.path();
    const std::vector<std::string> words{"no Vulkan driver", "apt-get install mesa-vulkan-drivers"};
    expectRefused(run(smallRender(), here), 2, words);
    expectRefused(run({"devices"}, here), 2, words);
    EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(NoDriver, IsNotAskedForWhereAPathIsWrong) {
    expectRefused(run(smallRender() + Arguments{"-o", "/nonexistent/a.png"}, kNoDriver), 1,
                  {"/nonexistent/a.png"});
    expectRefused(run(smallRender() + Arguments{"--stats", "/nonexistent/s.json"}, kNoDriver), 1,
                  {"/nonexistent/s.json"});
    expectRefused(run(smallRender() + Arguments{"-o", "a.tiff"}, kNoDriver), 1, {".png or .exr"});
}

TEST(NoDriver, TheReferenceNeedsNone) {
    const TestFolder folder;
    expectDone(run(smallReferenceRender() + Arguments{"-o", (folder / "a.png").string()}, kNoDriver));
}

TEST(NoDriver, NorDoScenesAndHelp) {
    expectDone(run({"info", roomFile()}, kNoDriver));
    expectDone(run({"validate", roomFile()}, kNoDriver));
    expectDone(run({"--version"}, kNoDriver));
}

// That the validation layer watches the renders of these tests, rather than being left out in silence.
TEST(Validation, IsRefusedWhereTheLayerIsMissing) {
    const TestFolder folder;
    const Surroundings noLayer{.folder = folder.path(), .environment = {{"VK_LAYER_PATH", "/nonexistent"}}};
    expectRefused(run(smallRender(), noLayer), 2,
                  {"VK_LAYER_KHRONOS_validation", "apt-get install vulkan-validationlayers"});
}

// The first device that can run Fringe, as the machine's own list has it.
Json::Value usableDevice() {
    const Outcome outcome = run({"devices", "--json"});
    expectDone(outcome);
    for (const Json::Value& device : parsedJson(outcome.out)) {
        if (device["usable"].asBool()) return device;
    }
    ADD_FAILURE() << "no device of this machine can run Fringe:\n" << outcome.out;
    return {};
}

TEST(ChoiceOnDevice, ListsTheDevices) {
    const Json::Value device = usableDevice();
    EXPECT_EQ(device["missing"].size(), 0U);
    const Outcome outcome = run({"devices"});
    expectDone(outcome);
    for (const char* key : {"name", "type", "driver", "vulkan"}) {
        EXPECT_NE(device[key].asString(), "") << key;
        EXPECT_TRUE(contains(outcome.out, device[key].asString())) << outcome.out << key;
    }
    EXPECT_TRUE(contains(outcome.out, "can run Fringe"));
}

TEST(ChoiceOnDevice, AWrongNameListsTheRightOnes) {
    const TestFolder folder;
    const Outcome outcome = run(smallRender() + Arguments{"--device", "nosuch"}, {.folder = folder.path()});
    expectRefused(outcome, 2, {"no device \"nosuch\"", usableDevice()["name"].asString()});
    EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(ChoiceOnDevice, TheCommandLineOverridesTheEnvironment) {
    const TestFolder folder;
    Surroundings here{.folder = folder.path(), .environment = {{"FRINGE_DEVICE", "nosuch"}}};
    expectRefused(run(smallRender(), here), 2, {"no device \"nosuch\""});
    const std::string name = usableDevice()["name"].asString();
    const Outcome outcome = run(smallRender() + Arguments{"--device", name, "--json"}, here);
    expectDone(outcome);
    EXPECT_EQ(parsedJson(outcome.out)["device"], name);
}

}  // namespace
}  // namespace fringe::cli
