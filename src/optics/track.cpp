#include "optics/track.hpp"

#include <cmath>
#include <numbers>

#include "optics/integrals.hpp"

namespace fringe::optics {
namespace {

using std::numbers::pi;

double duty(const Track& track) {
    return track.pitWidth / track.pitch;
}

}  // namespace

double phaseContrast(const Track& track, units::Length wavelength, double cosines) {
    const double sine = std::sin(pi * (track.depth / wavelength) * cosines);
    return 4.0 * sine * sine;
}

double orderStrength(const Track& track, int order) {
    const double pits = track.pitShare * duty(track);
    return pits * pits * sincSquared(order * duty(track));
}

double orderEfficiency(const Track& track, int order, units::Length wavelength, double cosines) {
    const double contrast = phaseContrast(track, wavelength, cosines);
    if (order != 0) return contrast * orderStrength(track, order);
    const double pits = track.pitShare * duty(track);
    return 1.0 - contrast * pits * (1.0 - pits);
}

double scatteredShare(const Track& track, units::Length wavelength, double cosines) {
    return phaseContrast(track, wavelength, cosines) * duty(track) * track.pitShare * (1.0 - track.pitShare);
}

double scatteringDensity(const Track& track, units::Length wavelength, double u, double v) {
    const double width = track.pitWidth / wavelength;
    const double length = track.correlationLength() / wavelength;
    const double along = 2.0 * pi * length * v;
    return width * sincSquared(width * u) * 2.0 * length / (1.0 + along * along);
}

double propagatingScattering(const Track& track, units::Length wavelength) {
    const double width = track.pitWidth / wavelength;
    const double length = track.correlationLength() / wavelength;
    // Over v in closed form; over u = sin(t), which makes the integrand smooth at the rim.
    const auto strip = [&](double t) {
        const double u = std::sin(t), reach = std::cos(t);
        return width * sincSquared(width * u) * (2.0 / pi) * std::atan(2.0 * pi * length * reach) * reach;
    };
    // Midpoints: the integrand continues evenly over both ends.
    const int steps = 512 + static_cast<int>(64.0 * width);
    const double step = pi / steps;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) sum += step * strip((i + 0.5) * step - 0.5 * pi);
    return sum;
}

bool isWideGroove(const Track& track) {
    return track.pitShare == 1.0 && track.pitWidth >= 10.0 * units::um;
}

double steepestSlope(const Track& track) {
    return 4.0 * (track.depth / track.pitWidth);
}

double grooveEfficiency(const Track& track, int order, units::Length wavelength, double cosines) {
    const double step = wavelength / track.pitch;
    const double reach = steepestSlope(track) * cosines;
    return std::abs(order) * step < reach ? duty(track) * step / (2.0 * reach) : 0.0;
}

}  // namespace fringe::optics
