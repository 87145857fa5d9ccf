// Which costs none beats.
#include "qualify/pareto.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace fringe::qualify {
namespace {

using Indices = std::vector<std::size_t>;

TEST(ParetoFront, OfNothingAndOfOne) {
    EXPECT_EQ(paretoFront({}), Indices());
    EXPECT_EQ(paretoFront(std::vector<Costs>{{1.0, 1.0}}), Indices{0});
}

TEST(ParetoFront, KeepsWhatIsFasterOrCloserInTheOrderOfTime) {
    const std::vector<Costs> costs{{4.0, 0.1}, {1.0, 9.0}, {2.0, 9.5}, {2.0, 3.0}, {5.0, 0.1}, {3.0, 3.0}};
    EXPECT_EQ(paretoFront(costs), (Indices{1, 3, 0}));
}

TEST(ParetoFront, OfEqualOnesHasTheFirst) {
    EXPECT_EQ(paretoFront(std::vector<Costs>{{1.0, 1.0}, {1.0, 1.0}}), Indices{0});
}

TEST(ParetoFront, LeavesOutWhatIsNoNumber) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(paretoFront(std::vector<Costs>{{0.5, kNone}, {kNone, 0.0}, {1.0, 1.0}}), Indices{2});
}

// By its definition: a point is on the front if and only if no other beats it.
TEST(ParetoFront, IsWhatNoOtherBeats) {
    std::mt19937 random(3);
    std::vector<Costs> costs;
    for (int i = 0; i < 300; ++i) costs.push_back({double(random() % 40), double(random() % 40)});
    const Indices front = paretoFront(costs);
    for (std::size_t i = 0; i < costs.size(); ++i) {
        bool beaten = false;
        for (std::size_t j = 0; j < costs.size(); ++j) {
            const bool noWorse = costs[j].time <= costs[i].time && costs[j].error <= costs[i].error;
            const bool equal = costs[j].time == costs[i].time && costs[j].error == costs[i].error;
            beaten = beaten || (noWorse && (!equal || j < i));
        }
        EXPECT_EQ(std::find(front.begin(), front.end(), i) != front.end(), !beaten) << i;
    }
}

}  // namespace
}  // namespace fringe::qualify
