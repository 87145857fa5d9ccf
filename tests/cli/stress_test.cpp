// fringe stress as a user sees it.
#include "cli/support.hpp"

namespace fringe::cli {
namespace {

TEST(StressOnDevice, SaysWhatHolds) {
    const Outcome outcome = run({"stress", "--case", "slits", "--case", "sphere", "--count", "10000"});
    expectDone(outcome);
    for (const char* word : {"seed 1", "slits", "sphere", "holds", "worst", "0 of 2 bounds broken"})
        EXPECT_TRUE(contains(outcome.out, word)) << outcome.out << word;
}

TEST(StressOnDevice, JsonHoldsTheWorstInput) {
    const Outcome outcome = run({"stress", "--case", "slits", "--count", "10000", "--seed", "7", "--json"});
    expectDone(outcome);
    const Json::Value report = parsedJson(outcome.out);
    EXPECT_EQ(report["seed"].asUInt(), 7U);
    EXPECT_TRUE(report["passed"].asBool());
    const Json::Value& slits = report["cases"][0];
    EXPECT_EQ(slits["count"].asUInt(), 10'000U);
    EXPECT_EQ(slits["non_finite"].asUInt(), 0U);
    EXPECT_GT(slits["error"]["largest"].asDouble(), 0.0);
    EXPECT_LE(slits["error"]["largest"].asDouble(), slits["bound"].asDouble());
    for (const char* input : {"u", "width", "period", "period_low", "count"})
        EXPECT_TRUE(slits["worst"]["inputs"].isMember(input)) << input;
}

TEST(StressOnDevice, ABrokenBoundIsStatusThree) {
    const Outcome outcome = run({"stress", "--case", "slits", "--count", "10000", "--bound", "1e-12"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(contains(outcome.out, "BROKEN")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "1 of 1 bounds broken")) << outcome.out;
}

TEST(Stress, WrongOptionsAreNamed) {
    expectRefused(run({"stress", "--case", "slit", "--case", "slots"}), 1,
                  {"no case \"slots\"", "slits", "sphere"});
    expectRefused(run({"stress", "--count", "0"}), 1, {"--count"});
    expectRefused(run({"stress", "--full", "--count", "5"}), 1, {"--full", "--count"});
}

}  // namespace
}  // namespace fringe::cli
