#include "compile/lights.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <optional>

#include "compile/gratings.hpp"
#include "compile/materials.hpp"
#include "compile/near_layers.hpp"
#include "compile/number.hpp"
#include "compile/openings.hpp"

namespace fringe::compile {
namespace {

using glm::dvec3;
using std::numbers::pi;

struct EmitterGeometry {
    device::Light light;  // everything but emission and sides
    double area;          // m^2, of one side
};

EmitterGeometry emitterGeometry(const scene::Rectangle& shape) {
    const dvec3 normal = glm::cross(shape.u, shape.v);
    const double area = 4.0 * glm::length(normal);
    device::Light light{};
    light.kind = device::RECTANGLE_LIGHT;
    light.position = toFloat(shape.center);
    light.direction = toFloat(glm::normalize(normal));
    light.u = toFloat(shape.u);
    light.v = toFloat(shape.v);
    light.area = toFloat(area);
    return {light, area};
}

EmitterGeometry emitterGeometry(const scene::Disc& shape) {
    // Any two directions in the disc's plane: the one least along the normal, made perpendicular.
    const dvec3 size = glm::abs(shape.normal);
    const dvec3 aside = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                        : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                             : dvec3(0, 0, 1);
    const dvec3 u = glm::normalize(glm::cross(shape.normal, aside));
    const double inner = shape.innerRadius / shape.radius;
    const double area = pi * shape.radius * shape.radius * (1.0 - inner * inner);
    device::Light light{};
    light.kind = device::DISC_LIGHT;
    light.position = toFloat(shape.center);
    light.direction = toFloat(shape.normal);
    light.u = toFloat(shape.radius * u);
    light.v = toFloat(shape.radius * glm::cross(shape.normal, u));
    light.area = toFloat(area);
    light.innerRatioSquared = toFloat(inner * inner);
    return {light, area};
}

EmitterGeometry emitterGeometry(const scene::Sphere& shape) {
    device::Light light{};
    light.kind = device::SPHERE_LIGHT;
    light.position = toFloat(shape.center);
    light.radius = toFloat(shape.radius);
    return {light, 4.0 * pi * shape.radius * shape.radius};
}

void addEmitter(EmitterGeometry emitter, double radiance, device::uint spectrum, bool twoSided,
                CompiledScene& out) {
    emitter.light.emission = toFloat(radiance);
    emitter.light.spectrum = spectrum;
    emitter.light.twoSided = twoSided ? 1 : 0;
    out.lights.push_back(emitter.light);
}

struct LightCompiler {
    const scene::Scene& scene;
    const scene::Light& light;
    SpectralTables& tables;
    CompiledScene& out;
    std::vector<KnownSlits>& known;
    const NearestField& nearest;  // of an opening
    std::size_t mostLayers;

