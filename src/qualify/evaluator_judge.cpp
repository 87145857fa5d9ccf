#include "qualify/evaluator_judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "compile/slit_response.hpp"
#include "optics/color_difference.hpp"
#include "oracle/slit_color.hpp"
#include "qualify/draw.hpp"
#include "qualify/halves.hpp"

namespace fringe::qualify {
namespace {

using glm::dvec3;

constexpr double kWindow = 2e-4;

// Where Z, Y and X are largest in the first order, the brightest where the undeviated light is left out:
// errors are relative to the highest value met, which must not depend on chance.
constexpr std::array<double, 3> kFirstOrder_um{0.446, 0.556, 0.599};

double largest(const dvec3& value) {
    return std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
}

}  // namespace

std::vector<EvaluatorWindow> drawWindows(const EvaluatorCase& which, std::uint64_t seed, std::size_t count) {
    const double border = undeviatedUpTo(which);
    const double clear = 2.0 * kWindow + 2.0 / std::max(64.0, 450.0 * which.period_um);
    std::vector<EvaluatorWindow> windows;
    for (std::uint64_t number = 0; windows.size() < count; ++number) {
        Draw draw(seed, number);
        const double low = -which.largestSine - which.incoming, high = which.largestSine - which.incoming;
        double u = draw.between(low, high);
        if (number == 0) {
            u = 0.0;
        } else if (number <= kFirstOrder_um.size()) {
            u = -kFirstOrder_um[number - 1] / which.period_um;
        } else if (draw.oneIn(4)) {
            u = draw.sign() * draw.magnitude(1e-6, which.largestSine);
        } else if (draw.oneIn(4)) {
            // Of a line, or of one of 81 wavelengths.
            const auto& lines = which.spectrum.lines;
            const double wavelength_um =
                lines.empty()
                    ? 0.38 + 0.005 * draw.below(81)
                    : lines[draw.below(static_cast<std::uint32_t>(lines.size()))].wavelength / units::um;
            const double order = std::nearbyint(u * which.period_um / wavelength_um);
            const double beside = draw.oneIn(3) ? 0.0 : draw.between(-3.0, 3.0) / which.count;
            u = (order + beside) * wavelength_um / which.period_um;
        }
        if (u < low || u > high || (border > 0.0 && std::abs(std::abs(u) - border) < clear)) continue;
        windows.push_back({static_cast<float>(u), static_cast<float>(kWindow)});
    }
    return windows;
}

EvaluatorTruth truthOf(std::vector<dvec3> values) {
    EvaluatorTruth truth{std::move(values)};
    double brightest = 0.0;
    for (const dvec3& value : truth.values) {
        truth.peak = std::max(truth.peak, largest(value));
        brightest = std::max(brightest, value.y);
    }
    const dvec3 d65(0.95047, 1.0, 1.08883);
    truth.white = brightest * d65;
    return truth;
}

EvaluatorTruth oracleTruth(const EvaluatorCase& which, std::span<const EvaluatorWindow> windows,
                           double patterns, const std::atomic<bool>& cancelled) {
    const compile::LitSlits lit{slitsOf(which), {}, which.incoming, 0.0};
    // Tenths of a nanometre: it jumps where an order passes off.
    constexpr double kPerNanometre = 10.0;
    std::array<double, 4001> shares{};
    onTwoThreads(shares.size(), [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to && !cancelled; ++i)
            shares[i] = lit.propagatingShare(oracle::kFirst_nm + static_cast<double>(i) / kPerNanometre);
    });
    const auto shareAt = [&](double wavelength_nm) {
        return shares.at(
            static_cast<std::size_t>(std::lround(kPerNanometre * (wavelength_nm - oracle::kFirst_nm))));
    };
    const oracle::SlitColor color(
        {1.0 * which.count, which.width_um, which.period_um, which.spectrum, shareAt, undeviatedUpTo(which)});
    const double perInput = std::max(1600.0, 0.85 * which.count * which.period_um *
                                                 (which.largestSine + std::abs(which.incoming))) *
                            (color.isNarrow(kWindow) ? 1.0 : 12.0);
    const auto judged = static_cast<std::size_t>(std::clamp(patterns / perInput, 48.0, 2048.0));
    std::vector<dvec3> values(judged);
    onTwoThreads(judged, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to && !cancelled; ++i)
            values[i] = color.mean(double{windows[i].u}, double{windows[i].width});
    });
    if (cancelled) values.clear();
    return truthOf(std::move(values));
}

void judge(const EvaluatorTruth& truth, std::span<const EvaluatorWindow> windows,
           const std::function<std::pair<dvec3, bool>(std::size_t)>& got, EvaluatorRow& row) {
    double squares = 0.0, difference = 0.0;
    std::size_t finite = 0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        const auto [value, isFinite] = got(i);
        if (!isFinite || !std::isfinite(value.x + value.y + value.z)) {
            ++row.nonFinite;
            continue;
        }
        ++finite;
        const double error = largest(value - truth.values[i]) / truth.peak;
        if (error > row.maxError) {
            row.maxError = error;
            row.worstInput = double{windows[i].u};
        }
        squares += error * error;
        difference =
            std::max(difference, optics::colorDifference(optics::labFromXyz(value, truth.white),
                                                         optics::labFromXyz(truth.values[i], truth.white)));
    }
    row.rmsError = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(finite, 1)));
    row.deltaE = difference;
    row.judged = truth.values.size();
}

}  // namespace fringe::qualify
