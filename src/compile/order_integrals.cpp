#include "compile/order_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "optics/energy.hpp"
#include "optics/integrals.hpp"

namespace fringe::compile {
namespace {

using std::numbers::pi;

// Tabulated, linear between the nodes (error 2e-6), and from kLast on the tail 1/2 - 1/(2 pi^2 x), its ripple
// left out (2e-6).
class SincSquaredTable {
public:
    SincSquaredTable() {
        for (int i = 0; i <= kLast * kPerUnit; ++i)
            values_.push_back(0.5 * optics::centralShare(1.0 * i / kPerUnit));
    }

    double operator()(double x) const {
        const double a = std::abs(x);
        double value = 0.5 - 0.5 / (pi * pi * std::max(a, 1.0));
        if (a < kLast) {
            const double place = a * kPerUnit;
            const auto i = static_cast<std::size_t>(place);
            value = values_[i] + (place - static_cast<double>(i)) * (values_[i + 1] - values_[i]);
        }
        return std::copysign(value, x);
    }

private:
    static constexpr int kLast = 48, kPerUnit = 256;
    std::vector<double> values_;
};

// With more slits the orders are so narrow that few of them count, and a table over half a turn would be
// long.
constexpr double kFewSlits = 50.0;
constexpr double kNodesPerOrder = 32.0;  // across 1 / count; cubic between them: error below 1e-7

}  // namespace

double sincSquaredIntegral(double x) {
    static const SincSquaredTable table;
    return table(x);
}

double fejerKernel(double count, double t) {
    const double quotient = optics::arrayFactor(count, t) / count;
    return count * quotient * quotient;
}

OrderIntegrals::OrderIntegrals(double count) : count_(count) {
    if (count > kFewSlits) return;
    perTurn_ = kNodesPerOrder * count;
    const optics::GaussRule rule = optics::gaussLegendre(4);
    const auto steps = static_cast<int>(0.5 * perTurn_);
    const double half = 0.5 / perTurn_;
    double integral = 0.0;
    nodes_.push_back({0.0, fejerKernel(count, 0.0)});
    for (int i = 1; i <= steps + 1; ++i) {
        const double middle = (i - 0.5) / perTurn_;
        for (std::size_t k = 0; k < rule.weights.size(); ++k) {
            integral += half * rule.weights[k] * fejerKernel(count, middle + half * rule.nodes[k]);
        }
        nodes_.push_back({integral, fejerKernel(count, i / perTurn_)});
    }
}

// Odd about 0, and 1 more from turn to turn.
double OrderIntegrals::fewFrom0(double t) const {
    const double turns = std::nearbyint(t);
    const double place = std::abs(t - turns) * perTurn_;
    const auto i = static_cast<std::size_t>(place);
    const double x = place - static_cast<double>(i);
    const Node& a = nodes_[i];
    const Node& b = nodes_[i + 1];
    const double rise = b.integral - a.integral;
    const double bendA = a.kernel / perTurn_ - rise, bendB = rise - b.kernel / perTurn_;
    const double value = a.integral + x * (rise + (1.0 - x) * ((1.0 - x) * bendA + x * bendB));
    return turns + std::copysign(value, t - turns);
}

double OrderIntegrals::diffracted(double t1, double t2, bool zeroOrder) const {
    // Within a part of a fringe, what is in the middle: exact in sum over neighbouring intervals.
    const bool isNarrow = count_ * (t2 - t1) < 0.1;
    const double middle = 0.5 * (t1 + t2);
    const auto ofOrder = [&](double order) {
        if (isNarrow) return (t2 - t1) * count_ * optics::sincSquared(count_ * (middle - order));
        return sincSquaredIntegral(count_ * (t2 - order)) - sincSquaredIntegral(count_ * (t1 - order));
    };
    if (!nodes_.empty()) return fewFrom0(t2) - fewFrom0(t1) - (zeroOrder ? 0.0 : ofOrder(0.0));
    if (isNarrow) return (t2 - t1) * fejerKernel(count_, middle) - (zeroOrder ? 0.0 : ofOrder(0.0));
    const int first = static_cast<int>(std::floor(t1)) - 1;
    const int last = static_cast<int>(std::ceil(t2)) + 1;
    double sum = (t2 - t1) / (pi * pi * count_ * 1.5);  // the orders further off, as their mean
    if (zeroOrder && first <= 0) sum += 0.5 * (t2 - t1) / (pi * pi * count_ * t1 * t2);
    for (int order = first; order <= last; ++order) {
        if (order != 0) sum += ofOrder(order);
    }
    return sum;
}

}  // namespace fringe::compile
