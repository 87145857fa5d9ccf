// Slits: with s = width/wavelength, and F_k the transform of the propagating part of sinc^2 at the distance
// of k periods, the share is F_0 + 2 sum (1 - k/count) F_k. F_k is a second difference of an antiderivative
// of sine integrals; its parts that are constant and linear in the distance drop out and are left out from
// the start, so that no digits are lost between them.
#include <cmath>
#include <complex>
#include <numbers>

#include "optics/integrals.hpp"
#include "optics/orders.hpp"
#include "optics/shares.hpp"

namespace fringe::optics {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

// Up to here the sum is taken as it stands (0.5 ms).
constexpr std::uint32_t kMostSummed = 10'000;

// g(S) - S + 1/pi^2 with g(S) = (2/pi) S [Si(2 pi S) - sin^2(pi S)/(pi S)], x = 2 pi S, `turn` = exp(ix).
double antiderivativeRest(double x, Complex turn) {
    return inverseSquareTail(x, turn) / (pi * pi);
}

// At normal incidence. `width` and `period` in wavelengths.
double summed(std::uint32_t count, double width, double period) {
    const double x1 = 2.0 * pi * period, y = 2.0 * pi * width;
    const Complex step = std::polar(1.0, x1), side = std::polar(1.0, y);
    Complex turn = step;
    double sum = 0.0;
    for (std::uint32_t k = 1; k < count; ++k) {
        const double x = k * x1;
        const double difference = 0.5 * (antiderivativeRest(x + y, turn * side) +
                                         antiderivativeRest(x - y, turn * std::conj(side))) -
                                  antiderivativeRest(x, turn);
        sum += (1.0 - double(k) / count) * difference;
        turn *= step;
    }
    return centralShare(width) + 2.0 * sum / width;
}

// The orders as lines of width 1/count, cut off at the last direction; what each takes is constant over its
// line.
double cutOrders(std::uint32_t count, double width, double period) {
    const double fill = width / period;
    double sum = fill * centralShare(count * period);
    for (double order = 1.0; order < period + 2.0; ++order) {
        const double height = orderEfficiency(fill, order) / fill;
        sum += height * (centralShare(count * (period + order)) + centralShare(count * (period - order)));
    }
    return sum;
}

// Above kMostSummed the share differs from cutOrders() by c/count, with c found at kMostSummed slits.
double atNormalIncidence(const Slits& slits, double wavelength) {
    const double width = (slits.width / units::m) / wavelength;
    const double period = (slits.period / units::m) / wavelength;
    if (width < 1e-12) return 0.0;  // grazing incidence: nothing is left on that side
    if (slits.count <= kMostSummed) return summed(slits.count, width, period);
    const double rest = summed(kMostSummed, width, period) - cutOrders(kMostSummed, width, period);
    return cutOrders(slits.count, width, period) + rest * kMostSummed / slits.count;
}

}  // namespace

// Long slits keep beta, which leaves light of the longer wavelength wavelength/sqrt(1 - beta^2) in a plane.
// The directions on either side of the undeviated one are half of what normal incidence of a shorter or
// longer wavelength has.
double shareOf(const Slits& slits, const Incidence& in) {
    const double conical = std::sqrt(1.0 - in.direction.y * in.direction.y);
    const double wavelength = in.wavelength / conical, alpha = in.direction.x / conical;
    if (alpha == 0.0) return atNormalIncidence(slits, wavelength);
    return 0.5 * (atNormalIncidence(slits, wavelength / (1.0 - alpha)) +
                  atNormalIncidence(slits, wavelength / (1.0 + alpha)));
}

}  // namespace fringe::optics
