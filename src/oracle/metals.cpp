#include "oracle/metals.hpp"

#include <array>
#include <cassert>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "metal_tables.hpp"

namespace fringe::oracle {
namespace {

std::string_view table(scene::Metal metal) {
    switch (metal) {
        case scene::Metal::aluminium:
            return kAluminiumTable;
        case scene::Metal::silver:
            return kSilverTable;
        case scene::Metal::gold:
            return kGoldTable;
        case scene::Metal::copper:
            return kCopperTable;
    }
    assert(false);
    return {};
}

struct Row {
    double wavelength_nm = 0.0;
    std::complex<double> index;
};

// Every "wavelength_nm,n,k" of the table; comments and column names are what does not start with a number.
std::vector<Row> parsedIndices(std::string_view table) {
    std::vector<Row> rows;
    std::istringstream text{std::string(table)};
    for (std::string line; std::getline(text, line);) {
        std::istringstream fields(line);
        char comma = 0;
        double wavelength_nm = 0.0;
        double n = 0.0;
        double k = 0.0;
        if (fields >> wavelength_nm >> comma >> n >> comma >> k) rows.push_back({wavelength_nm, {n, k}});
    }
    return rows;
}

// Tables of all metals, by their number.
const std::vector<Row>& rowsOf(scene::Metal metal) {
    static const std::array<std::vector<Row>, 4> tables{
        parsedIndices(table(scene::Metal::aluminium)), parsedIndices(table(scene::Metal::silver)),
        parsedIndices(table(scene::Metal::gold)), parsedIndices(table(scene::Metal::copper))};
    return tables[static_cast<std::size_t>(metal)];
}

}  // namespace

std::complex<double> refractiveIndex(scene::Metal metal, units::Length wavelength) {
    const double wanted_nm = wavelength / units::nm;
    const std::vector<Row>& rows = rowsOf(metal);
    std::size_t i = 1;
    while (i + 1 < rows.size() && rows[i].wavelength_nm < wanted_nm) ++i;
    const Row& below = rows[i - 1];
    const Row& above = rows[i];
    assert(below.wavelength_nm < wanted_nm && wanted_nm <= above.wavelength_nm);

    const double share = (wanted_nm - below.wavelength_nm) / (above.wavelength_nm - below.wavelength_nm);
    return below.index + share * (above.index - below.index);
}

}  // namespace fringe::oracle
