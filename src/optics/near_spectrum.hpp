// The pattern behind an opening at distances where the phase of its light is still curved across it, as a
// function of the direction, for a row of Fresnel numbers.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "optics/amplitude_grid.hpp"

namespace fringe::optics {

class NearSpectrum {
public:
    // `incoming`: direction cosines of the beam; along them the curvature is less. Tables have `points` x
    // `points` entries, a power of two and twice or four times the samples. Patterns of Fresnel numbers
    // between two neighbours in the row are found by stretching either's so that directions f have the same
    // f/(number + stretch): in the far field it is f that stays, in the near field the place in the opening's
    // image, and between either is right nearly enough.
    NearSpectrum(AmplitudeSamples samples, glm::dvec2 incoming, std::uint32_t points, double stretch);
    ~NearSpectrum();
    NearSpectrum(const NearSpectrum&) = delete;
    NearSpectrum& operator=(const NearSpectrum&) = delete;

    // |A(f)|^2 / |A(0)|^2 with the phase pi number |x|^2/half^2 across the opening, of the far field's A(0):
    // the mean over Fresnel numbers with a hat from `below` over `number` to `above`, in no more steps than
    // tell ripples of its light from each other. Entry (i, j) is the coefficient of the B-spline at the
    // frequency (i, -j)/points/pixel, periodically. Then the same averaged over more and more of its
    // surroundings and smaller and smaller, as MaskSpectrum's levels. May be called by several threads at
    // once.
    std::vector<std::vector<float>> levels(double below, double number, double above) const;

private:
    struct Plans;

    void addPattern(double number, double stretch, double weight, std::vector<float>& pattern) const;

    AmplitudeSamples samples_;
    glm::dvec2 incoming_;
    std::uint32_t points_;
    double stretch_;
    double peak_;  // squared sum of the amplitudes
    std::unique_ptr<Plans> plans_;
};

}  // namespace fringe::optics
