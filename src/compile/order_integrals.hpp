// What a spectrum that is straight between its nodes takes of the light of N slits: means of the array factor
// over hats.
#pragma once

#include <vector>

namespace fringe::compile {

// The array factor (1/N) (sin(pi N t) / sin(pi t))^2, N at the orders t = ..., -1, 0, 1, ...: Fejer's kernel,
// which is the sum of N sinc^2(N (t - order)) over all orders.
double fejerKernel(double count, double t);

// A function of t that is 1 at one place and falls to 0 on a straight line at either side; half of it where a
// side has no width.
struct Hat {
    double from, at, to;  // ascending
};

// Means over hats, as weights. Absolute error 1e-5 of an order's light.
class OrderIntegrals {
public:
    // Precondition: count, the number of slits, is a whole number from 1 on.
    explicit OrderIntegrals(double count);

    // Of Fejer's kernel over 0 <= t, without what belongs to order 0 unless `zeroOrder`.
    double diffracted(const Hat& hat, bool zeroOrder) const;

    // Of N sinc^2(N (t - order)).
    double ofOrder(double order, const Hat& hat) const;

private:
    double fewTwice(double t) const;
    bool isNarrow(const Hat& hat) const;

    double count_;
    struct Node {
        double twice, integral;
    };
    double perTurn_ = 0.0;     // nodes to a turn
    std::vector<Node> nodes_;  // few slits: from 0 to half a turn; else empty
};

}  // namespace fringe::compile
