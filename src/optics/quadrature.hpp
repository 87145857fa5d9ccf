// Integrals over a spectrum as sums: weighted wavelengths.
#pragma once

#include <vector>

#include "optics/spectrum.hpp"

namespace fringe::optics {

struct Node {
    double wavelength_nm;
    double weight;
};

// Nodes with  sum weight f(wavelength) = int density filter f  over the visible range, exactly for every f
// that is linear between whole nanometres.
std::vector<Node> densityNodes(const Curve& density, const Curve& filter);

// Nodes with  sum weight f(wavelength) = int line filter f  over the visible range, for f as above: to 1e-9
// of the line's power and the peak of filter f. One node for a line without width, none outside the range.
std::vector<Node> lineNodes(const Line& line, const Curve& filter);

}  // namespace fringe::optics
