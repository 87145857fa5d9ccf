#include "oracle/lighting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "oracle/emitters.hpp"
#include "oracle/frame.hpp"
#include "oracle/thesis.hpp"

namespace fringe::oracle {
namespace {

using glm::dot;
using glm::length;
using std::numbers::pi;

struct Arriving {
    double irradiance;
    dvec3 direction;  // unit
};

constexpr Arriving kNothing{0.0, dvec3(0.0)};

// A point that is lit, and which side of it.
struct Place {
    const World& world;
    const dvec3& position;
    const dvec3& normal;
};

// From a point that sends out `intensity` this way: inverse square, cosine and shadow.
Arriving inverseSquare(const Place& at, const dvec3& source, double intensity) {
    const dvec3 toSource = source - at.position;
    const double distance = length(toSource);
    const double height = dot(toSource, at.normal);
    if (height <= 0.0 || intensity <= 0.0) return kNothing;
    if (!sees(at.world, at.position, at.normal, source)) return kNothing;
    return {intensity * (height / distance) / (distance * distance), toSource / distance};
}

Arriving fromLamp(const Place& at, const scene::PointLight& lamp) {
    return inverseSquare(at, lamp.position, lamp.power.si / (4.0 * pi));
}

// The smoothstep between the two cones passes half of what falls between them, hence the mean cosine.
Arriving fromLamp(const Place& at, const scene::SpotLight& lamp) {
    const double outer = std::cos(lamp.angle.si);
    const double inner = std::cos(lamp.innerAngle.si);
    const double axial = lamp.power.si / (2.0 * pi * (1.0 - 0.5 * (inner + outer)));

    const double cosine = dot(glm::normalize(at.position - lamp.position), lamp.direction);
    double share = cosine >= inner ? 1.0 : 0.0;
    if (outer < cosine && cosine < inner) {
        const double x = (cosine - outer) / (inner - outer);
        share = x * x * (3.0 - 2.0 * x);
    }
    return inverseSquare(at, lamp.position, axial * share);
}

// Of even radiance over its round image in the sky: a cap, and `u` a point of it.
Arriving fromLamp(const Place& at, const scene::DirectionalLight& lamp, const glm::dvec2& u) {
    const double sine = std::sin(0.5 * lamp.angularSize.si);
    const glm::dvec2 across = sine * onUnitDisc(u);
    const double axial = std::sqrt(1.0 - dot(across, across));
    const dvec3 direction = Frame::around(-lamp.direction).toWorld(dvec3(across, axial));
    const double cosine = dot(direction, at.normal);
    if (cosine <= 0.0 || !seesSky(at.world, at.position, at.normal, direction)) return kNothing;
    return {lamp.irradiance.si * cosine / axial, direction};
}

template <class Pointlike>
Arriving fromLamp(const Place& at, const Pointlike& lamp, const glm::dvec2& /*u*/) {
    return fromLamp(at, lamp);
}

// One point of the emitter stands for all of it.
Arriving fromEmitter(const Place& at, const Surface& surface, const glm::dvec2& u) {
    const auto& emitter = std::get<Emitter>(surface.material);
    const std::optional<EmitterPoint> point = pointOn(surface.shape, emitter.twoSided, at.position, u);
    if (!point) return kNothing;
    const dvec3 direction = glm::normalize(point->position - at.position);
    const double cosine = dot(direction, at.normal);
    if (cosine <= 0.0) return kNothing;
    if (!sees(at.world, at.position, at.normal, point->position, &surface)) return kNothing;
    return {point->solidAngle * cosine * emitter.radiance, direction};
}

// Directions in proportion to their cosine, by dropping the points of a disc on the hemisphere over it.
Arriving fromSky(const Place& at, const glm::dvec2& u) {
    const glm::dvec2 across = onUnitDisc(u);
    const double cosine = std::sqrt(std::max(0.0, 1.0 - dot(across, across)));
    const dvec3 direction = Frame::around(at.normal).toWorld(dvec3(across, cosine));
    return seesSky(at.world, at.position, at.normal, direction) ? Arriving{pi, direction} : kNothing;
}

// Nanometres: dominant wavelengths of the sRGB primaries, where what a path leaves stands for the channel.
constexpr std::array<double, 3> kPrimaries_nm{611.4, 549.1, 464.2};

}  // namespace

std::vector<Arrival> arrivals(const World& world, const dvec3& position, const dvec3& normal,
                              const Sampler& sampler, Dimension dimension) {
    const Place at{world, position, normal};
    std::vector<Arrival> all;
    const auto add = [&](const Arriving& light, double scale, std::size_t spectrum) {
        if (light.irradiance > 0.0) all.push_back({scale * light.irradiance, light.direction, spectrum});
    };
    for (std::size_t i = 0; i < world.lamps.size(); ++i) {
        const Lamp& lamp = world.lamps[i];
        const glm::dvec2 u = sampler.pair(derived(dimension, world.surfaces.size() + 1 + i));
        add(std::visit([&](const auto& model) { return fromLamp(at, model, u); }, lamp.model), 1.0,
            lamp.spectrum);
    }
    for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
        const Surface& surface = world.surfaces[i];
        const auto* emitter = std::get_if<Emitter>(&surface.material);
        if (!emitter) continue;
        add(fromEmitter(at, surface, sampler.pair(derived(dimension, i))), 1.0, emitter->spectrum);
    }
    if (!world.skies.empty()) {
        const Arriving sky = fromSky(at, sampler.pair(derived(dimension, world.surfaces.size())));
        for (const Sky& each : world.skies) add(sky, each.radiance, each.spectrum);
    }
    return all;
}

