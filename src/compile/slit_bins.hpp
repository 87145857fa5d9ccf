// What the tables of slits have in common: a spectrum in bins of wavelength, and how the device stores a
// response.
#pragma once

#include "compile/slit_response.hpp"

namespace fringe::compile {

// One bin of wavelengths and what the film records of it, per reflectance.
struct WavelengthBin {
    double wavelength_um;
    double weight;                   // power over the propagating share
    std::vector<glm::dvec3> colors;  // response
    std::vector<double> orders;      // efficiencies, where they are given
    BandShare share;
};

std::vector<WavelengthBin> wavelengthBins(const LitSlits& lit, const optics::Spectrum& spectrum,
                                          const SpectralTables& tables, double step_nm);

// Densities, one table of `out.entries` after the other, as the entries that the device reads; sets the
// units.
void encode(const std::vector<glm::vec3>& density, SlitResponse& out);

}  // namespace fringe::compile
