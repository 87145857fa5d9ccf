// Light that reaches a matt surface straight from where it comes from.
#pragma once

#include "oracle/sampler.hpp"
#include "oracle/value.hpp"
#include "oracle/world.hpp"

namespace fringe::oracle {

// A point that is lit, `normal` on the side that counts.
struct Receiver {
    dvec3 position;
    dvec3 normal;
};

// Watts per square metre and channel from lamps, emitters and the background, each emitter and the background
// seen in one direction that `sampler` picks under names derived from `dimension`.
Rgb irradiance(const World& world, const Receiver& receiver, const Sampler& sampler, Dimension dimension);

// What the gratings of the thesis add to the picture here: no cosine, on both sides of the surface.
Value gratingLight(const World& world, const Receiver& receiver);

}  // namespace fringe::oracle
