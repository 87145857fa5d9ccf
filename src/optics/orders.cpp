#include "optics/orders.hpp"

#include "optics/integrals.hpp"

namespace fringe::optics {

bool propagates(double alpha, double beta) {
    return alpha * alpha + beta * beta < 1.0;
}

double orderEfficiency(double fill, double order) {
    const double amplitude = fill * sinc(fill * order);
    return amplitude * amplitude;
}

}  // namespace fringe::optics
