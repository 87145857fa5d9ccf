// Long renders: progress on a terminal, and Ctrl-C or SIGTERM at any moment, on the device and on the
// reference.
#include <algorithm>
#include <csignal>
#include <regex>

#include "cli/support.hpp"
#include "image/reader.hpp"

namespace fringe::cli {
namespace {

using namespace std::chrono_literals;

// A render that no machine ends while the tests look, at 65535 samples a pixel, yet has complete rows within
// a second or two.
struct LongRender {
    const char* name;
    Arguments arguments;
    std::uint32_t width, height;
};

void PrintTo(const LongRender& render, std::ostream* out) {
    *out << render.name;  // instead of its bytes, which would make the name of the test another in each run
}

const LongRender kReference{
    .name = "Reference",
    .arguments =
        Arguments{"render", roomFile(), "--reference", "--set", "image.samples=65535"} + sized(4, 4000),
    .width = 4,
    .height = 4000};

// More pixels than the device's film has (64 MiB): the lower rows are not begun while the upper ones are
// sampled. No wider than a tile, so that the first dispatch gives whole rows on the slowest of drivers.
const LongRender kDevice{
    .name = "OnDevice",
    .arguments = Arguments{"render", roomFile(), "--set", "image.samples=65535"} + sized(640, 7000),
    .width = 640,
    .height = 7000};

class Interrupted : public testing::TestWithParam<LongRender> {
protected:
    // Starts it, and sends the signal once the terminal has shown progress.
    Outcome interrupt(int signal, const Arguments& arguments) {
        Program program(GetParam().arguments + arguments, {.folder = folder_.path(), .terminal = true});
        EXPECT_TRUE(program.says(" left"));
        program.signal(signal);
        return program.wait();
    }

    TestFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(By, Interrupted, testing::Values(kReference, kDevice),
                         [](const auto& test) { return std::string(test.param.name); });

constexpr Seconds kSoon = 1s;  // promised: "stops within a second"

TEST_P(Interrupted, CtrlCStopsSoonAndLeavesNothing) {
    putBytes(folder_ / "a.png", "old");
    const Outcome outcome = interrupt(SIGINT, {"-o", "a.png", "-o", "a.exr"});
    EXPECT_EQ(outcome.status, 130);
    EXPECT_LT(outcome.runTime, kSoon);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(contains(outcome.err, "\r\x1b[Kfringe: interrupted; nothing was written")) << outcome.err;
    EXPECT_EQ(bytesOf(folder_ / "a.png"), "old");
    EXPECT_EQ(folder_.fileCount(), 1U);
}

TEST_P(Interrupted, KeepPartialWritesWhatIsDone) {
    const Outcome outcome = interrupt(SIGINT, {"--keep-partial", "-o", "a.png", "-o", "a.exr"});
    EXPECT_EQ(outcome.status, 130);
    EXPECT_TRUE(contains(outcome.err, "what was done is in a.png, a.exr")) << outcome.err;
    EXPECT_EQ(folder_.fileCount(), 2U);
    const auto lit = [](const image::RgbPixel& p) { return p.r > 0.0F || p.g > 0.0F || p.b > 0.0F; };
    for (const char* name : {"a.png", "a.exr"}) {
        const image::Picture picture = image::readImage(folder_ / name);
        ASSERT_EQ(picture.width, GetParam().width);
        ASSERT_EQ(picture.height, GetParam().height);
        EXPECT_TRUE(std::all_of(picture.pixels.begin(), picture.pixels.begin() + picture.width, lit)) << name;
        EXPECT_TRUE(std::none_of(picture.pixels.end() - picture.width, picture.pixels.end(), lit)) << name;
    }
}

// Also: without a terminal there is no progress, however long it takes.
TEST_P(Interrupted, TerminationStopsSoonAndLeavesNothing) {
    Program program(GetParam().arguments, {.folder = folder_.path()});
    ASSERT_TRUE(program.runsFor(2s)) << "ended by itself: " << program.wait().err;
    program.signal(SIGTERM);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 143);
    EXPECT_LT(outcome.runTime, kSoon);
    EXPECT_EQ(outcome.err, "fringe: interrupted; nothing was written (--keep-partial writes what is done)\n");
    EXPECT_EQ(folder_.fileCount(), 0U);
}

TEST_P(Interrupted, QuietHasNoProgress) {
    Program program(GetParam().arguments + Arguments{"--quiet"},
                    {.folder = folder_.path(), .terminal = true});
    ASSERT_TRUE(program.runsFor(2s)) << "ended by itself: " << program.wait().err;
    program.signal(SIGINT);
    EXPECT_TRUE(program.wait().err.starts_with("fringe: interrupted"));
}

TEST(Progress, IsAPercentageAndTheTimeLeftAfterASecond) {
    const TestFolder folder;
    const auto start = std::chrono::steady_clock::now();
    Program program(kReference.arguments, {.folder = folder.path(), .terminal = true});
    ASSERT_TRUE(program.says(" left"));
    EXPECT_GE(std::chrono::steady_clock::now() - start, 1s) << "a render over by then shows none";
    program.signal(SIGINT);
    const std::string shown = program.wait().err;
    EXPECT_TRUE(std::regex_search(shown, std::regex("^\r\x1b\\[K +\\d+ %  (\\d+:)?\\d+:\\d\\d left")))
        << shown;
}

TEST(Progress, AShortRenderHasNone) {
    const TestFolder folder;
    const Outcome outcome = run(smallReferenceRender(), {.folder = folder.path(), .terminal = true});
    expectDone(outcome);
    EXPECT_TRUE(contains(outcome.out, "room.png")) << outcome.out;
}

}  // namespace
}  // namespace fringe::cli
