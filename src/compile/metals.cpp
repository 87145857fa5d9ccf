// Reads the embedded tables: '#' comments, a line of column names, then wavelength_nm,n,k in rising order.
#include "compile/metals.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <string>
#include <vector>

#include "metal_tables.hpp"

namespace fringe::compile {
namespace {

struct Row {
    double wavelength_nm, n, k;
};

std::vector<Row> readTable(std::string_view text) {
    std::vector<Row> rows;
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
        rows.push_back(row);
    }
    return rows;
}

Row interpolate(const std::vector<Row>& rows, double wavelength_nm) {
    const auto above =
        std::lower_bound(rows.begin(), rows.end(), wavelength_nm,
                         [](const Row& row, double value) { return row.wavelength_nm < value; });
    assert(above != rows.begin() && above != rows.end());
    const Row& a = *(above - 1);
    const Row& b = *above;
    const double t = (wavelength_nm - a.wavelength_nm) / (b.wavelength_nm - a.wavelength_nm);
    return {wavelength_nm, a.n + t * (b.n - a.n), a.k + t * (b.k - a.k)};
}

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

ComplexIndex metalIndex(scene::Metal metal) {
    constexpr std::array<double, 3> kPrimaries_nm{611.4, 549.1, 464.2};
    const std::vector<Row> rows = readTable(tableOf(metal));
    ComplexIndex index{};
    for (int channel = 0; channel < 3; ++channel) {
        const Row row = interpolate(rows, kPrimaries_nm[static_cast<std::size_t>(channel)]);
        index.n[channel] = row.n;
        index.k[channel] = row.k;
    }
    return index;
}

}  // namespace fringe::compile
