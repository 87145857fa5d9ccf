#include "profile/maxima.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace fringe::profile {
namespace {

// The first side lobe of sinc^2 has 4.7 % of its height; those of two lines may meet.
constexpr double kHighestSideLobe = 0.1;
constexpr double kSideLobeReach = 3.0;

// Between two maxima the curve falls to this share of the lower one, or they are one.
constexpr double kShallowestDip = 0.95;

using Indices = std::vector<std::size_t>;

// Samples higher than the one before and not lower than the one after; of a plateau, its middle.
Indices localMaxima(std::span<const double> values) {
    Indices tops;
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        if (!(values[i] > values[i - 1])) continue;
        std::size_t end = i;
        while (end + 1 < values.size() && values[end + 1] == values[i]) ++end;
        if (end + 1 < values.size() && values[end + 1] < values[i]) tops.push_back(i + (end - i) / 2);
        i = end;
    }
    return tops;
}

double lowestBetween(std::span<const double> values, std::size_t a, std::size_t b) {
    const auto [first, last] = std::minmax(a, b);
    const auto begin = values.begin();
    return *std::min_element(begin + static_cast<std::ptrdiff_t>(first),
                             begin + static_cast<std::ptrdiff_t>(last) + 1);
}

// Whether `top` is a maximum of its own beside a higher one.
bool standsApart(std::span<const double> values, std::size_t top, std::size_t higher, double separation) {
    const double distance = std::abs(static_cast<double>(top) - static_cast<double>(higher));
    if (distance < separation) return false;
    if (values[top] < kHighestSideLobe * values[higher] && distance < kSideLobeReach * separation)
        return false;
    return lowestBetween(values, top, higher) <= kShallowestDip * values[top];
}

// The vertex of the parabola through three samples.
double parabolaTop(std::span<const double> values, std::size_t i) {
    const double slope = 0.5 * (values[i + 1] - values[i - 1]);
    const double bend = values[i + 1] - 2.0 * values[i] + values[i - 1];
    const double offset = bend < 0.0 ? std::clamp(-slope / bend, -0.5, 0.5) : 0.0;
    return static_cast<double>(i) + offset;
}

// From `top` to the place where the curve crosses `level` on one side. What lies nearer than `reach` belongs
// to the maximum even if it dips below the level there. Ends at `last`.
double crossing(std::span<const double> values, std::size_t top, std::size_t last, double level,
                double reach) {
    const std::int64_t step = last < top ? -1 : 1;
    const auto end = static_cast<std::int64_t>(last);
    const auto value = [&](std::int64_t i) { return values[static_cast<std::size_t>(i)]; };
    std::int64_t i = static_cast<std::int64_t>(top) + step * static_cast<std::int64_t>(reach);
    if ((end - i) * step < 0) i = end;
    while (i != static_cast<std::int64_t>(top) && value(i) < level) i -= step;
    while (i != end && value(i + step) >= level) i += step;
    if (i == end) return static_cast<double>(i);
    const double inside = value(i), outside = value(i + step);
    return static_cast<double>(i) + static_cast<double>(step) * (inside - level) / (inside - outside);
}

// Centre of gravity of the curve, linear between samples, above a level between two crossings.
double centroid(std::span<const double> values, double level, double left, double right) {
    double weight = 0.0, moment = 0.0;
    const auto valueAt = [&](double place) {
        const auto i = std::min(static_cast<std::size_t>(place), values.size() - 2);
        const double f = place - static_cast<double>(i);
        return std::max(0.0, values[i] + f * (values[i + 1] - values[i]) - level);
    };
    for (double from = left; from < right;) {
        const double to = std::min(right, std::floor(from) + 1.0);
        const double a = valueAt(from), b = valueAt(to), h = to - from;
        weight += 0.5 * h * (a + b);
        moment += from * 0.5 * h * (a + b) + h * h * (a + 2.0 * b) / 6.0;
        from = to;
    }
    return weight > 0.0 ? moment / weight : 0.5 * (left + right);
}

}  // namespace

std::vector<Maximum> findMaxima(std::span<const double> values, std::span<const Threshold> thresholds) {
    assert(values.size() == thresholds.size());
    Indices candidates = localMaxima(values);
    std::erase_if(candidates, [&](std::size_t i) { return values[i] < thresholds[i].least; });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
    Indices tops;
    for (const std::size_t candidate : candidates) {
        if (std::all_of(tops.begin(), tops.end(), [&](std::size_t higher) {
                return standsApart(values, candidate, higher, thresholds[candidate].separation);
            }))
            tops.push_back(candidate);
    }
    std::sort(tops.begin(), tops.end());

    std::vector<Maximum> maxima;
    for (std::size_t k = 0; k < tops.size(); ++k) {
        const std::size_t top = tops[k];
        // The lowest sample towards each neighbour is the border.
        const auto borderTo = [&](std::size_t other) {
            const double lowest = lowestBetween(values, top, other);
            std::size_t i = top;
            while (values[i] != lowest) i = other < top ? i - 1 : i + 1;
            return i;
        };
        const std::size_t leftEnd = k > 0 ? borderTo(tops[k - 1]) : 0;
        const std::size_t rightEnd = k + 1 < tops.size() ? borderTo(tops[k + 1]) : values.size() - 1;
        double level = 0.5 * values[top];
        if (k > 0) level = std::max(level, values[leftEnd]);
        if (k + 1 < tops.size()) level = std::max(level, values[rightEnd]);
        const double reach = std::max(1.0, thresholds[top].separation);
        const double left = crossing(values, top, leftEnd, level, reach);
        const double right = crossing(values, top, rightEnd, level, reach);
        const double place = centroid(values, level, left, right);
        maxima.push_back({place, values[top], right - left, std::abs(parabolaTop(values, top) - place), top});
    }
    return maxima;
}

}  // namespace fringe::profile
