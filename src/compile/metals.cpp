// Reads the embedded tables: '#' comments, a line of column names, then wavelength_nm,n,k in rising order.
#include "compile/metals.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <string>
#include <vector>

#include "metal_tables.hpp"

namespace fringe::compile {
namespace {

std::string_view tableOf(scene::Metal metal) {
    switch (metal) {
        case scene::Metal::aluminium:
            return metals::aluminium;
        case scene::Metal::silver:
            return metals::silver;
        case scene::Metal::gold:
            return metals::gold;
        case scene::Metal::copper:
            return metals::copper;
    }
    assert(false);
    return {};
}

}  // namespace

MetalTable::MetalTable(scene::Metal metal) {
    std::string_view text = tableOf(metal);
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string line(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        Row row{};
        char* rest = nullptr;
        row.wavelength_nm = std::strtod(line.c_str(), &rest);
        if (rest == line.c_str()) continue;  // a comment or the column names
        assert(*rest == ',');
        row.n = std::strtod(rest + 1, &rest);
        assert(*rest == ',');
        row.k = std::strtod(rest + 1, &rest);
        rows_.push_back(row);
    }
}

std::complex<double> MetalTable::at(double wavelength_nm) const {
    const auto above =
        std::lower_bound(rows_.begin(), rows_.end(), wavelength_nm,
                         [](const Row& row, double value) { return row.wavelength_nm < value; });
    assert(above != rows_.begin() && above != rows_.end());
    const Row& a = *(above - 1);
    const Row& b = *above;
    const double t = (wavelength_nm - a.wavelength_nm) / (b.wavelength_nm - a.wavelength_nm);
    return {a.n + t * (b.n - a.n), a.k + t * (b.k - a.k)};
}

}  // namespace fringe::compile
