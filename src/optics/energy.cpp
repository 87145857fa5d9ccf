#include "optics/energy.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "optics/integrals.hpp"
#include "optics/shares.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {

using glm::dvec2;
using std::numbers::pi;

double propagatingShare(const Aperture& aperture, units::Length wavelength, double alphaIn, double betaIn) {
    const Incidence in{wavelength / units::m, {alphaIn, betaIn}};
    assert(glm::dot(in.direction, in.direction) < 1.0);
    return std::visit([&](const auto& shape) { return shareOf(shape, in); }, aperture);
}

// Polar coordinates about the undeviated direction, where |A|^2 has its peak. Around, the midpoint rule,
// which converges exponentially once it follows the ripple; outwards, Gauss panels of two periods of it.
double shareByQuadrature(const Aperture& aperture, double extent, const Incidence& in) {
    static const GaussRule rule = gaussLegendre(12);
    const double waves = extent / in.wavelength;
    const bool isEven = in.direction == dvec2(0.0);
    const double farthest = 1.0 + glm::length(in.direction);
    const auto around = static_cast<int>(2.0 * pi * waves * farthest) + 40;
    double sum = 0.0;
    for (int i = 0; i < around; ++i) {
        const double angle = (isEven ? 1.0 : 2.0) * pi * (i + 0.5) / around;
        const dvec2 towards(std::cos(angle), std::sin(angle));
        const double last = reach(in, towards) / in.wavelength;
        const auto panels = static_cast<int>(0.5 * extent * last) + 1;
        const double half = 0.5 * last / panels;
        for (int panel = 0; panel < panels; ++panel) {
            for (std::size_t node = 0; node < rule.nodes.size(); ++node) {
                const double f = (2.0 * panel + 1.0 + rule.nodes[node]) * half;
                sum += half * rule.weights[node] * f * std::norm(transform(aperture, f * towards));
            }
        }
    }
    return 2.0 * pi * sum / (around * area(aperture));
}

}  // namespace fringe::optics
