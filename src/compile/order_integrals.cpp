#include "compile/order_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "optics/energy.hpp"
#include "optics/integrals.hpp"

namespace fringe::compile {
namespace {

using std::numbers::pi;

// Between two nodes a step apart, by their values and slopes; `x` from 0 to 1.
double cubic(double a, double slopeA, double b, double slopeB, double step, double x) {
    const double rise = b - a;
    const double bendA = slopeA * step - rise, bendB = rise - slopeB * step;
    return a + x * (rise + (1.0 - x) * ((1.0 - x) * bendA + x * bendB));
}

// sinc^2 integrated from 0 twice: even, cubic between the nodes (error 1e-11), and from kLast on without the
// ripple of the tail (5e-6).
class SincSquaredTwice {
public:
    SincSquaredTwice() {
        double twice = 0.0, slope = 0.0, bend = 1.0;
        nodes_.push_back({twice, slope});
        for (int i = 1; i <= kLast * kPerUnit; ++i) {
            const double x = 1.0 * i / kPerUnit;
            const double nextSlope = 0.5 * optics::centralShare(x), nextBend = optics::sincSquared(x);
            // The trapezium with what its ends' slopes say: error step^5/720 of the fourth one.
            twice += 0.5 * kStep * (slope + nextSlope) + kStep * kStep / 12.0 * (bend - nextBend);
            slope = nextSlope;
            bend = nextBend;
            nodes_.push_back({twice, slope});
        }
    }

    double operator()(double x) const {
        const double a = std::abs(x);
        if (a >= kLast)
            return nodes_.back().twice + 0.5 * (a - kLast) - std::log(a / kLast) / (2.0 * pi * pi);
        const double place = a * kPerUnit;
        const auto i = static_cast<std::size_t>(place);
        const Node &from = nodes_[i], &to = nodes_[i + 1];
        return cubic(from.twice, from.slope, to.twice, to.slope, kStep, place - static_cast<double>(i));
    }

private:
    static constexpr int kLast = 48, kPerUnit = 256;
    static constexpr double kStep = 1.0 / kPerUnit;
    struct Node {
        double twice, slope;
    };
    std::vector<Node> nodes_;
};

// Integral of a function times a hat, of that function's second integral; `unit`: small beside the function's
// features.
template <class Twice>
double inHat(const Twice& twice, const Hat& hat, double unit) {
    const double at = twice(hat.at);
    const auto slope = [&] { return (twice(hat.at + unit) - twice(hat.at - unit)) / (2.0 * unit); };
    const double after = hat.to > hat.at ? (twice(hat.to) - at) / (hat.to - hat.at) : slope();
    const double before = hat.at > hat.from ? (at - twice(hat.from)) / (hat.at - hat.from) : slope();
    return after - before;
}

double areaOf(const Hat& hat) {
    return 0.5 * (hat.to - hat.from);
}

constexpr double kUnit = 1e-3;  // of an order's width: error 1e-6 of its light

// With more slits the orders are so narrow that few of them count, and a table over half a turn would be
// long.
constexpr double kFewSlits = 50.0;
constexpr double kNodesPerOrder = 32.0;  // across 1 / count; cubic between them: error below 1e-9

}  // namespace

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
    double integral = 0.0, twice = 0.0;
    nodes_.push_back({twice, integral});
    for (int i = 1; i <= steps + 1; ++i) {
        const double middle = (i - 0.5) / perTurn_;
        twice += 2.0 * half * integral;
        for (std::size_t k = 0; k < rule.weights.size(); ++k) {
            const double offset = half * rule.nodes[k];
            const double part = half * rule.weights[k] * fejerKernel(count, middle + offset);
            integral += part;
            twice += (half - offset) * part;
        }
        nodes_.push_back({twice, integral});
    }
}

// The kernel integrated from 0 twice. The first integral is odd about 0, and 1 more from turn to turn.
double OrderIntegrals::fewTwice(double t) const {
    const double turns = std::nearbyint(t), rest = t - turns;
    const double place = std::abs(rest) * perTurn_;
    const auto i = static_cast<std::size_t>(place);
    const Node &a = nodes_[i], &b = nodes_[i + 1];
    return turns * (0.5 * turns + rest) +
           cubic(a.twice, a.integral, b.twice, b.integral, 1.0 / perTurn_, place - static_cast<double>(i));
}

// Within a part of a fringe, so that what is in the middle will do: in sum over neighbouring hats exact.
bool OrderIntegrals::isNarrow(const Hat& hat) const {
    return count_ * areaOf(hat) < 0.1;
}

double OrderIntegrals::ofOrder(double order, const Hat& hat) const {
    static const SincSquaredTwice twice;
    constexpr double kFar = 16.0;  // from here on the mean over a fringe
    if (isNarrow(hat)) return count_ * optics::sincSquared(count_ * (hat.at - order));
    const double from = count_ * (hat.from - order), at = count_ * (hat.at - order),
                 to = count_ * (hat.to - order);
    if (from > kFar || to < -kFar) return count_ / (2.0 * pi * pi * at * at);
    return inHat(twice, {from, at, to}, kUnit) / areaOf(hat);
}

double OrderIntegrals::diffracted(const Hat& hat, bool zeroOrder) const {
    if (isNarrow(hat)) return fejerKernel(count_, hat.at) - (zeroOrder ? 0.0 : ofOrder(0.0, hat));
    if (!nodes_.empty()) {
        return inHat([this](double t) { return fewTwice(t); }, hat, kUnit / count_) / areaOf(hat) -
               (zeroOrder ? 0.0 : ofOrder(0.0, hat));
    }
    // The nearest order, and the side lobes of all others as their mean: 1/(pi (t - order))^2 adds up to
    // 1/sin^2(pi t).
    const double nearest = std::nearbyint(hat.at), past = pi * (hat.at - nearest), sine = std::sin(past);
    double lobes = std::abs(past) > 1e-3 ? 1.0 / (sine * sine) - 1.0 / (past * past) : 1.0 / 3.0;
    double sum = 0.0;
    if (nearest != 0.0 || zeroOrder) sum += ofOrder(nearest, hat);
    if (nearest != 0.0 && !zeroOrder) lobes -= 1.0 / (pi * pi * hat.at * hat.at);
    sum += lobes / (2.0 * count_);
    return sum;
}

}  // namespace fringe::compile
