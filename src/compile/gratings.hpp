// A physical grating of the scene as the device gets it: its record, and its part of the tables.
#pragma once

#include <vector>

#include "compile/interface.hpp"
#include "compile/response_tables.hpp"
#include "compile/slit_response.hpp"
#include "compile/spectral.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

// Share of the beam's power that leaves: the efficiency that the scene states, else what the aperture lets
// through. Orders with efficiencies of their own share what the slits let through, and are not counted here.
double leavingShare(const scene::Grating& grating);

// Slits whose tables are made already: others like them in the same light share these.
struct KnownSlits {
    LitSlits lit;
    optics::Spectrum spectrum;
    device::uint wavelengths;  // that a sum over them goes over, or 0
    device::SlitGrating packed;
};

// Direction cosines of the beam, across the slits and along them.
glm::dvec2 incomingCosines(const scene::Grating& grating);

// The beams of slits in continuous spectra, as far as ripplesShow() (ripples.hpp) needs them: records without
// tables and evaluators.
std::vector<device::SlitGrating> continuousBeams(const scene::Scene& scene);

// Appends to `values` and `responses` what the device reads beside the record, unless `known` slits have it,
// and then the slits to these; `tables` must know all reflectances. `tolerance`: image.tolerance.
device::SlitGrating compileSlits(const scene::Grating& grating, const optics::Slits& slits,
                                 const optics::Spectrum& spectrum, const SpectralTables& tables,
                                 double tolerance, std::vector<float>& values, ResponseTables& responses,
                                 std::vector<KnownSlits>& known);

}  // namespace fringe::compile
