// How much of the light of N slits falls between two places in the pattern: integrals of the array factor.
#pragma once

#include <vector>

namespace fringe::compile {

// Integral of sinc^2 from 0 to x, the share of one order's light; absolute error 4e-6.
double sincSquaredIntegral(double x);

// The array factor (1/N) (sin(pi N t) / sin(pi t))^2, N at the orders t = ..., -1, 0, 1, ...: Fejer's kernel,
// which is the sum of N sinc^2(N (t - order)) over all orders.
double fejerKernel(double count, double t);

// Means of Fejer's kernel, apart from order 0 where that is followed in another way.
class OrderIntegrals {
public:
    // Precondition: count, the number of slits, is a whole number from 1 on.
    explicit OrderIntegrals(double count);

    // Integral of the kernel over t from t1 to t2, 0 < t1 < t2, without what belongs to order 0 unless
    // `zeroOrder`; absolute error 1e-5.
    double diffracted(double t1, double t2, bool zeroOrder) const;

private:
    double fewFrom0(double t) const;

    double count_;
    struct Node {
        double integral, kernel;
    };
    double perTurn_ = 0.0;     // nodes to a turn
    std::vector<Node> nodes_;  // few slits: from 0 to half a turn; else empty
};

}  // namespace fringe::compile
