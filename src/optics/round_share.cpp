// Circles and rings. A pattern that depends on the distance from the undeviated direction alone has a share
// that is the mean, over the directions around it, of the power within reach.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "optics/integrals.hpp"
#include "optics/shares.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {
namespace {

using std::numbers::pi;
using units::m;

// Share of a disc's light within frequency `f` (Born & Wolf 8.5.3, Lord Rayleigh).
double encircled(double diameter, double f) {
    const double x = pi * diameter * f;
    return 1.0 - ::j0(x) * ::j0(x) - ::j1(x) * ::j1(x);
}

// Integral of the product of two discs' transforms over all frequencies up to one that grows from call to
// call.
class CrossPower {
public:
    // Invariant: outer > inner > 0, diameters.
    CrossPower(double outer, double inner) : outer_(outer), inner_(inner) {}

    double upTo(double f) {
        // From here on the Bessel functions are sines but for 3/(8 x) of them, of which the fast ones and the
        // integral leave 1e-6.
        const double farOff = std::max(600.0 / (pi * outer_), 60.0 / (pi * inner_));
        if (f > farOff) return 0.25 * pi * inner_ * inner_ - tail(f);
        // Panels of one period of the fastest part.
        const auto panels = static_cast<int>(0.5 * (outer_ + inner_) * (f - known_)) + 1;
        const double half = 0.5 * (f - known_) / panels;
        static const GaussRule rule = gaussLegendre(10);
        for (int panel = 0; panel < panels; ++panel) {
            const double middle = known_ + (2.0 * panel + 1.0) * half;
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const double at = middle + half * rule.nodes[i];
                sum_ += half * rule.weights[i] * ::j1(pi * outer_ * at) * ::j1(pi * inner_ * at) / at;
            }
        }
        known_ = f;
        return 0.5 * pi * outer_ * inner_ * sum_;
    }

private:
    double tail(double f) const {
        const double slow = pi * (outer_ - inner_) * f, fast = pi * (outer_ + inner_) * f;
        const double slowPart = std::cos(slow) - slow * (0.5 * pi - sineIntegral(slow));
        return std::sqrt(outer_ * inner_) / (2.0 * pi * f) * (slowPart - std::cos(fast) / fast);
    }

    double outer_;
    double inner_;
    double known_ = 0.0;
    double sum_ = 0.0;
};

}  // namespace

double shareOf(const CircularAperture& circle, const Incidence& in) {
    const double outer = circle.diameter / m, inner = circle.innerDiameter / m;
    const double outerArea = 0.25 * pi * outer * outer, innerArea = 0.25 * pi * inner * inner;
    const double sine = glm::length(in.direction);
    // The midpoint rule, which converges fast for what is periodic; the ripple it has to follow is below 1e-6
    // of the whole where the bound takes effect.
    const int directions =
        sine == 0.0 ? 1 : static_cast<int>(std::min(64.0 + 2.0 * pi * outer * sine / in.wavelength, 2048.0));
    CrossPower cross(outer, inner);
    double sum = 0.0;
    for (int i = 0; i < directions; ++i) {
        // From the nearest edge of the propagating directions to the farthest.
        const double angle = pi * (i + 0.5) / directions;
        const double f =
            (std::sqrt(1.0 - std::pow(sine * std::sin(angle), 2)) - sine * std::cos(angle)) / in.wavelength;
        sum += outerArea * encircled(outer, f);
        if (inner > 0.0) sum += innerArea * encircled(inner, f) - 2.0 * cross.upTo(f);
    }
    return sum / (directions * (outerArea - innerArea));
}

}  // namespace fringe::optics
