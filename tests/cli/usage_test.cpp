// The command line itself: help, version, and what is said to a wrong use of it.
#include <regex>

#include "cli/support.hpp"

namespace fringe::cli {
namespace {

TEST(Usage, VersionSaysWhatWasBuiltFromWhat) {
    const Outcome outcome = run({"--version"});
    expectDone(outcome);
    const std::regex expected(
        "fringe \\d+\\.\\d+\\.\\d+ \\(commit ([0-9a-f]{12}|unknown)\\)\n"
        "compiler \\S+ \\d\\S*\n"
        "Vulkan headers \\d+\\.\\d+\\.\\d+\n");
    EXPECT_TRUE(std::regex_match(outcome.out, expected)) << outcome.out;
}

TEST(Usage, HelpListsTheSubCommandsAndTheirOptions) {
    const Outcome all = run({"--help"});
    expectDone(all);
    for (const char* command : {"render", "validate", "info", "devices", "compare"}) {
        EXPECT_TRUE(contains(all.out, command)) << command;
        const Outcome one = run({command, "--help"});
        expectDone(one);
        EXPECT_TRUE(contains(one.out, std::string("fringe ") + command)) << one.out;
    }
}

struct WrongUse {
    Arguments arguments;
    std::string said;
};

TEST(Usage, WhatIsWrongIsNamed) {
    const std::vector<WrongUse> cases{
        {{}, "no sub-command"},
        {{"rendr"}, "rendr"},
        {{"render"}, "SCENE is required"},
        {{"render", roomFile(), "--bogus"}, "--bogus"},
        {{"render", roomFile(), "--png-bits", "12"}, "12 not in {8,16}"},
        {{"render", roomFile(), "--exr-type", "double"}, "double not in {half,float}"},
        {{"render", roomFile(), "--tile", "0"}, "--tile: Value 0 not in range 1 to 65536"},
        {{"render", roomFile(), "--tile", "-8"}, "--tile: Value -8 not in range 1 to 65536"},
        {{"render", roomFile(), "--tile"}, "--tile"},
        {{"render", roomFile(), "-o"}, "--output"},
        {{"render", roomFile(), roomFile()}, roomFile()},
        {{"compare", "a.png"}, "B is required"},
        {{"compare", "a.png", "b.png", "--tolerance", "-1"}, "--tolerance"},
        {{"compare", "a.png", "b.png", "--allow", "2"}, "--allow"},
        {{"info"}, "SCENE is required"},
        {{"validate"}, "SCENE is required"},
    };
    const TestFolder folder;
    for (const WrongUse& wrong : cases) {
        SCOPED_TRACE(testing::PrintToString(wrong.arguments));
        expectRefused(run(wrong.arguments, {.folder = folder.path()}), 1, {wrong.said});
    }
    EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(Usage, ResultsThatCannotBePrintedAreAnError) {
    const Outcome outcome = run({"info", roomFile(), "--json"}, {.output = "/dev/full"});
    expectRefused(outcome, 2, {"standard output", "No space left on device"});
}

}  // namespace
}  // namespace fringe::cli
