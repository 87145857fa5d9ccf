// Scene files as the commands meet them: validate, info, and the refusals of render.
#include <regex>
#include <sstream>

#include "cli/support.hpp"

namespace fringe::cli {
namespace {

const std::string kThesisScenes = FRINGE_SOURCE_DIR "/scenes/thesis/";

// Four problems; the line of each follows below.
constexpr const char* kBadScene = R"({
  "fringe": 1,
  "image": { "widht": 600 },
  "camera": { "position": [0, 0, 3], "target": [0, 0, 0] },
  "materials": { "white": { "type": "diffuse", "reflectance": 1.5 } },
  "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": -1, "material": "whit" } ]
}
)";
const std::vector<std::string> kBadLines{"3", "5", "6", "6"};

class SceneFiles : public testing::Test {
protected:
    SceneFiles() { putBytes(folder_ / "bad.json", kBadScene); }

    Outcome runHere(const Arguments& arguments) { return run(arguments, {.folder = folder_.path()}); }

    TestFolder folder_;
};

// Every line of `text` is a problem of bad.json with its place; the numbers of the lines.
std::vector<std::string> linesOfProblems(const std::string& text) {
    const std::regex problem(R"(bad\.json:(\d+):\d+: .+)");
    std::vector<std::string> lines;
    std::istringstream all(text);
    for (std::string line; std::getline(all, line);) {
        std::smatch match;
        EXPECT_TRUE(std::regex_match(line, match, problem)) << line;
        lines.push_back(match[1]);
    }
    return lines;
}

TEST_F(SceneFiles, ValidateSaysThatAFileIsValid) {
    const Outcome outcome = runHere({"validate", roomFile()});
    expectDone(outcome);
    EXPECT_EQ(outcome.out, roomFile() + ": valid\n");
}

// A hexagon of 10 mm half a metre from a wall: Fresnel number 25e-6 / (550e-9 0.5) = 90.9.
constexpr const char* kNearScene = R"({
  "fringe": 1,
  "camera": { "position": [0, 0, 3], "target": [0, 0, 0] },
  "materials": { "white": { "type": "diffuse", "reflectance": 0.8 } },
  "objects": [{ "type": "plane", "point": [0, 0, -0.5], "normal": [0, 0, 1], "material": "white" }],
  "lights": [{ "name": "hexagon", "type": "grating", "position": [0, 0, 0], "normal": [0, 0, -1],
    "slit_direction": [0, 1, 0], "aperture": { "type": "polygon", "sides": 6, "diameter": "10 mm" },
    "beam": { "power": "1 mW", "profile": "gaussian", "diameter": "5 mm" } }]
}
)";

TEST_F(SceneFiles, WarnWhereTheRendererShowsThemWrongly) {
    putBytes(folder_ / "near.json", kNearScene);
    const Outcome outcome = runHere({"validate", "near.json"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "near.json: valid\n");
    EXPECT_TRUE(std::regex_search(
        outcome.err, std::regex(R"(near\.json: warning: hexagon: .*number is 90\.9 at 0\.5 m.*up to 40)")))
        << outcome.err;
    EXPECT_EQ(outcome.err.find('%'), std::string::npos) << outcome.err;  // its profile is no matter
    const Outcome json = runHere({"info", "--json", "near.json"});
    EXPECT_EQ(json.status, 0);
    EXPECT_EQ(json.err, "");
    EXPECT_NE(json.out.find("90.9 at 0.5 m"), std::string::npos);
    // In the beam's focus all is well, and so it is for a shape whose near field is known.
    EXPECT_EQ(runHere({"info", "near.json", "--set", "lights.hexagon.beam.focus=0.5 m"}).err, "");
    const auto warningOf = [&](const std::string& aperture) {
        const std::regex polygon(R"(\{ "type": "polygon".*\})");
        putBytes(folder_ / "other.json", std::regex_replace(std::string(kNearScene), polygon, aperture));
        return runHere({"validate", "other.json"}).err;
    };
    EXPECT_EQ(warningOf(R"({"type": "circle", "diameter": "1 mm"})"), "");
    EXPECT_EQ(warningOf(R"({"type": "polygon", "sides": 6, "diameter": "1 mm"})"), "");
    // Of a lattice's cells it is not.
    EXPECT_TRUE(std::regex_search(
        warningOf(
            R"({"type": "lattice", "cell": {"type": "circle", "diameter": "1 mm"}, "first": ["2 mm", "0 mm"],
                      "second": ["0 mm", "2 mm"], "first_count": 2, "second_count": 1})"),
        std::regex(R"(other\.json: warning: hexagon: the far field of each opening .*0\.91 at 0\.5 m)")));
    // More cells than the beam's profile is known across, which falls by 1 - exp(-2) to the rim.
    EXPECT_TRUE(std::regex_search(
        warningOf(
            R"({"type": "lattice", "cell": {"type": "circle", "diameter": "4 um"}, "first": ["5 um", "0 um"],
                      "second": ["0 um", "5 um"], "first_count": 1000, "second_count": 1})"),
        std::regex("other\\.json: warning: hexagon: the opening is lit evenly.*86 %")));
}

