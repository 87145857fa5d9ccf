// Complex refractive indices of metals over the visible range.
#pragma once

#include <complex>
#include <vector>

#include "scene/scene.hpp"

namespace fringe::compile {

// A table of third_party/metals, interpolated linearly.
class MetalTable {
public:
    explicit MetalTable(scene::Metal metal);

    // n + i k; precondition: within the table, which covers the visible range.
    std::complex<double> at(double wavelength_nm) const;

private:
    struct Row {
        double wavelength_nm, n, k;
    };

    std::vector<Row> rows_;
};

}  // namespace fringe::compile
