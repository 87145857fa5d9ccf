#include "oracle/path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/disc.hpp"
#include "oracle/fresnel.hpp"
#include "oracle/lighting.hpp"
#include "oracle/thesis.hpp"

namespace fringe::oracle {
namespace {

// A branch at glass that keeps less than this of the path's light, at every wavelength, is not followed.
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
    if (!hit) return {background(world_, path.throughput)};

    const double approach = -glm::dot(ray.direction, hit->normal);
    const bool front = approach >= 0.0;
    const Encounter at{
        ray, path, *hit, front, front ? hit->normal : -hit->normal, std::min(std::abs(approach), 1.0)};
    return std::visit([&](const auto& material) { return shade(material, at); }, hit->surface->material);
}

Value Tracer::shade(const Matt& material, const Encounter& at) const {
    const Receiver receiver{at.hit.position, at.facing, material.reflectance};
    const Throughput& throughput = at.path.throughput;
    Value value = fromThesisGratings(world_, receiver, throughput);
    value.xyz += (fromLights(world_, receiver, throughput, sampler_, at.path.dimension) +
                  fromGratings(world_, receiver, throughput)) /
                 std::numbers::pi;
    return value;
}

Value Tracer::shade(const Mirror& material, const Encounter& at) const {
    Throughput throughput = at.path.throughput;
    throughput.reflectFrom(material.metal, at.cosine);
    return follow(at, reflected(at.ray.direction, at.facing), throughput, reflection);
}

Value Tracer::shade(const scene::Dielectric& material, const Encounter& at) const {
    const double relativeIndex = at.front ? material.ior : 1.0 / material.ior;
    const std::optional<dvec3> through = refracted(at.ray.direction, at.facing, relativeIndex);
    const double share = through ? reflectance(at.cosine, relativeIndex) : 1.0;

    const double brightest = at.path.throughput.brightest();
    Value value;
    const auto addBranch = [&](const dvec3& direction, double branchShare, Branch branch) {
        if (brightest * branchShare < kFaintest) return;
        Throughput throughput = at.path.throughput;
        throughput.passShare(branchShare);
        value += follow(at, direction, throughput, branch);
    };
    addBranch(reflected(at.ray.direction, at.facing), share, reflection);
    if (through) addBranch(*through, 1.0 - share, refraction);
    return value;
}

Value Tracer::shade(const Emitter& material, const Encounter& at) const {
    if (!at.front && !material.twoSided) return {};
    return {material.radiance * world_.palette.color(material.spectrum, Palette::kWhite, at.path.throughput)};
}

Value Tracer::shade(const scene::ThesisDisc& material, const Encounter& at) const {
    const auto& disc = std::get<scene::Disc>(at.hit.surface->shape);
    Value value =
        thesisValue(world_.sumOfColors * discPattern(material, disc, at.hit.position, at.ray.direction),
                    at.path.throughput);
    Throughput throughput = at.path.throughput;
    throughput.passShare(material.mirrorReflectance);
    value += follow(at, reflected(at.ray.direction, at.facing), throughput, reflection);
    return value;
}

Value Tracer::shade(const OpticalDisc& material, const Encounter& at) const {
    const scene::OpticalDisc& disc = material.model;
    const dvec3 center = std::get<scene::Disc>(at.hit.surface->shape).center;
    const double radius = glm::length(at.hit.position - center);
    const bool isHub = radius < disc.metalInnerRadius;
    if (disc.metal ? !at.front && !isHub : isHub) return shade(material.label, at);

    Value value;
    if (isHub) {  // a clear sheet: the sum of all that its two surfaces send to and fro
        const double once = reflectance(at.cosine, disc.coverIndex);
        const double share = 2.0 * once / (1.0 + once);
        Throughput through = at.path.throughput, back = at.path.throughput;
        through.passShare(1.0 - share);
        back.passShare(share);
        value += follow(at, at.ray.direction, through, refraction);
        value += follow(at, reflected(at.ray.direction, at.facing), back, reflection);
        return value;
    }
    const bool isTrack = disc.dataInnerRadius <= radius && radius < disc.dataOuterRadius;
    const TrackPoint point{at.hit.position, at.facing, -at.ray.direction, center};
    if (isTrack)
        value.xyz += diffracted(world_, material, point, at.path.throughput, sampler_, at.path.dimension);
    Throughput throughput = at.path.throughput;
    throughput.passFilter(
        [&](double wavelength_nm) { return mirroredShare(material, point, isTrack, wavelength_nm); });
    value += follow(at, reflected(at.ray.direction, at.facing), throughput, reflection);
    return value;
}

Value Tracer::follow(const Encounter& at, const dvec3& direction, const Throughput& throughput,
                     std::uint64_t branch) const {
    if (at.path.bounces == maxDepth_) return {};
    const Path path{throughput, at.path.bounces + 1, derived(at.path.dimension, branch)};
    const Ray ray{liftOff(at.hit.position, at.hit.normal, direction), glm::normalize(direction)};
    return radiance(ray, path);
}

}  // namespace fringe::oracle
