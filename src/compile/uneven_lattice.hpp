// The cells of a lattice in a Gaussian beam.
#pragma once

#include <cstdint>
#include <optional>

#include "optics/amplitude_grid.hpp"

namespace fringe::compile {

// What of a lattice a Gaussian beam lights: in either row so many cells about the middle.
struct LitCells {
    std::uint32_t firstCount;
    std::uint32_t secondCount;
    bool isWhole;  // the beam ends within the lattice, and is wide beside a cell
};

// Nothing where the lattice ends within the beam and more than 512 cells in a row are lit: the spectrum of so
// many is too large. `beamWidth`: 1/e^2 diameter in metres.
std::optional<LitCells> litCells(const optics::LatticeAperture& lattice, double beamWidth);

// Their amplitudes, a pixel for a cell; lengths in cells.
optics::AmplitudeGrid cellAmplitudes(const optics::LatticeAperture& lattice, double beamWidth,
                                     const LitCells& lit);

// Of the cells' places about the middle, weighted by the amplitudes; along either row, in cells squared.
glm::dvec2 cellVariance(const optics::AmplitudeGrid& cells);

}  // namespace fringe::compile
