#include "optics/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "optics/integrals.hpp"

namespace fringe::optics {
namespace {

// A wavelength given in metres may miss the end of the range by a rounding.
constexpr double kRounding_nm = 1e-6;

struct Range {
    double from_nm;
    double to_nm;
};

Range overlap(Range a, Range b) {
    return {std::max(a.from_nm, b.from_nm), std::min(a.to_nm, b.to_nm)};
}

Range support(const Curve& curve) {
    return curve.empty() ? Range{0.0, 0.0} : Range{curve.front().wavelength_nm, curve.back().wavelength_nm};
}

// The inner points of `range` that an integrand may have a corner at, in order, between its two ends.
class Breaks {
public:
    explicit Breaks(Range range) : range_(range), points_{range.from_nm, range.to_nm} {
        for (double whole = std::floor(range.from_nm) + 1.0; whole < range.to_nm; ++whole) add(whole);
    }
    void add(double wavelength_nm) {
        if (wavelength_nm > range_.from_nm && wavelength_nm < range_.to_nm) points_.push_back(wavelength_nm);
    }
    void add(const Curve& curve) {
        for (const Knot& knot : curve) add(knot.wavelength_nm);
    }
    std::vector<double> sorted() && {
        std::sort(points_.begin(), points_.end());
        points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
        return std::move(points_);
    }

private:
    Range range_;
    std::vector<double> points_;
};

template <class Integrand>
std::vector<Node> nodes(const std::vector<double>& breaks, const GaussRule& rule,
                        const Integrand& integrand) {
    std::vector<Node> result;
    result.reserve((breaks.size() - 1) * rule.nodes.size());
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        const double middle = 0.5 * (breaks[i - 1] + breaks[i]);
        const double half = 0.5 * (breaks[i] - breaks[i - 1]);
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
            const double wavelength_nm = middle + half * rule.nodes[k];
            result.push_back({wavelength_nm, half * rule.weights[k] * integrand(wavelength_nm)});
        }
    }
    return result;
}

}  // namespace

std::vector<Node> densityNodes(const Curve& density, const Curve& filter) {
    const Range range =
        overlap({kShortestVisible_nm, kLongestVisible_nm}, overlap(support(density), support(filter)));
    if (!(range.from_nm < range.to_nm)) return {};
    static const GaussRule rule = gaussLegendre(2);  // exact: density, filter and f are linear each
    Breaks breaks(range);
    breaks.add(density);
    breaks.add(filter);
    return nodes(std::move(breaks).sorted(), rule, [&](double wavelength_nm) {
        return valueAt(density, wavelength_nm) * valueAt(filter, wavelength_nm);
    });
}

std::vector<Node> lineNodes(const Line& line, const Curve& filter) {
    const double centre_nm = line.wavelength / units::nm;
    if (line.width.si <= 0.0) {
        const double inside_nm = std::clamp(centre_nm, kShortestVisible_nm, kLongestVisible_nm);
        if (std::abs(inside_nm - centre_nm) > kRounding_nm) return {};
        return {{inside_nm, line.power * valueAt(filter, inside_nm)}};
    }

    // 7 deviations hold all but 3e-12 of the power; over one of them five points integrate the Gaussian times
    // a quadratic to 4e-10.
    constexpr double kDeviations = 7.0;
    static const GaussRule rule = gaussLegendre(5);
    const double deviation_nm = line.width / units::nm / (2.0 * std::sqrt(2.0 * std::numbers::ln2));
    const Range range = overlap({kShortestVisible_nm, kLongestVisible_nm},
                                overlap(support(filter), {centre_nm - kDeviations * deviation_nm,
                                                          centre_nm + kDeviations * deviation_nm}));
    if (!(range.from_nm < range.to_nm)) return {};
    Breaks breaks(range);
    breaks.add(filter);
    for (double k = -kDeviations; k <= kDeviations; ++k) breaks.add(centre_nm + k * deviation_nm);
    const double peak = line.power / (deviation_nm * std::sqrt(2.0 * std::numbers::pi));
    return nodes(std::move(breaks).sorted(), rule, [&](double wavelength_nm) {
        const double x = (wavelength_nm - centre_nm) / deviation_nm;
        return peak * std::exp(-0.5 * x * x) * valueAt(filter, wavelength_nm);
    });
}

}  // namespace fringe::optics
