// Amplitudes of light behind an opening on a grid of pixels, from which its far field is found.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "optics/aperture.hpp"

namespace fringe::optics {

// A straight piece of an outline.
struct Edge {
    glm::dvec2 normal;  // unit, either way
    double weight;      // metres: its length times the squared step of the amplitude across it
};

// Row by row from the top (largest y).
struct AmplitudeGrid {
    std::uint32_t columns;
    std::uint32_t rows;
    glm::dvec2 pixel;  // width and height in metres
    std::vector<float> amplitudes;
    double area;  // m^2: integral of the squared amplitude
    std::vector<Edge> edges;
    bool hasHats;  // a pixel's amplitude falls linearly to the middles of the next ones, and is no square
};

AmplitudeGrid gridOf(const MaskAperture& mask);

// Radius of the largest disc about (0, 0) that lies within the opening, in metres; 0 where the middle is
// not open. Precondition: neither slits, lattice nor mask.
double clearance(const Aperture& aperture);

// The same behind an opening in a Gaussian beam of the 1/e^2 diameter `beamWidth`, in metres, to a factor.
// A mask keeps its pixels. Others get `across` along either side. The far field of these pixels is that of
// the opening to 1e-5 of the peak for 144 of them, up to across/2 fringes off its middle; farther off it
// repeats itself, weaker than that. (Not so of a ring in a beam so much narrower that it lights but a line
// along the inner rim: 2e-4.)
// Precondition: no slits and no lattice.
AmplitudeGrid gaussianGrid(const Aperture& aperture, double beamWidth, std::uint32_t across);

// The amplitude behind an opening, without what is finer than two pixels, in the middles of `across` x
// `across` pixels about (0, 0), row by row from the top: what to sum up where a phase comes on top that
// changes within a pixel of the opening's own.
struct AmplitudeSamples {
    std::uint32_t across;
    double half;   // metres: the square that holds the light reaches as far from its middle
    double pixel;  // metres
    std::vector<float> amplitudes;
};

// Half the side of the square about (0, 0) that holds the light, in metres, as below.
double litHalf(const Aperture& aperture, const std::optional<double>& beamWidth);

// `beamWidth`: 1/e^2 diameter in metres of a Gaussian beam that lights the opening, if one does. What the
// amplitudes stand for is within 0.42 turns per pixel of their middle. Precondition: no slits and no lattice.
AmplitudeSamples samplesOf(const Aperture& aperture, const std::optional<double>& beamWidth,
                           std::uint32_t across);

}  // namespace fringe::optics
