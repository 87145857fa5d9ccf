// The stress cases of each family, and what their judges share.
#pragma once

#include <cmath>
#include <vector>

#include "qualify/error_spread.hpp"
#include "qualify/stress.hpp"

namespace fringe::qualify {

std::vector<StressCase> patternCases();
std::vector<StressCase> beamCases();
std::vector<StressCase> orderCases();
std::vector<StressCase> shapeCases();
std::vector<StressCase> surfaceCases();
std::vector<StressCase> samplingCases();

// Evaluations that `--full` makes of most functions.
inline constexpr std::uint64_t kFullCount = 100'000'000;

// The absolute error of one result.
inline Judgement compared(float got, double expected) {
    return {std::abs(double{got} - expected), ulpsBetween(got, expected), got, expected};
}

}  // namespace fringe::qualify