    void operator()(const scene::PointLight& l) const {
        device::Light packed{};
        packed.kind = device::POINT_LIGHT;
        packed.position = toFloat(l.position);
        add(packed, l.power / units::W / (4.0 * pi));
    }
    // The smoothstep between the two cosines holds half of its width's solid angle.
    void operator()(const scene::SpotLight& l) const {
        const double outer = std::cos(l.angle / units::rad);
        const double inner = std::cos(l.innerAngle / units::rad);
        const double solidAngle = 2.0 * pi * (1.0 - 0.5 * (outer + inner));
        device::Light packed{};
        packed.kind = device::SPOT_LIGHT;
        packed.position = toFloat(l.position);
        packed.direction = toFloat(l.direction);
        packed.cosOuter = toFloat(outer);
        packed.cosInner = toFloat(inner);
        add(packed, l.power / units::W / solidAngle);
    }
    void operator()(const scene::DirectionalLight& l) const {
        device::Light packed{};
        packed.kind = device::DIRECTIONAL_LIGHT;
        packed.direction = toFloat(l.direction);
        packed.radius = toFloat(std::sin(0.5 * (l.angularSize / units::rad)));
        add(packed, l.irradiance / units::W_per_m2);
    }
    // A Lambertian emitter: radiance = power / (pi area).
    void operator()(const scene::AreaLight& l) const {
        std::visit(
            [&](const auto& shape) {
                const EmitterGeometry emitter = emitterGeometry(shape);
                const double radiance = l.power / units::W / (pi * emitter.area);
                const device::uint spectrum = tables.spectrum(light.spectrum);
                addEmitter(emitter, radiance, spectrum, l.twoSided, out);
                out.materials.push_back(emissive(radiance, spectrum, l.twoSided));
            },
            l.shape);
    }
    void operator()(const scene::EnvironmentLight& l) const {
        device::Light packed{};
        packed.kind = device::ENVIRONMENT_LIGHT;
        add(packed, l.radiance / units::W_per_m2_sr);
        out.frame.environment = out.lights.back().emission;
        out.frame.environmentSpectrum = out.lights.back().spectrum;
    }
    void operator()(const scene::ThesisGrating& l) const {
        const double radius = 0.5 * (l.beamDiameter / units::m);
        out.gratings.push_back({.position = toFloat(l.position),
                                .normal = toFloat(l.normal),
                                .across = toFloat(glm::cross(l.normal, l.slitDirection)),
                                .slitDirection = toFloat(l.slitDirection),
                                .radius = toFloat(radius),
                                .attenuation = l.attenuated ? toFloat(1.0 / (radius * radius)) : 0.0F,
                                .color = toFloat(l.power / units::W * light.color),
                                .aperture = compileAperture(l.slits, l.faults)});
    }
    void operator()(const scene::Grating& l) const {
        if (const auto* slits = std::get_if<optics::Slits>(&l.aperture)) {
            out.slitGratings.push_back(compileSlits(l, *slits, light.spectrum, tables, scene.image.tolerance,
                                                    out.tables, out.responses, known));
        } else {
            out.openingGratings.push_back(compileOpening(l, light.spectrum, tables, scene.image.tolerance,
                                                         nearest, mostLayers, out.tables));
        }
    }

private:
    void add(device::Light packed, double emission) const {
        packed.emission = toFloat(emission);
        packed.spectrum = tables.spectrum(light.spectrum);
        out.lights.push_back(packed);
    }
};

void addGlowingObject(const scene::Object& object, const scene::Scene& scene, SpectralTables& tables,
                      CompiledScene& out) {
    const auto* emissive = std::get_if<scene::Emissive>(&scene.materials[object.material].model);
    if (emissive == nullptr) return;
    const double radiance = emissive->radiance / units::W_per_m2_sr;
    const device::uint spectrum = tables.spectrum(emissive->spectrum);
    std::visit(
        [&](const auto& shape) {
            if constexpr (requires { emitterGeometry(shape); }) {
                addEmitter(emitterGeometry(shape), radiance, spectrum, emissive->twoSided, out);
            }
        },
        object.shape);
}

}  // namespace

void addGlowingObjects(const scene::Scene& scene, SpectralTables& tables, CompiledScene& out) {
    for (const scene::Object& object : scene.objects) addGlowingObject(object, scene, tables, out);
}

void addLights(const scene::Scene& scene, SpectralTables& tables, CompiledScene& out) {
    std::vector<KnownSlits> known;
    std::vector<NearestField> nearest(scene.lights.size());
    std::vector<std::size_t> entries(scene.lights.size(), 0);  // of near fields' tables
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const scene::Light& light = scene.lights[i];
        const auto* grating = std::get_if<scene::Grating>(&light.model);
        if (grating == nullptr || std::holds_alternative<optics::Slits>(grating->aperture)) continue;
        nearest[i] = nearestField(scene, *grating);
        const std::optional<UnevenBeam> profile = profileAcross(*grating, nearest[i].fresnelNumber);
        if (hasNearLayers(grating->aperture, profile, nearest[i].fresnelNumber))
            entries[i] = layerEntries(*grating, profile, nearest[i], light.spectrum);
    }
    const auto all = std::accumulate(entries.begin(), entries.end(), std::size_t{0});
    const double granted =
        std::min(double{kMostLayerEntries} / static_cast<double>(std::max(all, std::size_t{1})), 1.0);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const scene::Light& light = scene.lights[i];
        const auto mostLayers = static_cast<std::size_t>(granted * static_cast<double>(entries[i]));
        std::visit(LightCompiler{scene, light, tables, out, known, nearest[i], mostLayers}, light.model);
    }
}

}  // namespace fringe::compile
