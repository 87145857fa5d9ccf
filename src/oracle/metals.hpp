// Complex refractive indices of the metals a conductor can be made of (third_party/metals).
#pragma once

#include <complex>

#include "scene/scene.hpp"
#include "units/units.hpp"

namespace fringe::oracle {

// n + i k at a vacuum wavelength from 380 to 780 nm, linear between the points of the table.
std::complex<double> refractiveIndex(scene::Metal metal, units::Length wavelength);

}  // namespace fringe::oracle
