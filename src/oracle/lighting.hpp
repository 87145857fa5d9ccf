// Light that reaches a matt surface straight from where it comes from.
#pragma once

#include <vector>

#include "oracle/sampler.hpp"
#include "oracle/value.hpp"
#include "oracle/world.hpp"

namespace fringe::oracle {

// A point that is lit, `normal` on the side that counts; reflectance in the palette.
struct Receiver {
    dvec3 position;
    dvec3 normal;
    std::size_t reflectance = Palette::kWhite;
};

// Light that comes to a point from one direction (unit): all of a lamp's, or one sample of an emitter's or
// the background's.
struct Arrival {
    double irradiance;
    dvec3 direction;
    std::size_t spectrum;  // in the palette
};

// What lamps, emitters and the background send to a surface point, `normal` on the side that counts; sampled
// as below.
std::vector<Arrival> arrivals(const World& world, const dvec3& position, const dvec3& normal,
                              const Sampler& sampler, Dimension dimension);

// Radiance of this spectrum that shines on a surface point out of a direction (unit): of an emitter there, or
// that of the sky where there is nothing: the background, and directional lights of some size.
double emittedRadiance(const World& world, const dvec3& position, const dvec3& normal, const dvec3& direction,
                       std::size_t spectrum);

// What a matt surface sends back of the light of lamps, emitters and the background, times pi, at the end of
// a path: each emitter and the background seen in one direction that `sampler` picks under names derived from
// `dimension`. Reflectance and throughput 1 make it the colour of the irradiance.
Xyz fromLights(const World& world, const Receiver& receiver, const Throughput& throughput,
               const Sampler& sampler, Dimension dimension);

// The same of the light of gratings, without samples.
Xyz fromGratings(const World& world, const Receiver& receiver, const Throughput& throughput);

// What the gratings of the thesis add to the picture here: no cosine, on both sides of the surface, and its
// own sRGB, of which a path leaves what it leaves of the primaries.
Value fromThesisGratings(const World& world, const Receiver& receiver, const Throughput& throughput);

// A value of the thesis at the end of a path. It may have been 0/0 in some channel: as in the thesis's
// listing, where every channel is added to all three (times 0 for two of them), one NaN spoils the whole.
Value thesisValue(const Rgb& rgb, const Throughput& throughput);

}  // namespace fringe::oracle
