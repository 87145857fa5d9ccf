#include "compile/grating_reach.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "compile/number.hpp"
#include "optics/spectrum.hpp"

namespace fringe::compile {
namespace {

using glm::dvec3;

// Far beyond the rounding of the shader's tests: some ten operations on coordinates of this size.
constexpr double kRounding = 1e-5;

// What a region covers along a direction, seen from a point, with the margin.
Interval seenFrom(const Region& region, dvec3 point, dvec3 along) {
    Interval all{0.0, 0.0};
    double size = 0.0;  // of the coordinates, which is what rounding goes by
    for (int axis = 0; axis < 3; ++axis) {
        for (const double coordinate : {region.low[axis], region.high[axis], point[axis]})
            if (std::isfinite(coordinate)) size = std::max(size, std::abs(coordinate));
        if (along[axis] == 0.0) continue;  // even if the region is infinite
        const double a = along[axis] * (region.low[axis] - point[axis]);
        const double b = along[axis] * (region.high[axis] - point[axis]);
        all.low += std::min(a, b);
        all.high += std::max(a, b);
    }
    return {all.low - kRounding * size, all.high + kRounding * size};
}

bool reaches(const device::ThesisGrating& g, const Region& region) {
    if (seenFrom(region, g.position, g.normal).high <= 0.0) return false;
    return nearest(seenFrom(region, g.position, g.slitDirection)) <= g.radius;
}

double lengthOf(double x, double z) {
    return std::sqrt(x * x + z * z);
}

// The beam's edges along the slits, and what diffraction spills beyond: reachesSlits() of shaders/slits.glsl.
bool isInBeam(const device::SlitGrating& g, const Region& region, Interval across, Interval normal) {
    constexpr double kSpillReach = 20.0;    // SPILL_REACH
    constexpr double kGaussianReach = 2.2;  // beamEdge()
    const double conical = std::sqrt(1.0 - double{g.betaIn} * g.betaIn);
    const Interval range{lengthOf(nearest(across), std::max(normal.low, 0.0)) / conical,
                         lengthOf(farthest(across), normal.high) / conical};
    if (std::isinf(range.high)) return true;
    const double magnified =
        std::max(std::abs(1.0 - g.convergence * range.low), std::abs(1.0 - g.convergence * range.high));
    const double edge =
        g.halfHeight * (g.profile == device::GAUSSIAN_BEAM ? kGaussianReach : 1.0) * magnified +
        0.5 * g.angularSize * range.high +
        kSpillReach * std::sqrt(0.5 * optics::kLongestVisible.si * range.high) / conical;
    const Interval along = seenFrom(region, g.position, g.along);
    const double shift1 = g.betaIn * range.low, shift2 = g.betaIn * range.high;
    const Interval foot{along.low - std::max(shift1, shift2), along.high - std::min(shift1, shift2)};
    return nearest(foot) <= edge * (1.0 + kRounding);
}

// Lines in given orders go nowhere else. Other slits send light wherever it propagates.
bool isInFan(const device::SlitGrating& g, std::span<const float> tables, Interval across, Interval normal) {
    if (g.entries > 0 || g.orderCount == 0) return true;
    // Sine of the direction across the slits to the end of an interval that lies at x: the outermost or
    // innermost.
    const auto sine = [&](double x, bool isUpper) {
        const double z = (x > 0.0) == isUpper ? std::max(normal.low, 0.0) : normal.high;
        if (x == 0.0 || std::isinf(z)) return 0.0;
        return std::isinf(x) ? std::copysign(1.0, x) : x / std::hypot(x, z);
    };
    const double conical = std::sqrt(1.0 - double{g.betaIn} * g.betaIn);
    const double low = conical * sine(across.low, false) - g.alphaIn - kRounding;
    const double high = conical * sine(across.high, true) - g.alphaIn + kRounding;
    const double others = g.count < 16.0F ? 3.5 : 1.5;  // from the nearest order: spectralLines()
    for (device::uint i = 0; i < g.lineCount; ++i) {
        const double perU = g.period_um / tables[g.lines + 4 * i];
        if (high * perU >= g.firstOrder - others && low * perU <= g.firstOrder + g.orderCount - 1.0 + others)
            return true;
    }
    return false;
}

bool reaches(const device::SlitGrating& g, std::span<const float> tables, const Region& region) {
    const Interval normal = seenFrom(region, g.position, g.normal);
    if (normal.high <= 0.0) return false;
    const Interval across = seenFrom(region, g.position, g.across);
    return isInBeam(g, region, across, normal) && isInFan(g, tables, across, normal);
}

bool reaches(const device::OpeningGrating& g, const Region& region) {
    return seenFrom(region, g.position, g.normal).high > 0.0;
}

}  // namespace

device::uint GratingReach::count() const {
    return compile::count(scene_.gratings.size() + scene_.slitGratings.size() +
                          scene_.openingGratings.size());
}

dvec3 GratingReach::position(device::uint grating) const {
    const std::size_t slits = scene_.gratings.size(), openings = slits + scene_.slitGratings.size();
    if (grating < slits) return scene_.gratings[grating].position;
    if (grating < openings) return scene_.slitGratings[grating - slits].position;
    return scene_.openingGratings[grating - openings].position;
}

bool GratingReach::mayReach(device::uint grating, const Region& region) const {
    const std::size_t slits = scene_.gratings.size(), openings = slits + scene_.slitGratings.size();
    if (grating < slits) return reaches(scene_.gratings[grating], region);
    if (grating < openings) return reaches(scene_.slitGratings[grating - slits], scene_.tables, region);
    return reaches(scene_.openingGratings[grating - openings], region);
}

}  // namespace fringe::compile
