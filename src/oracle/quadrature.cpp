#include "oracle/quadrature.hpp"

#include <cmath>
#include <numbers>

namespace fringe::oracle {

// The nodes are the roots of Legendre's polynomial, by Newton's method from their asymptotic places.
const GaussRule& gaussRule() {
    static const GaussRule rule = [] {
        constexpr std::size_t n = GaussRule::kPoints;
        GaussRule made{};
        for (std::size_t i = 0; i < n; ++i) {
            double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (n + 0.5));
            double slope = 0.0;
            for (int step = 0; step < 8; ++step) {
                double before = 1.0;
                double here = x;
                for (std::size_t k = 2; k <= n; ++k) {
                    const double degree = static_cast<double>(k);
                    const double next = ((2.0 * degree - 1.0) * x * here - (degree - 1.0) * before) / degree;
                    before = here;
                    here = next;
                }
                slope = n * (x * here - before) / (x * x - 1.0);
                x -= here / slope;
            }
            made.nodes[i] = 0.5 * (1.0 - x);
            made.weights[i] = 1.0 / ((1.0 - x * x) * slope * slope);
        }
        return made;
    }();
    return rule;
}

}  // namespace fringe::oracle
