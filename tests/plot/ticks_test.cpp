#include "plot/ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fringe::plot {
namespace {

std::vector<std::string> labels(const Ticks& ticks) {
    std::vector<std::string> texts;
    for (const double value : ticks.values) texts.push_back(ticks.label(value));
    return texts;
}

using Texts = std::vector<std::string>;

TEST(Ticks, AreRoundNumbersInTheRange) {
    EXPECT_EQ(labels(ticksBetween(0.0, 4.0, 10)),
              (Texts{"0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0", "3.5", "4.0"}));
    EXPECT_EQ(labels(ticksBetween(-0.3, 0.31, 6)), (Texts{"-0.2", "0.0", "0.2"}));
    EXPECT_EQ(labels(ticksBetween(0.0, 11000.0, 5)), (Texts{"0", "5000", "10000"}));
    EXPECT_EQ(labels(ticksBetween(0.0, 0.053, 5)), (Texts{"0.00", "0.02", "0.04"}));
}

TEST(Ticks, AreNeverTooManyAndAtLeastTwo) {
    for (double span = 1e-7; span < 1e9; span *= 1.37) {
        for (const double first : {0.0, 0.123 * span, -7.7 * span}) {
            const Ticks ticks = ticksBetween(first, first + span, 6);
            EXPECT_LE(ticks.values.size(), 7U) << first << ' ' << span;
            EXPECT_GE(ticks.values.size(), 2U) << first << ' ' << span;
            for (const double value : ticks.values) {
                EXPECT_GE(value, first - 1e-9 * span);
                EXPECT_LE(value, first + span * (1.0 + 1e-9));
            }
        }
    }
}

}  // namespace
}  // namespace fringe::plot
