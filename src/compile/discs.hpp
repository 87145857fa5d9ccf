// Optical discs for the device: what its formulas need of a track, and the spectra of the scene's lights
// wavelength by wavelength with running integrals, so that all the light between two wavelengths takes two
// look-ups.
#pragma once

#include <vector>

#include "compile/spectral.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

// The record, with what it refers to appended to `values`, at places counted from the beginning of `values`.
device::OpticalDisc compileOpticalDisc(const scene::OpticalDisc& disc, SpectralTables& tables,
                                       std::vector<float>& values);

// Every spectrum that `tables` knows, off every reflectance: a directory [spectrum][reflectance][place of its
// table, place of its lines, number of lines], places counted from the directory's beginning; then for each a
// table [density, running integral from the first entry][nanometre from 380 to 780][xyz] of what the film
// records of the continuous part, and its lines [wavelength in um, xyz].
std::vector<float> discSpectra(const SpectralTables& tables);

}  // namespace fringe::compile