double emittedRadiance(const World& world, const dvec3& position, const dvec3& normal, const dvec3& direction,
                       std::size_t spectrum) {
    const std::optional<SurfaceHit> hit = nearest(world, {liftOff(position, normal, direction), direction});
    double radiance = 0.0;
    if (hit) {
        const auto* emitter = std::get_if<Emitter>(&hit->surface->material);
        const bool shines = emitter && (emitter->twoSided || dot(hit->normal, direction) < 0.0);
        if (shines && emitter->spectrum == spectrum) radiance = emitter->radiance;
    } else {
        for (const Sky& sky : world.skies)
            if (sky.spectrum == spectrum) radiance += sky.radiance;
        for (const Lamp& lamp : world.lamps) {
            const auto* sun = std::get_if<scene::DirectionalLight>(&lamp.model);
            if (!sun || sun->angularSize.si == 0.0 || lamp.spectrum != spectrum) continue;
            const double half = 0.5 * sun->angularSize.si;
            if (dot(direction, sun->direction) < -std::cos(half))
                radiance += sun->irradiance.si / (pi * std::sin(half) * std::sin(half));
        }
    }
    return radiance;
}

Xyz fromLights(const World& world, const Receiver& receiver, const Throughput& throughput,
               const Sampler& sampler, Dimension dimension) {
    Xyz sum(0.0);
    for (const Arrival& light : arrivals(world, receiver.position, receiver.normal, sampler, dimension))
        sum += light.irradiance * world.palette.color(light.spectrum, receiver.reflectance, throughput);
    return sum;
}

Xyz fromGratings(const World& world, const Receiver& receiver, const Throughput& throughput) {
    Xyz sum(0.0);
    for (const Grating& grating : world.gratings) {
        const std::optional<dvec3> source = grating.sourceFor(receiver.position);
        if (!source || !sees(world, receiver.position, receiver.normal, *source)) continue;
        sum += grating.color(receiver.position, receiver.normal,
                             world.palette.passage(receiver.reflectance, throughput));
    }
    return sum;
}

Value fromThesisGratings(const World& world, const Receiver& receiver, const Throughput& throughput) {
    Value sum;
    for (const auto& [color, grating] : world.thesisGratings) {
        const Rgb value = gratingValue(grating, receiver.position);
        if (value == Rgb(0.0) || !sees(world, receiver.position, receiver.normal, grating.position)) continue;
        sum += thesisValue(grating.power.si * color * value, throughput);
    }
    return sum;
}

Value thesisValue(const Rgb& rgb, const Throughput& throughput) {
    if (!std::isfinite(rgb.r) || !std::isfinite(rgb.g) || !std::isfinite(rgb.b)) return {Xyz(0.0), true};
    Rgb left = rgb;
    for (int channel = 0; channel < 3; ++channel)
        left[channel] *= throughput.at(kPrimaries_nm[static_cast<std::size_t>(channel)]);
    return {xyzFromRgb() * left, false};
}

}  // namespace fringe::oracle
