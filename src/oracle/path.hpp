// Radiance along a ray: one hit after another, down both branches of every glass surface.
#pragma once

#include <cstdint>

#include "oracle/sampler.hpp"
#include "oracle/throughput.hpp"
#include "oracle/value.hpp"
#include "oracle/world.hpp"

namespace fringe::oracle {

// How a ray came about.
struct Path {
    Throughput throughput{};    // of all mirrors and glass surfaces so far
    std::uint32_t bounces = 0;  // how many those were
    Dimension dimension = 0;    // under which everything at its end is sampled
};

class Tracer {
public:
    // A mirror or glass surface that a path meets after `maxDepth` of them is black. Keeps the references.
    Tracer(const World& world, const Sampler& sampler, std::uint32_t maxDepth)
        : world_(world), sampler_(sampler), maxDepth_(maxDepth) {}

    // What comes from ahead of `ray`, weakened by the path's throughput.
    Value radiance(const Ray& ray, const Path& path) const;

private:
    struct Encounter;

    Value shade(const Matt& material, const Encounter& at) const;
    Value shade(const Mirror& material, const Encounter& at) const;
    Value shade(const scene::Dielectric& material, const Encounter& at) const;
    Value shade(const Emitter& material, const Encounter& at) const;
    Value shade(const scene::ThesisDisc& material, const Encounter& at) const;
    Value shade(const OpticalDisc& material, const Encounter& at) const;

    // What a mirror or glass surface passes on from `direction`, one branch of the path, with the throughput
    // behind it.
    Value follow(const Encounter& at, const dvec3& direction, const Throughput& throughput,
                 std::uint64_t branch) const;

    const World& world_;
    const Sampler& sampler_;
    std::uint32_t maxDepth_;
};

}  // namespace fringe::oracle
