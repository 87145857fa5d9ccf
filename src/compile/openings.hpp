// An opening of any shape but slits as the device gets it: its record, and its part of the tables.
#pragma once

#include <vector>

#include "compile/interface.hpp"
#include "compile/near_field.hpp"
#include "compile/spectral.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

// Appends to `values` what the device reads beside the record: its spectrum as a list of wavenumbers and
// colours, which hold all of  power response(l) |A(0)|^2 / (l^2 area share(l))  so that the device multiplies
// by the relative pattern and by geometry alone; a polygon's vertices; a mask's spectrum. `tables` must know
// all reflectances. `mostLayers`: entries of its near field's tables (near_layers.hpp). Precondition: the
// aperture is no slits.
device::OpeningGrating compileOpening(const scene::Grating& grating, const optics::Spectrum& spectrum,
                                      const SpectralTables& tables, double tolerance,
                                      const NearestField& nearest, std::size_t mostLayers,
                                      std::vector<float>& values);

}  // namespace fringe::compile
