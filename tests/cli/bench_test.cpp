// fringe bench as a user sees it. Nothing here depends on how fast a machine is.
#include <algorithm>
#include <csignal>

#include "cli/support.hpp"

namespace fringe::cli {
namespace {

const Arguments kQuick{"bench", "--case", "model", "--rounds", "1"};

TEST(BenchOnDevice, MeasuresAndWritesReports) {
    const TestFolder folder;
    const Outcome outcome =
        run(kQuick + Arguments{"-o", "a.json", "-o", "a.csv", "-o", "a.svg", "-o", "a.png"},
            {.folder = folder.path()});
    expectDone(outcome);
    for (const char* word : {"ms a frame", "thesis", "physical, D65", "the host's steady clock"})
        EXPECT_TRUE(contains(outcome.out, word)) << outcome.out << word;
    EXPECT_EQ(folder.fileCount(), 4U);

    const Json::Value report = parsedJson(bytesOf(folder / "a.json"));
    for (const char* key : {"device", "driver", "version", "clock"})
        EXPECT_FALSE(report[key].asString().empty()) << key;
    EXPECT_EQ(report["options"]["rounds"].asInt(), 1);
    ASSERT_EQ(report["rows"].size(), 2U);
    for (const Json::Value& row : report["rows"]) {
        EXPECT_EQ(row["group"].asString(), "frames");
        EXPECT_TRUE(row["verified"].asBool());
        EXPECT_GT(row["time_ms"]["median"].asDouble(), 0.0);
        EXPECT_GT(row["error"]["rms"].asDouble(), 0.0);
        EXPECT_LT(row["error"]["rms"].asDouble(), 0.05);
    }
    EXPECT_EQ(report["rows"][0]["ratio"]["median"].asDouble(), 1.0);
    const std::string csv = bytesOf(folder / "a.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
    EXPECT_TRUE(contains(csv, "time_ms.median")) << csv;
    EXPECT_TRUE(contains(csv, "\"physical, D65\"")) << csv;
}

// With an old report in which one row was a thousand times faster and closer, the other as much slower and
// further off.
TEST(BenchOnDevice, ComparesWithAnOldReport) {
    const TestFolder folder;
    expectDone(run(kQuick + Arguments{"-o", "now.json"}, {.folder = folder.path()}));
    Json::Value old = parsedJson(bytesOf(folder / "now.json"));
    const auto scale = [](Json::Value& row, double factor) {
        row["time_ms"]["median"] = factor * row["time_ms"]["median"].asDouble();
        row["error"]["rms"] = factor * row["error"]["rms"].asDouble();
    };
    scale(old["rows"][0], 1e3);
    scale(old["rows"][1], 1e-3);
    putBytes(folder / "old.json", Json::writeString(Json::StreamWriterBuilder(), old));

    const Outcome outcome =
        run(kQuick + Arguments{"--compare", "old.json", "--check", "--json"}, {.folder = folder.path()});
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    const Json::Value changes = parsedJson(outcome.out)["changes"];
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_FALSE(changes[0]["slower"].asBool() || changes[0]["less_exact"].asBool());
    EXPECT_NEAR(changes[0]["error_ratio"].asDouble(), 1e-3, 1e-6);
    EXPECT_TRUE(changes[1]["slower"].asBool() && changes[1]["less_exact"].asBool());
    EXPECT_NEAR(changes[1]["error_ratio"].asDouble(), 1e3, 1.0);
}

TEST(BenchOnDevice, ShowsWhatAFeatureCosts) {
    const Outcome outcome = run({"bench", "--case", "spheres", "--skip", "--rounds", "1", "--json"});
    expectDone(outcome);
    const Json::Value report = parsedJson(outcome.out);
    ASSERT_EQ(report["rows"].size(), 4U);  // and the smallest shader, the room, and the room with shadows
    const Json::Value& smallest = report["rows"][0];
    const Json::Value& spheres = report["rows"][3];
    EXPECT_EQ(spheres["setting"].asString(), "against shadows");
    EXPECT_GT(spheres["compile_ratio"]["median"].asDouble(), 0.0);
    EXPECT_GT(spheres["spirv_bytes"]["left"].asUInt(), report["rows"][2]["spirv_bytes"]["left"].asUInt());
    EXPECT_GT(report["rows"][1]["spirv_bytes"]["left"].asUInt(), smallest["spirv_bytes"]["left"].asUInt());
    for (const Json::Value& row : report["rows"]) EXPECT_TRUE(row["verified"].asBool());
}

TEST(BenchOnDevice, SetsEvaluatorsAgainstEachOther) {
    const TestFolder folder;
    const Outcome outcome = run(
        {"bench", "--case", "1 slit of 1 um, D65", "--rounds", "1", "--check", "-o", "a.json", "-o", "a.svg"},
        {.folder = folder.path()});
    expectDone(outcome);
    const Json::Value rows = parsedJson(bytesOf(folder / "a.json"))["rows"];
    const auto row = [&](const std::string& evaluator, const std::string& setting) {
        const auto found = std::find_if(rows.begin(), rows.end(), [&](const Json::Value& candidate) {
            return candidate["evaluator"] == evaluator && candidate["setting"] == setting;
        });
        return found == rows.end() ? Json::Value() : *found;
    };
    EXPECT_LE(row("auto", "")["error"]["largest"].asDouble(), 1e-3);
    EXPECT_EQ(row("auto", "")["ratio"]["median"].asDouble(), 1.0);
    const Json::Value few = row("direct", "3 wavelengths"), many = row("direct", "401 wavelengths");
    EXPECT_GT(few["error"]["rms"].asDouble(), 100.0 * many["error"]["rms"].asDouble());
    EXPECT_GT(few["time_ms"]["median"].asDouble(), 0.0);
    EXPECT_GT(row("processor", "81 wavelengths, 2 threads")["time_ms"]["median"].asDouble(), 0.0);
    EXPECT_FALSE(row("direct", "81 wavelengths, rounding alone").isMember("time_ms"));
    EXPECT_TRUE(contains(bytesOf(folder / "a.svg"), "<svg"));
}

TEST(BenchOnDevice, CtrlCKeepsWhatIsDone) {
    const TestFolder folder;
    Program program({"bench", "--case", "tile", "--rounds", "1000", "-o", "a.json"},
                    {.folder = folder.path(), .terminal = true});
    EXPECT_TRUE(program.says(" left"));
    program.signal(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 130);
    EXPECT_TRUE(contains(outcome.err, "interrupted")) << outcome.err;
    EXPECT_EQ(parsedJson(bytesOf(folder / "a.json"))["rows"].size(), 0U);
}

TEST(Bench, WrongOptionsAreNamed) {
    const TestFolder folder;
    putBytes(folder / "no.json", "{\"rows\": 3}");
    putBytes(folder / "odd.json",
             R"({"device": "x", "rows": [{"group": "frames", "case": "tile", "setting": "64",
                                       "error": {"rms": 0}, "time_ms": 7}]})");
    const Surroundings here{.folder = folder.path()};
    expectRefused(run({"bench", "--case", "modle"}, here), 1,
                  {"no case \"modle\"", "samples", "hidden-gratings", "mirrors"});
    expectRefused(run({"bench", "--skip", "--case", "tile"}, here), 1, {"no case \"tile\"", "mirrors"});
    expectRefused(run({"bench", "-o", "a.txt"}, here), 1, {"a.txt", ".json"});
    expectRefused(run({"bench", "-o", "missing/a.json"}, here), 1, {"missing"});
    expectRefused(run({"bench", "--rounds", "0"}, here), 1, {"--rounds"});
    expectRefused(run({"bench", "--compare", "old.json"}, here), 1, {"old.json"});
    expectRefused(run({"bench", "--compare", "no.json"}, here), 1, {"no.json", "no report of fringe bench"});
    expectRefused(run({"bench", "--compare", "odd.json"}, here), 1,
                  {"odd.json", "no report of fringe bench"});
    expectRefused(run({"bench", "--allow", "2"}, here), 1, {"--compare"});
    EXPECT_EQ(folder.fileCount(), 2U);
}

}  // namespace
}  // namespace fringe::cli
