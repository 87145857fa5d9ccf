// Special functions of diffraction, in double precision.
#pragma once

#include <complex>
#include <vector>

namespace fringe::optics {

// sin(pi x) / (pi x), 1 at 0.
double sinc(double x);
double sincSquared(double x);

// sin(count pi t) / sin(pi t), with its sign; `count` at t = 0. Reduces t to the nearest order first, so it
// holds to 1e-15 count^2 |t| next to every order.
double arrayFactor(double count, double t);

// Integral of sin(t)/t from 0 to x; error 1e-15.
double sineIntegral(double x);

// What is left of the auxiliary functions f and g of the sine and cosine integrals (DLMF 6.2.17-18) without
// their leading terms 1/x and 1/x^2: first = x (1 - x f(x)), about 2/x; second = 1 - x^2 g(x), about 6/x^2.
// They keep their digits where differences of the integrals themselves would cancel. x > 0.
struct AuxiliaryRests {
    double first;
    double second;
};
AuxiliaryRests auxiliaryRests(double x);

// x times the integral of cos(t)/t^2 from x on: 1 at 0. `turn` = exp(ix).
double inverseSquareTail(double x, std::complex<double> turn);

// Integral of sinc^2 from -x to x: the share of a slit's light within `x` zeros of its middle.
double centralShare(double x);

// C(x) + i S(x), the Fresnel integrals of pi t^2/2 (DLMF 7.2.7-8); error 1e-15.
std::complex<double> fresnelIntegrals(double x);

// Abscissae in (-1, 1), ascending, and weights of Gauss-Legendre quadrature.
struct GaussRule {
    std::vector<double> nodes;
    std::vector<double> weights;
};
GaussRule gaussLegendre(int points);

}  // namespace fringe::optics
