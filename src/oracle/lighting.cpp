#include "oracle/lighting.hpp"

#include <algorithm>
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

// From a point that sends out `intensity` this way: inverse square, cosine and shadow.
double inverseSquare(const World& world, const Receiver& receiver, const dvec3& source, double intensity) {
    const dvec3 toSource = source - receiver.position;
    const double distance = length(toSource);
    const double height = dot(toSource, receiver.normal);
    if (height <= 0.0 || intensity <= 0.0) return 0.0;
    if (!sees(world, receiver.position, receiver.normal, source)) return 0.0;
    return intensity * (height / distance) / (distance * distance);
}

double fromLamp(const World& world, const Receiver& receiver, const scene::PointLight& lamp) {
    return inverseSquare(world, receiver, lamp.position, lamp.power.si / (4.0 * pi));
}

// The smoothstep between the two cones passes half of what falls between them, hence the mean cosine.
double fromLamp(const World& world, const Receiver& receiver, const scene::SpotLight& lamp) {
    const double outer = std::cos(lamp.angle.si);
    const double inner = std::cos(lamp.innerAngle.si);
    const double axial = lamp.power.si / (2.0 * pi * (1.0 - 0.5 * (inner + outer)));

    const double cosine = dot(glm::normalize(receiver.position - lamp.position), lamp.direction);
    double share = cosine >= inner ? 1.0 : 0.0;
    if (outer < cosine && cosine < inner) {
        const double x = (cosine - outer) / (inner - outer);
        share = x * x * (3.0 - 2.0 * x);
    }
    return inverseSquare(world, receiver, lamp.position, axial * share);
}

double fromLamp(const World& world, const Receiver& receiver, const scene::DirectionalLight& lamp) {
    const double cosine = -dot(lamp.direction, receiver.normal);
    if (cosine <= 0.0 || !seesSky(world, receiver.position, receiver.normal, -lamp.direction)) return 0.0;
    return lamp.irradiance.si * cosine;
}

// One point of the emitter stands for all of it.
Rgb fromEmitter(const World& world, const Receiver& receiver, const Surface& surface, const glm::dvec2& u) {
    const auto& emitter = std::get<Emitter>(surface.material);
    const std::optional<EmitterPoint> point = pointOn(surface.shape, emitter.twoSided, receiver.position, u);
    if (!point) return Rgb(0.0);
    const double cosine = dot(glm::normalize(point->position - receiver.position), receiver.normal);
    if (cosine <= 0.0) return Rgb(0.0);
    if (!sees(world, receiver.position, receiver.normal, point->position, &surface)) return Rgb(0.0);
    return point->solidAngle * cosine * emitter.radiance;
}

// Directions in proportion to their cosine, by dropping the points of a disc on the hemisphere over it.
Rgb fromBackground(const World& world, const Receiver& receiver, const glm::dvec2& u) {
    const glm::dvec2 across = onUnitDisc(u);
    const double cosine = std::sqrt(std::max(0.0, 1.0 - dot(across, across)));
    const dvec3 direction = Frame::around(receiver.normal).toWorld(dvec3(across, cosine));
    return seesSky(world, receiver.position, receiver.normal, direction) ? pi * world.background : Rgb(0.0);
}

}  // namespace

Rgb irradiance(const World& world, const Receiver& receiver, const Sampler& sampler, Dimension dimension) {
    Rgb sum(0.0);
    for (const Lamp& lamp : world.lamps) {
        sum += lamp.color *
               std::visit([&](const auto& model) { return fromLamp(world, receiver, model); }, lamp.model);
    }
    for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
        const Surface& surface = world.surfaces[i];
        if (!std::holds_alternative<Emitter>(surface.material)) continue;
        sum += fromEmitter(world, receiver, surface, sampler.pair(derived(dimension, i)));
    }
    if (world.background != Rgb(0.0)) {
        sum += fromBackground(world, receiver, sampler.pair(derived(dimension, world.surfaces.size())));
    }
    return sum;
}

Value gratingLight(const World& world, const Receiver& receiver) {
    Value sum;
    for (const auto& [color, grating] : world.gratings) {
        const Rgb value = gratingValue(grating, receiver.position);
        if (value == Rgb(0.0) || !sees(world, receiver.position, receiver.normal, grating.position)) continue;
        sum += flagged(grating.power.si * color * value);
    }
    return sum;
}

}  // namespace fringe::oracle
