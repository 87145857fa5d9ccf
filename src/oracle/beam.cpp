#include "oracle/beam.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace fringe::oracle {

using scene::BeamProfile;
using std::numbers::pi;

double peakIrradiance(const scene::Beam& beam) {
    const double square = beam.width.si * beam.height.si;
    switch (beam.profile) {
        case BeamProfile::flat:
            return 1.0 / (0.25 * pi * square);
        case BeamProfile::gaussian:
            return 2.0 / (0.25 * pi * square);
        case BeamProfile::rectangle:
            break;
    }
    return 1.0 / square;
}

double relativeIrradiance(const scene::Beam& beam, double x, double y) {
    const double across = 2.0 * x / beam.width.si;
    const double along = 2.0 * y / beam.height.si;
    switch (beam.profile) {
        case BeamProfile::flat:
            return across * across + along * along < 1.0 ? 1.0 : 0.0;
        case BeamProfile::gaussian:
            return std::exp(-2.0 * (across * across + along * along));
        case BeamProfile::rectangle:
            break;
    }
    return std::abs(across) < 1.0 && std::abs(along) < 1.0 ? 1.0 : 0.0;
}

double halfChord(const scene::Beam& beam, double x) {
    constexpr double kGaussianReach = 3.0;
    const double across = std::abs(2.0 * x / beam.width.si);
    switch (beam.profile) {
        case BeamProfile::flat:
            return across < 1.0 ? 0.5 * beam.height.si * std::sqrt(1.0 - across * across) : 0.0;
        case BeamProfile::gaussian:
            return across < kGaussianReach ? std::numeric_limits<double>::infinity() : 0.0;
        case BeamProfile::rectangle:
            break;
    }
    return across < 1.0 ? 0.5 * beam.height.si : 0.0;
}

Front frontAt(const scene::Beam& beam, const glm::dvec2& incident, double x) {
    if (!beam.focus) return {incident.x * x, incident.x, incident.y, 0.0};
    const double f = beam.focus->si;
    const glm::dvec3 focus = f * glm::dvec3(incident, std::sqrt(1.0 - glm::dot(incident, incident)));
    const glm::dvec3 ahead = focus - glm::dvec3(x, 0.0, 0.0);
    const double distance = glm::length(ahead);
    // Difference of squares: the plain difference of the distances would lose digits.
    const double nearer = (2.0 * focus.x * x - x * x) / (f + distance);
    const double beta = ahead.y / distance;
    return {nearer, ahead.x / distance, beta, (1.0 - beta * beta) / distance};
}

}  // namespace fringe::oracle
