#include "optics/integrals.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace fringe::optics {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

// Where the power series end: beyond, their terms cancel.
constexpr double kSeriesEnd = 4.0;

// Where the asymptotic series begin: their smallest term is then below 1e-15.
constexpr double kAsymptoticStart = 36.0;

struct SineCosineIntegrals {
    double sine;
    double cosine;
};

// DLMF 6.6.5-6.
SineCosineIntegrals powerSeries(double x) {
    SineCosineIntegrals sum{x, std::numbers::egamma + std::log(x)};
    double power = x;  // x^n / n!
    for (int n = 2; n < 40; ++n) {
        power *= x / n;
        const double term = ((n / 2) % 2 == 0 ? power : -power) / n;
        (n % 2 == 0 ? sum.cosine : sum.sine) += term;
    }
    return sum;
}

// g(x) - i f(x) = exp(ix) E1(ix) by the continued fraction DLMF 6.9.1, from its end. From x = 4 on, so many
// terms leave 1e-16.
Complex auxiliary(double x) {
    const int last = static_cast<int>(180.0 / x) + 2;
    Complex tail = 0.0;
    for (int n = last; n >= 1; --n) tail = double(n) * n / (Complex(2.0 * n + 1.0, x) - tail);
    return 1.0 / (Complex(1.0, x) - tail);
}

}  // namespace

double sinc(double x) {
    const double y = pi * x;
    return std::abs(y) < 1e-8 ? 1.0 : std::sin(y) / y;
}

double sincSquared(double x) {
    const double amplitude = sinc(x);
    return amplitude * amplitude;
}

double arrayFactor(double count, double t) {
    const double order = std::nearbyint(t);
    const double r = t - order;
    if (r == 0.0 || count == 1.0) return std::fmod((count - 1.0) * order, 2.0) == 0.0 ? count : -count;
    const double quotient = std::sin(count * pi * r) / std::sin(pi * r);
    return std::fmod((count - 1.0) * order, 2.0) == 0.0 ? quotient : -quotient;
}

double sineIntegral(double x) {
    const double a = std::abs(x);
    if (a <= kSeriesEnd) return a == 0.0 ? 0.0 : std::copysign(powerSeries(a).sine, x);
    const AuxiliaryRests rests = auxiliaryRests(a);
    const double f = (1.0 - rests.first / a) / a;
    const double g = (1.0 - rests.second) / (a * a);
    return std::copysign(0.5 * pi - f * std::cos(a) - g * std::sin(a), x);
}

AuxiliaryRests auxiliaryRests(double x) {
    assert(x > 0.0);
    if (x <= kSeriesEnd) {
        const SineCosineIntegrals integrals = powerSeries(x);
        const double rest = 0.5 * pi - integrals.sine;
        const double f = integrals.cosine * std::sin(x) + rest * std::cos(x);
        const double g = -integrals.cosine * std::cos(x) + rest * std::sin(x);
        return {x * (1.0 - x * f), 1.0 - x * x * g};
    }
    if (x < kAsymptoticStart) {
        const Complex both = auxiliary(x);
        return {x * (1.0 + x * both.imag()), 1.0 - x * x * both.real()};
    }
    // DLMF 6.12.3-4, up to a term below 1e-16.
    const double z = 1.0 / (x * x);
    AuxiliaryRests sum{0.0, 0.0};
    double first = 2.0 * z, second = 6.0 * z;  // +-(2n)!/x^2n and +-(2n+1)!/x^2n
    for (int n = 1; std::abs(second) > 1e-17; ++n) {
        sum.first += first;
        sum.second += second;
        first *= -(2.0 * n + 1.0) * (2.0 * n + 2.0) * z;
        second *= -(2.0 * n + 2.0) * (2.0 * n + 3.0) * z;
        if (n >= 17) break;
    }
    return {x * sum.first, sum.second};
}

double inverseSquareTail(double x, Complex turn) {
    if (x < 1e-9) return 1.0;
    const AuxiliaryRests rests = auxiliaryRests(x);
    return (rests.first * turn.real() - (1.0 - rests.second) * turn.imag()) / x;
}

double centralShare(double x) {
    const double sine = std::sin(pi * x);
    return x == 0.0 ? 0.0 : 2.0 / pi * (sineIntegral(2.0 * pi * x) - sine * sine / (pi * x));
}

std::complex<double> fresnelIntegrals(double x) {
    const double a = std::abs(x);
    Complex value = 0.0;
    if (a < 1.6) {
        // DLMF 7.6.4 and 7.6.6: sum of (i pi/2)^n x^(2n+1) / (n! (2n+1)).
        const Complex step(0.0, 0.5 * pi * a * a);
        Complex power = a;
        for (int n = 0; n < 40; ++n) {
            value += power / (2.0 * n + 1.0);
            power *= step / (n + 1.0);
        }
    } else {
        // (1 + i)/2 erf(z) with z = sqrt(pi)/2 (1 - i) x, by the continued fraction DLMF 7.9.2, from its end.
        const Complex z = 0.5 * std::sqrt(pi) * Complex(a, -a);
        const Complex twiceSquare(0.0, -pi * a * a);
        const int last = static_cast<int>(200.0 / (a * a)) + 3;
        Complex tail = 0.0;
        for (int n = last; n >= 1; --n)
            tail = (2.0 * n - 1.0) * (2.0 * n) / (twiceSquare + (4.0 * n + 1.0) - tail);
        // exp(-z^2) has modulus 1; the phase is reduced by whole turns.
        const double phase = 0.5 * pi * std::fmod(a * a, 4.0);
        const Complex complement =
            2.0 * z / (twiceSquare + 1.0 - tail) * std::polar(1.0 / std::sqrt(pi), phase);
        value = Complex(0.5, 0.5) * (1.0 - complement);
    }
    return x < 0.0 ? -value : value;
}

GaussRule gaussLegendre(int points) {
    GaussRule rule;
    for (int i = 0; i < points; ++i) {
        double x = -std::cos(pi * (i + 0.75) / (points + 0.5));
        double slope = 1.0;
        for (int iteration = 0; iteration < 8; ++iteration) {  // Newton's method on the Legendre polynomial
            double previous = 1.0, value = x;
            for (int n = 2; n <= points; ++n) {
                const double next = ((2.0 * n - 1.0) * x * value - (n - 1.0) * previous) / n;
                previous = value;
                value = next;
            }
            slope = points * (x * value - previous) / (x * x - 1.0);
            x -= value / slope;
        }
        rule.nodes.push_back(x);
        rule.weights.push_back(2.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

}  // namespace fringe::optics
