#include "oracle/metals.hpp"

#include <cassert>
#include <sstream>
#include <string>
#include <string_view>

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

// The next "wavelength_nm,n,k" of the table; comments and column names are what does not start with a number.
bool next(std::istream& text, Row& row) {
    for (std::string line; std::getline(text, line);) {
        std::istringstream fields(line);
        char comma = 0;
        double n = 0.0;
        double k = 0.0;
        if (fields >> row.wavelength_nm >> comma >> n >> comma >> k) {
            row.index = {n, k};
            return true;
        }
    }
    return false;
}

}  // namespace

std::complex<double> refractiveIndex(scene::Metal metal, units::Length wavelength) {
    const double wanted_nm = wavelength / units::nm;
    std::istringstream text{std::string(table(metal))};
    Row below;
    Row above;
    while (next(text, above) && above.wavelength_nm < wanted_nm) below = above;
    assert(0.0 < below.wavelength_nm && below.wavelength_nm < wanted_nm && wanted_nm <= above.wavelength_nm);

    const double share = (wanted_nm - below.wavelength_nm) / (above.wavelength_nm - below.wavelength_nm);
    return below.index + share * (above.index - below.index);
}

}  // namespace fringe::oracle
