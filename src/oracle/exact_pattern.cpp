#include "oracle/exact_pattern.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fringe::oracle {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

double sincSize(double x) {
    return x == 0.0 ? 1.0 : std::sin(pi * (x - std::nearbyint(x))) / (pi * x);  // but for the sign
}

// 2 J1(pi x)/(pi x).
double airy(double x) {
    return std::abs(x) < 1e-8 ? 1.0 : 2.0 * ::j1(pi * x) / (pi * x);
}

// (exp(i y) - exp(i x))/(i (y - x)).
Complex firstDifference(double x, double y) {
    const double half = 0.5 * (y - x);
    const double ratio = std::abs(half) < 1e-8 ? 1.0 : std::sin(half) / half;
    return ratio * std::polar(1.0, 0.5 * (x + y));  // the ratio may be negative
}

// The second divided difference of exp at i times each phase. By the largest spread, or, where that would
// cancel, by the series in the complete symmetric polynomials about the mean.
Complex secondDifference(std::array<double, 3> phase) {
    std::sort(phase.begin(), phase.end());
    const double spread = phase[2] - phase[0];
    if (spread > 0.05) {
        return (firstDifference(phase[1], phase[2]) - firstDifference(phase[0], phase[1])) /
               Complex(0.0, spread);
    }
    const double mean = (phase[0] + phase[1] + phase[2]) / 3.0;
    const double a = phase[0] - mean, b = phase[1] - mean, c = phase[2] - mean;
    // Newton's identities with a + b + c = 0.
    const double p2 = a * a + b * b + c * c, p3 = a * a * a + b * b * b + c * c * c;
    const double h2 = p2 / 2.0, h3 = p3 / 3.0, h4 = p2 * p2 / 4.0, h5 = p2 * p3 / 3.0;
    return std::polar(1.0, mean) * Complex(1.0 / 2.0 - h2 / 24.0 + h4 / 720.0, -h3 / 120.0 + h5 / 5040.0);
}

}  // namespace

double slitPattern(double x) {
    const double amplitude = sincSize(x);
    return amplitude * amplitude;
}

double turnsPast(double u, double high, double low) {
    const double turns = u * high;
    const double past = (turns - std::nearbyint(turns)) + u * low;
    return past - std::nearbyint(past);
}

double arrayPattern(double turns, double count) {
    if (turns == 0.0) return 1.0;
    const double all = count * turns;
    const double quotient = std::sin(pi * (all - std::nearbyint(all))) / (count * std::sin(pi * turns));
    return quotient * quotient;
}

double discPattern(double x, double inner) {
    const double share = inner * inner;
    const double amplitude = (airy(x) - share * airy(inner * x)) / (1.0 - share);
    return amplitude * amplitude;
}

double polygonPattern(std::span<const glm::dvec2> vertices, const glm::dvec2& f) {
    Complex sum = 0.0;
    double area = 0.0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::dvec2 a = vertices[i], b = vertices[(i + 1) % vertices.size()];
        const double twice = a.x * b.y - a.y * b.x;
        sum += twice * secondDifference(
                           {0.0, -2.0 * pi * (f.x * a.x + f.y * a.y), -2.0 * pi * (f.x * b.x + f.y * b.y)});
        area += 0.5 * twice;
    }
    return std::norm(sum) / (area * area);
}

}  // namespace fringe::oracle
