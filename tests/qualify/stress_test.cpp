// The stress runs themselves: short ones of every function, and what is said of a function that is wrong.
#include "qualify/stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "qualify/cases.hpp"
#include "qualify/device.hpp"
#include "shaders/wrong_probe.comp.h"

namespace fringe::qualify {
namespace {

class StressOnDevice : public testing::Test {
protected:
    void TearDown() override {
        for (const std::string& message : device().validationMessages())
            ADD_FAILURE() << "validation: " << message;
    }
};

TEST(StressCases, HaveNamesOfTheirOwn) {
    std::set<std::string_view> names;
    for (const StressCase& stressCase : stressCases()) {
        EXPECT_TRUE(names.insert(stressCase.name).second) << stressCase.name;
        EXPECT_FALSE(stressCase.reason.empty()) << stressCase.name;
        // A hundred million, fewer where a quadrature judges.
        EXPECT_GE(stressCase.fullCount, 2'000'000U) << stressCase.name;
    }
}

// Two batches of each function.
TEST_F(StressOnDevice, EveryBoundHolds) {
    for (const StressCase& stressCase : stressCases()) {
        SCOPED_TRACE(stressCase.name);
        const StressReport report = stress(device(), stressCase, {.seed = 11, .count = 150'000});
        EXPECT_EQ(report.count, 150'000U);
        if (!stressCase.bound) continue;
        EXPECT_EQ(report.nonFinite, 0U);
        EXPECT_LE(report.largest, *stressCase.bound) << report.worst->number;
        EXPECT_LE(report.most, report.largest);
    }
}

// That the inputs are hard: the formula as printed fails at them, by more than its own peak and with 0/0.
TEST_F(StressOnDevice, TheFormulaAsPrintedFails) {
    for (const StressCase& stressCase : stressCases()) {
        if (stressCase.name != "slits-as-printed") continue;
        const StressReport report = stress(device(), stressCase, {.seed = 11, .count = 150'000});
        EXPECT_GT(report.nonFinite, 100U);
        EXPECT_GT(report.largest, 1.0);
        return;
    }
    FAIL() << "no such case";
}

void drawNumber(Draw& draw, std::span<float> inputs) {
    inputs[0] = static_cast<float>(draw.unit());
}
Judgement judgeDouble(std::span<const float> inputs, std::span<const float> results) {
    return compared(results[0], 2.0 * double{inputs[0]});
}
StressCase wrongCase(std::uint32_t variant) {
    return {"wrong", "of this test", 1e-3,        "none", wrong_probe_comp, variant, {"x"},
            1,       drawNumber,     judgeDouble, 1};
}

TEST_F(StressOnDevice, AnErrorIsFoundWithItsInput) {
    const StressReport report = stress(device(), wrongCase(0), {.seed = 5, .count = 10'000});
    EXPECT_EQ(report.count, 10'000U);
    EXPECT_EQ(report.nonFinite, 0U);
    EXPECT_NEAR(report.largest, 0.01, 1e-6);
    EXPECT_FALSE(report.keeps(1e-3));
    EXPECT_TRUE(report.keeps(0.02));
    ASSERT_TRUE(report.worst);
    EXPECT_EQ(report.worst->number % 1000, 999U);
    Draw again(5, report.worst->number);
    EXPECT_EQ(report.worst->inputs[0], static_cast<float>(again.unit()));
    // One in a thousand is wrong: just what the percentile leaves out.
    EXPECT_EQ(report.most, 0.0);
}

TEST_F(StressOnDevice, AResultThatIsNoNumberIsFoundWithItsInput) {
    const StressReport report = stress(device(), wrongCase(1), {.seed = 5, .count = 10'000});
    EXPECT_EQ(report.nonFinite, 10U);
    EXPECT_EQ(report.largest, 0.0);
    EXPECT_FALSE(report.keeps(1.0));
    ASSERT_TRUE(report.firstNonFinite);
    EXPECT_EQ(report.firstNonFinite->number, 999U);
}

TEST_F(StressOnDevice, TheSameSeedGivesTheSameReport) {
    const StressCase& slits = stressCases()[2];
    const StressReport one = stress(device(), slits, {.seed = 9, .count = 20'000});
    const StressReport same = stress(device(), slits, {.seed = 9, .count = 20'000});
    const StressReport other = stress(device(), slits, {.seed = 10, .count = 20'000});
    EXPECT_EQ(one.largest, same.largest);
    EXPECT_EQ(one.most, same.most);
    EXPECT_EQ(one.worst->number, same.worst->number);
    EXPECT_EQ(one.worst->inputs, same.worst->inputs);
    EXPECT_NE(one.worst->inputs, other.worst->inputs);
}

}  // namespace
}  // namespace fringe::qualify
