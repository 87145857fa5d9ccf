// Sample points of a pixel: unbiased, evenly spread for any number of samples, and a function of the seed,
// the pixel and the sample's number alone.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace fringe::oracle {

// A name for something that is sampled, derived from the name of what it belongs to and its number there.
// Points of different names are independent; those of one name, over a pixel's samples, avoid each other.
using Dimension = std::uint64_t;
Dimension derived(Dimension parent, std::uint64_t number);

// The numbers 0..count-1 in another order, a different one for each key: the `index`th of them, count > 0.
std::uint32_t permuted(std::uint32_t index, std::uint32_t count, std::uint64_t key);

class Sampler {
public:
    // For sample `index` of the `count` of a pixel.
    Sampler(std::uint32_t seed, std::uint64_t pixel, std::uint32_t index, std::uint32_t count);

    // Uniform in [0, 1]^2. A single sample takes the middle of everything instead: a picture without noise,
    // with a pinhole for a lens and hard shadows.
    glm::dvec2 pair(Dimension dimension) const;

private:
    std::uint64_t key_;  // of the pixel
    std::uint32_t index_;
    std::uint32_t count_;
};

// From the unit square to the unit disc, uniform points to uniform points and the middle to the middle
// (P. Shirley, K. Chiu, "A low distortion map between disk and square", 1997).
glm::dvec2 onUnitDisc(const glm::dvec2& u);

}  // namespace fringe::oracle
