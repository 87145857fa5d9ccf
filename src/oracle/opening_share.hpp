// How much of the light behind an opening propagates.
#pragma once

#include "oracle/opening.hpp"

namespace fringe::oracle {

// Share of the power that passes the opening at this wavelength (metres) which leaves it, for light with the
// direction cosines `incident`; the rest is evanescent. The amplitude's square integrated over all
// directions; beyond 12 wavelengths, where that takes long and little is missing, from the length of the
// edges, right to 1e-3 for smooth outlines. A mask's pixels count as its edges. A lattice of many cells
// closer than 6 wavelengths is taken as endless: right to the inverse of the number of its cells in a row,
// times the share of the orders at the horizon.
double propagatingShare(const OpeningShape& shape, double wavelength, const glm::dvec2& incident);

// The same where a Gaussian beam lights the opening unevenly. (A mask takes the beam up itself, see
// OpeningWave.)
double propagatingShare(const OpeningShape& shape, const scene::Beam& beam, double wavelength,
                        const glm::dvec2& incident);

// Whether it is a lattice that is taken as endless; the share then jumps with the wavelength wherever an
// order passes off.
bool isEndless(const OpeningShape& shape, double wavelength);

}  // namespace fringe::oracle