TEST_F(SceneFiles, ValidateListsEveryProblemOfEveryFile) {
    const Outcome outcome = runHere({"validate", "bad.json", roomFile(), "bad.json"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, roomFile() + ": valid\n");
    EXPECT_EQ(linesOfProblems(outcome.err), kBadLines + kBadLines);
}

TEST_F(SceneFiles, ValidateGoesOnAfterAMissingFile) {
    const Outcome outcome = runHere({"validate", "nosuch.json", roomFile()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "fringe: nosuch.json: cannot be read: No such file or directory\n");
    EXPECT_EQ(outcome.out, roomFile() + ": valid\n");
}

TEST_F(SceneFiles, ValidateTellsProgramsTheSame) {
    const Outcome outcome = runHere({"validate", "--json", "bad.json", roomFile()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "");
    const Json::Value files = parsedJson(outcome.out);
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[0]["file"], "bad.json");
    ASSERT_EQ(files[0]["problems"].size(), kBadLines.size());
    EXPECT_EQ(files[0]["problems"][0]["place"], "bad.json:3:14");
    EXPECT_TRUE(contains(files[0]["problems"][0]["message"].asString(), "\"width\""));
    EXPECT_EQ(files[1]["problems"].size(), 0U);
}

TEST_F(SceneFiles, RenderRefusesABadSceneWithEveryProblem) {
    const Outcome outcome = runHere({"render", "bad.json", "--reference"});
    expectRefused(outcome, 1, {});
    EXPECT_EQ(linesOfProblems(outcome.err), kBadLines);
    EXPECT_EQ(folder_.fileCount(), 1U) << "bad.json itself";
}

TEST_F(SceneFiles, RenderRefusesWhatIsNoSceneFile) {
    expectRefused(runHere({"render", "nosuch.json"}), 1, {"nosuch.json", "No such file or directory"});
    expectRefused(runHere({"render", "/tmp"}), 1, {"/tmp", "folder"});
    putBytes(folder_ / "empty.json", "");
    expectRefused(runHere({"render", "empty.json"}), 1, {"empty.json:1:1: "});
    EXPECT_EQ(folder_.fileCount(), 2U) << "the two scenes";
}

TEST_F(SceneFiles, SetOverridesValues) {
    const Outcome outcome = runHere(
        {"info", roomFile(), "--json", "--set", "image.width=320", "--set", "lights.lamp.power=2.5 W"});
    expectDone(outcome);
    const Json::Value info = parsedJson(outcome.out);
    EXPECT_EQ(info["image"]["width"], 320);
    EXPECT_EQ(info["image"]["height"], 130);
    EXPECT_EQ(info["lights"][0]["power_W"], 2.5);
}

TEST_F(SceneFiles, SetRefusesWhatItDoesNotUnderstand) {
    const auto set = [&](const std::string& text) { return runHere({"info", roomFile(), "--set", text}); };
    expectRefused(set("image.widht=32"), 1, {"--set image.widht=32: ", "\"width\""});
    expectRefused(set("image.width"), 1, {"--set image.width: ", "PATH=VALUE"});
    expectRefused(set("image.width=-3"), 1, {"--set image.width=-3: ", "from 1 to 65536"});
    expectRefused(set("lights.lmap.power=5 W"), 1, {"--set lights.lmap.power=5 W: ", "lmap"});
    expectRefused(set("lights.lamp.power=5"), 1, {"--set lights.lamp.power=5: ", " W"});
}

TEST(Info, SaysWhatASceneContains) {
    const Outcome outcome = run({"info", kThesisScenes + "figure-24.json", "--json"});
    expectDone(outcome);
    const Json::Value info = parsedJson(outcome.out);
    EXPECT_TRUE(contains(info["description"].asString(), "Five gratings"));
    EXPECT_EQ(info["image"]["width"], 600);
    EXPECT_EQ(info["objects"]["rectangle"], 5);
    EXPECT_EQ(info["materials"], 3);
    ASSERT_EQ(info["lights"].size(), 6U);
    EXPECT_EQ(info["lights"][0]["name"], "lamp");
    EXPECT_EQ(info["lights"][0]["power_W"], 4.0);
    EXPECT_EQ(info["lights"][5]["type"], "grating");
    EXPECT_GT(info["device_bytes"]["scene"].asUInt64(), 0U);
    EXPECT_EQ(info["device_bytes"]["whole_film"], 600 * 600 * 16) << "three floats and a word a pixel";
}

TEST(Info, CompilesInOnlyWhatASceneHas) {
    const Json::Value gratings =
        parsedJson(run({"info", kThesisScenes + "figure-24.json", "--json"}).out)["specialisation"];
    EXPECT_EQ(gratings["GRATING_COUNT"], 5);
    EXPECT_EQ(gratings["HAS_CONDUCTORS"], 0);
    EXPECT_EQ(gratings["HAS_DIELECTRICS"], 0);
    EXPECT_EQ(gratings["HAS_THESIS_DISCS"], 0);

    const Json::Value disc =
        parsedJson(run({"info", kThesisScenes + "figure-25.json", "--json"}).out)["specialisation"];
    EXPECT_EQ(disc["GRATING_COUNT"], 0);
    EXPECT_EQ(disc["HAS_THESIS_DISCS"], 1);

    const Json::Value room = parsedJson(run({"info", roomFile(), "--json"}).out)["specialisation"];
    EXPECT_EQ(room["HAS_CONDUCTORS"], 1);
    EXPECT_EQ(room["HAS_DIELECTRICS"], 1);
    EXPECT_EQ(room["HAS_LENS"], 1);
}

TEST(Info, SaysItToPeopleToo) {
    const Outcome outcome = run({"info", kThesisScenes + "figure-24.json"});
    expectDone(outcome);
    for (const char* part : {"Figure 24", "600 x 600", "5 rectangle", "lamp: 4 W", "GRATING_COUNT=5"}) {
        EXPECT_TRUE(contains(outcome.out, part)) << part;
    }
    EXPECT_FALSE(contains(outcome.out, "HAS_CONDUCTORS")) << "the scene has no mirror";
}

}  // namespace
}  // namespace fringe::cli
