#include "oracle/throughput.hpp"

#include <algorithm>

#include "oracle/fresnel.hpp"
#include "oracle/metals.hpp"

namespace fringe::oracle {

double Throughput::at(double wavelength_nm) const {
    double product = share_;
    for (const auto& [metal, cosine] : mirrors_)
        product *= reflectance(cosine, refractiveIndex(metal, wavelength_nm * units::nm));
    for (const auto& filter : filters_) product *= filter(wavelength_nm);
    return product;
}

double Throughput::brightest() const {
    if (isConstant()) return share_;
    constexpr int kStep_nm = 10;
    double most = 0.0;
    for (int i = 0; kFirst_nm + i * kStep_nm <= kLast_nm; ++i)
        most = std::max(most, at(kFirst_nm + i * kStep_nm));
    return most;
}

}  // namespace fringe::oracle
