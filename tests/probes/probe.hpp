// Runs aperture_probe.comp: one function of the shaders at many inputs.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace fringe::testing {

enum class Probe : std::uint32_t {
    productError,      // of u * v
    slits,             // width, period (high, low), count
    rectangle,         // width, height
    circle,            // diameter
    ring,              // diameter, inner share
    polygon,           // 1/wavelength, area, vertices
    lattice,           // 1/wavelength, first (x, y high, x, y low), second, counts
    mask,              // 1/wavelength, table size, width, height of a pixel, 1 (square) or 2 (hat), table
    symmetricPolygon,  // 1/wavelength, area, half of the vertices and the next
    evenPolygon,       // the same
};

// On the device that FRINGE_DEVICE names, or the best, under the validation layer: any message fails the
// test.
std::vector<float> evaluate(Probe probe, std::span<const float> parameters,
                            std::span<const glm::vec2> directions);

// A number as the device gets it: high + low.
struct TwoFloats {
    float high;
    float low;
};
TwoFloats split(double value);

// What the shader's sines leave: 2e-7 of the amplitude, thus 4e-7 of the intensity, and as much again of
// roundings.
inline constexpr double kSineBound = 1e-6;

// What a test checks of every pattern: finite everywhere, and this near to what is expected, relative to a
// peak of 1.
void expectNear(std::span<const float> results, std::span<const double> expected,
                std::span<const glm::vec2> directions, double bound);

// Directions for two dimensions: all over, along the axes, near the peak, grazing, and 0; 10^4.
std::vector<glm::vec2> directionsInTwoDimensions(double sizeInWaves);

}  // namespace fringe::testing
