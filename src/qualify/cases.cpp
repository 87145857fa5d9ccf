#include "qualify/cases.hpp"

namespace fringe::qualify {

std::span<const StressCase> stressCases() {
    static const std::vector<StressCase> cases = [] {
        std::vector<StressCase> all;
        for (const auto family :
             {patternCases, beamCases, orderCases, shapeCases, surfaceCases, samplingCases})
            for (StressCase& stressCase : family()) all.push_back(std::move(stressCase));
        return all;
    }();
    return cases;
}

}  // namespace fringe::qualify
