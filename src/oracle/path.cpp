#include "oracle/path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/fresnel.hpp"
#include "oracle/lighting.hpp"
#include "oracle/thesis.hpp"

namespace fringe::oracle {
namespace {

// A branch at glass that keeps less than this of the path's light, in every channel, is not followed.
constexpr double kFaintest = 1.0 / 4096.0;

enum Branch : std::uint64_t { reflection, refraction };

}  // namespace

// A hit and the path that led to it.
struct Tracer::Encounter {
    const Ray& ray;
    const Path& path;
    const SurfaceHit& hit;
    bool front;     // whether the ray comes from the side that the shape's normal points to
    dvec3 facing;   // the normal on the ray's side
    double cosine;  // of the angle of incidence
};

Value Tracer::radiance(const Ray& ray, const Path& path) const {
    const std::optional<SurfaceHit> hit = nearest(world_, ray);
    if (!hit) return {world_.background};

    const double approach = -glm::dot(ray.direction, hit->normal);
    const bool front = approach >= 0.0;
    const Encounter at{
        ray, path, *hit, front, front ? hit->normal : -hit->normal, std::min(std::abs(approach), 1.0)};
    return std::visit([&](const auto& material) { return shade(material, at); }, hit->surface->material);
}

Value Tracer::shade(const scene::Diffuse& material, const Encounter& at) const {
    const Receiver receiver{at.hit.position, at.facing};
    const Rgb received = irradiance(world_, receiver, sampler_, at.path.dimension);
    Value value = gratingLight(world_, receiver);
    value.rgb += material.reflectance / std::numbers::pi * received;
    return value;
}

Value Tracer::shade(const Mirror& material, const Encounter& at) const {
    Rgb share;
    for (int channel = 0; channel < 3; ++channel)
        share[channel] = reflectance(at.cosine, material.index[channel]);
    return follow(at, reflected(at.ray.direction, at.facing), share, reflection);
}

Value Tracer::shade(const scene::Dielectric& material, const Encounter& at) const {
    const double relativeIndex = at.front ? material.ior : 1.0 / material.ior;
    const std::optional<dvec3> through = refracted(at.ray.direction, at.facing, relativeIndex);
    const double share = through ? reflectance(at.cosine, relativeIndex) : 1.0;

    const Rgb& throughput = at.path.throughput;
    const double brightest = std::max({throughput.r, throughput.g, throughput.b});
    Value value;
    if (brightest * share >= kFaintest) {
        value += follow(at, reflected(at.ray.direction, at.facing), Rgb(share), reflection);
    }
    if (through && brightest * (1.0 - share) >= kFaintest) {
        value += follow(at, *through, Rgb(1.0 - share), refraction);
    }
    return value;
}

Value Tracer::shade(const Emitter& material, const Encounter& at) const {
    return {at.front || material.twoSided ? material.radiance : Rgb(0.0)};
}

Value Tracer::shade(const scene::ThesisDisc& material, const Encounter& at) const {
    const auto& disc = std::get<scene::Disc>(at.hit.surface->shape);
    Value value =
        flagged(world_.sumOfColors * discPattern(material, disc, at.hit.position, at.ray.direction));
    value += follow(at, reflected(at.ray.direction, at.facing), Rgb(material.mirrorReflectance), reflection);
    return value;
}

Value Tracer::follow(const Encounter& at, const dvec3& direction, const Rgb& share,
                     std::uint64_t branch) const {
    if (at.path.bounces == maxDepth_) return {};
    const Path path{at.path.throughput * share, at.path.bounces + 1, derived(at.path.dimension, branch)};
    const Ray ray{liftOff(at.hit.position, at.hit.normal, direction), glm::normalize(direction)};
    return share * radiance(ray, path);
}

}  // namespace fringe::oracle
