// Integrals by Gauss's rule on panels.
#pragma once

#include <array>
#include <cstddef>

namespace fringe::oracle {

// Nodes in (0, 1) and weights that add up to 1, of 12 points: exact for polynomials of degree 23, and 1e-14
// for a wave of one turn.
struct GaussRule {
    static constexpr std::size_t kPoints = 12;
    std::array<double, kPoints> nodes;
    std::array<double, kPoints> weights;
};
const GaussRule& gaussRule();

// Calls use(x, weight) for every node of `panels` >= 1 equal panels between `from` and `to`.
template <class Use>
void forNodes(double from, double to, std::size_t panels, const Use& use) {
    const GaussRule& rule = gaussRule();
    const double panel = (to - from) / static_cast<double>(panels);
    for (std::size_t i = 0; i < panels; ++i) {
        const double start = from + panel * static_cast<double>(i);
        for (std::size_t k = 0; k < GaussRule::kPoints; ++k)
            use(start + panel * rule.nodes[k], panel * rule.weights[k]);
    }
}

}  // namespace fringe::oracle
