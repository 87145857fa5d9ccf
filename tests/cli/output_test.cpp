// The files of a render: formats, names, metadata, and what becomes of them when they cannot be written; and
// what the program prints about them.
#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <regex>

#include "cli/support.hpp"
#include "image/reader.hpp"

namespace fringe::cli {
namespace {

class Output : public testing::Test {
protected:
    Outcome render(const Arguments& arguments) { return runHere(smallReferenceRender() + arguments); }
    Outcome runHere(const Arguments& arguments) { return run(arguments, {.folder = folder_.path()}); }

    TestFolder folder_;
};

using OutputOnDevice = Output;

// Byte 24 of a PNG file, in its IHDR chunk, is the depth.
int pngBits(const std::filesystem::path& path) {
    return bytesOf(path).at(24);
}

// True if all values have no more digits than a half: 10 of the 23 bits of the fraction. Smaller ones than
// 2^-14 have fewer still.
bool fitsHalf(const image::Image& picture) {
    const auto fits = [](float value) { return (std::bit_cast<std::uint32_t>(value) & 0x1FFFU) == 0; };
    return std::all_of(picture.pixels.begin(), picture.pixels.end(),
                       [&](const image::Pixel& p) { return fits(p.r) && fits(p.g) && fits(p.b); });
}

std::string valueOf(const image::Metadata& metadata, const std::string& key) {
    for (const auto& [name, value] : metadata) {
        if (name == key) return value;
    }
    ADD_FAILURE() << "no metadata \"" << key << "\"";
    return {};
}

// ---- formats and names ----------------------------------------------------------------------------

TEST_F(OutputOnDevice, OneRunWritesBothFormats) {
    const Outcome outcome = runHere(smallRender() + Arguments{"-o", "a.png", "-o", "a.exr"});
    expectDone(outcome);
    EXPECT_EQ(folder_.fileCount(), 2U);
    for (const char* name : {"a.png", "a.exr"}) {
        const image::Image picture = image::readImage(folder_ / name);
        EXPECT_EQ(picture.width, 40U);
        EXPECT_EQ(picture.height, 30U);
    }
}

TEST_F(Output, PngHas8BitsOr16) {
    expectDone(render({"-o", "default.png"}));
    expectDone(render({"-o", "8.png", "--png-bits", "8"}));
    expectDone(render({"-o", "16.png", "--png-bits", "16"}));
    EXPECT_EQ(pngBits(folder_ / "default.png"), 8);
    EXPECT_EQ(pngBits(folder_ / "8.png"), 8);
    EXPECT_EQ(pngBits(folder_ / "16.png"), 16);
}

TEST_F(Output, ExrHasHalfOrFloat) {
    expectDone(render({"-o", "default.exr"}));
    expectDone(render({"-o", "half.exr", "--exr-type", "half"}));
    expectDone(render({"-o", "float.exr", "--exr-type", "float"}));
    EXPECT_TRUE(fitsHalf(image::readImage(folder_ / "default.exr")));
    EXPECT_TRUE(fitsHalf(image::readImage(folder_ / "half.exr")));
    EXPECT_FALSE(fitsHalf(image::readImage(folder_ / "float.exr")));
}

TEST_F(Output, TheDefaultNameIsTheScenesInTheCurrentFolder) {
    expectDone(render({}));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "room.png"));
}

TEST_F(Output, ARelativePathStartsAtTheCurrentFolder) {
    std::filesystem::create_directory(folder_ / "pictures");
    expectDone(render({"-o", "pictures/a.png"}));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "pictures/a.png"));
    EXPECT_EQ(folder_.fileCount(), 1U);
}

