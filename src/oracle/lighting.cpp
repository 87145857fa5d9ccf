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
double fromEmitter(const World& world, const Receiver& receiver, const Surface& surface,
                   const glm::dvec2& u) {
    const auto& emitter = std::get<Emitter>(surface.material);
    const std::optional<EmitterPoint> point = pointOn(surface.shape, emitter.twoSided, receiver.position, u);
    if (!point) return 0.0;
    const double cosine = dot(glm::normalize(point->position - receiver.position), receiver.normal);
    if (cosine <= 0.0) return 0.0;
    if (!sees(world, receiver.position, receiver.normal, point->position, &surface)) return 0.0;
    return point->solidAngle * cosine * emitter.radiance;
}

// Directions in proportion to their cosine, by dropping the points of a disc on the hemisphere over it.
bool seesSomeSky(const World& world, const Receiver& receiver, const glm::dvec2& u) {
    const glm::dvec2 across = onUnitDisc(u);
    const double cosine = std::sqrt(std::max(0.0, 1.0 - dot(across, across)));
    const dvec3 direction = Frame::around(receiver.normal).toWorld(dvec3(across, cosine));
    return seesSky(world, receiver.position, receiver.normal, direction);
}

// Nanometres: dominant wavelengths of the sRGB primaries, where what a path leaves stands for the channel.
constexpr std::array<double, 3> kPrimaries_nm{611.4, 549.1, 464.2};

}  // namespace

Xyz fromLights(const World& world, const Receiver& receiver, const Throughput& throughput,
               const Sampler& sampler, Dimension dimension) {
    Xyz sum(0.0);
    const auto add = [&](double irradiance, std::size_t spectrum) {
        if (irradiance == 0.0) return;
        sum += irradiance * world.palette.color(spectrum, receiver.reflectance, throughput);
    };
    for (const Lamp& lamp : world.lamps) {
        add(std::visit([&](const auto& model) { return fromLamp(world, receiver, model); }, lamp.model),
            lamp.spectrum);
    }
    for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
        const Surface& surface = world.surfaces[i];
        const auto* emitter = std::get_if<Emitter>(&surface.material);
        if (!emitter) continue;
        add(fromEmitter(world, receiver, surface, sampler.pair(derived(dimension, i))), emitter->spectrum);
    }
    if (!world.skies.empty() &&
        seesSomeSky(world, receiver, sampler.pair(derived(dimension, world.surfaces.size())))) {
        for (const Sky& sky : world.skies) add(pi * sky.radiance, sky.spectrum);
    }
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
