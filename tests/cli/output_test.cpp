// The files of a render: formats, names, metadata, and what becomes of them when they cannot be written; and
// what the program prints about them.
#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
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
bool fitsHalf(const image::Picture& picture) {
    const auto fits = [](float value) { return (std::bit_cast<std::uint32_t>(value) & 0x1FFFU) == 0; };
    return std::all_of(picture.pixels.begin(), picture.pixels.end(),
                       [&](const image::RgbPixel& p) { return fits(p.r) && fits(p.g) && fits(p.b); });
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
        const image::Picture picture = image::readImage(folder_ / name);
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

// ---- colour, exposure, quantity -------------------------------------------------------------------

bool samePixels(const image::Picture& a, const image::Picture& b) {
    return std::equal(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), b.pixels.end(),
                      [](const auto& p, const auto& q) { return p.r == q.r && p.g == q.g && p.b == q.b; });
}

TEST_F(Output, AutomaticExposureIsStatedAndGivesTheSamePictureByItsNumber) {
    const Outcome outcome = render({"--exposure", "auto", "-o", "auto.png", "-o", "auto.exr", "--json"});
    expectDone(outcome);
    const Json::Value json = parsedJson(outcome.out);
    EXPECT_EQ(json["auto_exposure"], true);
    const std::string text = valueOf(image::readMetadata(folder_ / "auto.png"), "fringe options");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, std::regex(R"(exposure (\S+) \(automatic\))"))) << text;
    const std::string stops = found[1];
    EXPECT_NE(std::stod(stops), 0.0);
    EXPECT_NEAR(json["exposure"].asDouble(), std::stod(stops), 1e-9);

    expectDone(render({"--exposure", stops, "-o", "given.png", "-o", "given.exr"}));
    for (const char* extension : {".png", ".exr"})
        EXPECT_TRUE(samePixels(image::readImage(folder_ / (std::string("auto") + extension)),
                               image::readImage(folder_ / (std::string("given") + extension))));
    EXPECT_EQ(folder_.fileCount(), 4U);
}

TEST_F(Output, CompensationIsAddedToTheAutomaticExposure) {
    const auto exposure = [&](const Arguments& arguments) {
        return parsedJson(render(Arguments{"--json"} + arguments).out)["exposure"].asDouble();
    };
    const double found = exposure({"--exposure", "auto"});
    EXPECT_NEAR(exposure({"--exposure", "auto+1.5"}), found + 1.5, 1e-9);
    EXPECT_NEAR(exposure({"--set", "image.exposure=3", "--exposure", "auto-1"}), found - 1.0, 1e-9)
        << "the command line's in place of the scene's";
}

TEST_F(Output, TheSummaryStatesAnAutomaticExposure) {
    EXPECT_TRUE(std::regex_search(render({"--exposure", "auto"}).out,
                                  std::regex(R"(, exposure [+-]\d+\.\d\d \(automatic\), )")));
    EXPECT_FALSE(contains(render({}).out, "exposure"));
}

TEST_F(Output, AnExposureThatIsNoneIsRefused) {
    for (const char* wrong : {"bright", "auto1", "auto++1", "65", "nan", "1stop"})
        expectRefused(render({"--exposure", wrong}), 1,
                      {std::string("--exposure ") + wrong + ": ", "auto-1.5"});
}

// The reader obeys the profile: the colours are the same, since none of the room's is outside sRGB by much.
TEST_F(Output, AWideColorSpaceKeepsTheColors) {
    expectDone(render({"-o", "a.png", "--png-bits", "16"}));
    expectDone(render({"-o", "p3.png", "--png-bits", "16", "--color-space", "display-p3"}));
    const std::string bytes = bytesOf(folder_ / "p3.png");
    EXPECT_TRUE(contains(bytes, "Display P3"));
    EXPECT_TRUE(contains(valueOf(image::readMetadata(folder_ / "p3.png"), "fringe options"),
                         ", color space display-p3"));
    EXPECT_EQ(run({"compare", "a.png", "p3.png", "--tolerance", "0.002", "--allow", "0.02"},
                  {.folder = folder_.path()})
                  .status,
              0);
}

TEST_F(Output, AToneCurveChangesThePngAndNotTheExr) {
    expectDone(render({"-o", "a.png", "-o", "a.exr"}));
    expectDone(render({"-o", "b.png", "-o", "b.exr", "--tone-curve", "filmic"}));
    EXPECT_TRUE(
        contains(valueOf(image::readMetadata(folder_ / "b.png"), "fringe options"), ", tone curve filmic"));
    const auto compared = [&](const char* a, const char* b) {
        return run({"compare", a, b, "--tolerance", "0.01"}, {.folder = folder_.path()}).status;
    };
    EXPECT_EQ(compared("a.exr", "b.exr"), 0);
    EXPECT_EQ(compared("a.png", "b.png"), 3);
    expectRefused(render({"--tone-curve", "s-shaped"}), 1, {"--tone-curve", "reinhard"});
}

TEST_F(Output, LuminanceIsWrittenAsExr) {
    expectDone(render({"--quantity", "luminance"}));
    const image::Picture luminance = image::readImage(folder_ / "room.exr");
    EXPECT_EQ(luminance.quantity, image::Quantity::luminance);
    EXPECT_EQ(valueOf(image::readMetadata(folder_ / "room.exr"), "unit"), "cd/m^2");
    EXPECT_FALSE(fitsHalf(luminance)) << "a measurement has all digits unless told otherwise";

    // D65 has 205 lm/W in the visible range. The Y of a colour is a float, as is the product.
    expectDone(render({"-o", "xyz.exr", "--exr-color", "xyz", "--exr-type", "float"}));
    const image::Picture color = image::readImage(folder_ / "xyz.exr");
    const auto weights = glm::transpose(image::xyzFromLinear(image::ColorSpace::srgb))[1];
    for (std::size_t i = 0; i < color.pixels.size(); ++i) {
        const image::RgbPixel& p = color.pixels[i];
        const double y = glm::dot(weights, glm::dvec3(p.r, p.g, p.b));
        EXPECT_NEAR(luminance.pixels[i].r / 205.15, y, 1e-3 * y + 1e-6) << i;
    }
}

TEST_F(Output, AQuantityIsNoPngAndTheReferenceHasTwo) {
    expectRefused(render({"--quantity", "luminance", "-o", "a.png"}), 1, {"a.png: ", "luminance", ".exr"});
    expectRefused(render({"--quantity", "radiance"}), 1, {"--quantity radiance", "color and luminance"});
    EXPECT_EQ(folder_.fileCount(), 0U);
}

TEST_F(OutputOnDevice, EveryQuantityHasItsChannel) {
    for (const char* quantity : {"color", "luminance", "radiance", "irradiance"}) {
        expectDone(runHere(smallRender() + Arguments{"--quantity", quantity, "-o", "a.exr"}));
        EXPECT_STREQ(image::nameOf(image::readImage(folder_ / "a.exr").quantity), quantity);
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