TEST_F(OutputOnDevice, MetadataSaysHowToMakeThePictureAgain) {
    expectDone(runHere(smallRender() + Arguments{"--set", "image.seed=7", "-o", "a.png", "-o", "a.exr"}));
    for (const char* name : {"a.png", "a.exr"}) {
        SCOPED_TRACE(name);
        const image::Metadata metadata = image::readMetadata(folder_ / name);
        EXPECT_TRUE(std::regex_match(valueOf(metadata, "Software"),
                                     std::regex(R"(fringe \d+\.\d+\.\d+ \(([0-9a-f]{12}|unknown)\))")));
        EXPECT_TRUE(std::regex_match(valueOf(metadata, "Creation Time"),
                                     std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
        EXPECT_EQ(valueOf(metadata, "fringe scene file"), roomFile());
        EXPECT_EQ(valueOf(metadata, "fringe scene"), bytesOf(roomFile()));
        EXPECT_NE(valueOf(metadata, "fringe device"), "");
        EXPECT_NE(valueOf(metadata, "fringe driver"), "");
        EXPECT_EQ(valueOf(metadata, "fringe options"),
                  "40x30, 1 samples, seed 7, max_depth 8, exposure 0, --set image.width=40, "
                  "--set image.height=30, --set image.seed=7");
    }
}

// ---- what is printed ------------------------------------------------------------------------------

TEST_F(OutputOnDevice, SummaryIsOneLine) {
    const Outcome outcome = runHere(smallRender() + Arguments{"-o", "a.png", "-o", "b.exr"});
    expectDone(outcome);
    const std::regex summary(
        R"(a\.png, b\.exr: 40 x 30, 1 sample\(s\), \d+\.\d+ s \(\d+\.\d ms rendering\) on .+\n)");
    EXPECT_TRUE(std::regex_match(outcome.out, summary)) << outcome.out;
}

TEST_F(Output, QuietPrintsNothing) {
    const Outcome outcome = render({"--quiet"});
    expectDone(outcome);
    EXPECT_EQ(outcome.out, "");
}

TEST_F(OutputOnDevice, StatsAndJsonHoldTheClocks) {
    const Outcome outcome =
        runHere(smallRender() + Arguments{"-o", "a.png", "--json", "--stats", "stats.json"});
    expectDone(outcome);
    for (const Json::Value& stats : {parsedJson(outcome.out), parsedJson(bytesOf(folder_ / "stats.json"))}) {
        EXPECT_EQ(stats["scene"], roomFile());
        EXPECT_EQ(stats["outputs"][0], "a.png");
        EXPECT_EQ(stats["width"], 40);
        EXPECT_EQ(stats["height"], 30);
        EXPECT_EQ(stats["samples"], 1);
        EXPECT_NE(stats["device"], "");
        EXPECT_NE(stats["driver"], "");
        EXPECT_GE(stats["dispatches"].asUInt64(), 1U);
        EXPECT_GT(stats["peak_rss_mib"].asDouble(), 0.0);
        double sum = 0.0;
        for (const char* clock :
             {"parse", "start_up", "compile", "upload", "dispatch", "readback", "write"}) {
            EXPECT_GT(stats["clocks_ms"][clock].asDouble(), 0.0) << clock;
            sum += stats["clocks_ms"][clock].asDouble();
        }
        EXPECT_LE(sum, stats["clocks_ms"]["total"].asDouble()) << "the clocks run one after the other";
    }
}

TEST_F(Output, StatsThatCannotBeWrittenAreAnError) {
    const Outcome outcome = render({"-o", "a.png", "--stats", "nosuch/stats.json"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(contains(outcome.err, "nosuch/stats.json: ")) << outcome.err;
}

// ---- what cannot be written -----------------------------------------------------------------------

// Each also beside a good output, which must not appear alone.
TEST_F(Output, AWrongPathIsRefusedBeforeTheWork) {
    std::filesystem::create_directory(folder_ / "folder.png");
    struct Wrong {
        std::string path, reason;
    };
    for (const auto& [path, reason] :
         {Wrong{"nosuch/a.png", "No such file or directory"}, Wrong{"a.jpg", ".png or .exr"},
          Wrong{"a", ".png or .exr"}, Wrong{"folder.png", "is a folder"}}) {
        expectRefused(render({"-o", path}), 1, {path + ": ", reason});
        expectRefused(render({"-o", "good.png", "-o", path}), 1, {path + ": ", reason});
    }
    EXPECT_EQ(folder_.fileCount(), 1U) << "folder.png itself";
}

TEST_F(Output, AFolderWithoutPermissionIsRefused) {
    std::filesystem::create_directory(folder_ / "locked");
    ASSERT_EQ(::chmod((folder_ / "locked").c_str(), 0555), 0);
    expectRefused(render({"-o", "locked/a.exr"}), 1, {"locked/a.exr: ", "Permission denied"});
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / "locked"));
}

TEST_F(Output, AFullDiskIsTheMachinesFaultAndLeavesNothing) {
    putBytes(folder_ / "a.exr", "old");
    const Surroundings full{.folder = folder_.path(), .largestFile = 1000};
    const Outcome outcome = run(smallReferenceRender() + Arguments{"-o", "a.exr", "-o", "b.png"}, full);
    expectRefused(outcome, 2, {"fringe: a.exr: ", "fringe: b.png: ", "File too large"});
    EXPECT_EQ(bytesOf(folder_ / "a.exr"), "old");
    EXPECT_EQ(folder_.fileCount(), 1U);
}

TEST_F(Output, TheFailureOfOneFileDoesNotLoseTheOther) {
    // Between the sizes of the two: 40 x 30 pixels of 3 bytes and of 3 floats, with the scene in both.
    expectDone(render({"-o", "a.png", "-o", "b.exr", "--exr-type", "float"}));
    const std::size_t limit =
        (std::filesystem::file_size(folder_ / "a.png") + std::filesystem::file_size(folder_ / "b.exr")) / 2;
    std::filesystem::remove(folder_ / "a.png");
    std::filesystem::remove(folder_ / "b.exr");

    const Surroundings full{.folder = folder_.path(), .largestFile = limit};
    const Outcome outcome =
        run(smallReferenceRender() + Arguments{"-o", "a.png", "-o", "b.exr", "--exr-type", "float"}, full);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(contains(outcome.err, "b.exr: ")) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("a.png: ")) << outcome.out;
    EXPECT_EQ(image::readImage(folder_ / "a.png").height, 30U);
    EXPECT_EQ(folder_.fileCount(), 1U);
}

}  // namespace
}  // namespace fringe::cli
