// Scene -> CompiledScene: doubles become floats, powers become intensities and radiances, variants become
// records.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "compile/casters.hpp"
#include "compile/compiled_scene.hpp"
#include "compile/discs.hpp"
#include "compile/gratings.hpp"
#include "compile/openings.hpp"

namespace fringe::compile {
namespace {

using glm::dvec3;
using std::numbers::pi;

glm::vec3 toFloat(dvec3 v) {
    return {v};
}
float toFloat(double v) {
    return static_cast<float>(v);
}
device::uint count(std::size_t size) {
    return static_cast<device::uint>(size);
}

dvec3 dual(dvec3 halfEdge) {
    return halfEdge / glm::dot(halfEdge, halfEdge);
}

// ---- camera -------------------------------------------------------------------------------------

device::Camera compileCamera(const scene::Camera& camera, double aspect) {
    const dvec3 forward = glm::normalize(camera.target - camera.position);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const dvec3 up = glm::cross(right, forward);
    device::Camera packed{};
    packed.position = toFloat(camera.position);
    packed.forward = toFloat(forward);
    double halfHeight = 0.0;
    if (const auto* perspective = std::get_if<scene::Perspective>(&camera.projection)) {
        halfHeight = std::tan(0.5 * (perspective->fov / units::rad));
        if (perspective->lens) {
            const double lensRadius = 0.5 * (perspective->lens->diameter / units::m);
            packed.lensRight = toFloat(lensRadius * right);
            packed.lensUp = toFloat(lensRadius * up);
            packed.focusDistance = toFloat(perspective->lens->focusDistance / units::m);
        }
    } else {
        halfHeight = 0.5 * std::get<scene::Orthographic>(camera.projection).height;
    }
    packed.right = toFloat(halfHeight * aspect * right);
    packed.up = toFloat(halfHeight * up);
    return packed;
}

// ---- materials ----------------------------------------------------------------------------------

device::ThesisAperture compileAperture(const scene::Slits& slits, scene::Faults faults) {
    return {
        .width_um = toFloat(slits.width / units::um),
        .period_um = toFloat(slits.period / units::um),
        .count = slits.count,
        .asPrinted = faults == scene::Faults::asPrinted,
    };
}

device::Material material(device::uint kind, double value, device::uint row) {
    device::Material packed{};
    packed.kind = kind;
    packed.value = toFloat(value);
    packed.row = row;
    return packed;
}

device::Material emissive(double radiance, device::uint spectrum, bool twoSided) {
    device::Material packed = material(device::EMISSIVE, radiance, spectrum);
    packed.twoSided = twoSided ? 1 : 0;
    return packed;
}

bool isSpecular(const scene::Material& material) {
    return !std::holds_alternative<scene::Diffuse>(material.model) &&
           !std::holds_alternative<scene::Emissive>(material.model);
}

// The listing of the disc runs once per light and takes nothing of it but its colour.
dvec3 sumOfLightColors(const scene::Scene& scene) {
    dvec3 sum{0.0};
    for (const scene::Light& light : scene.lights) {
        if (!std::holds_alternative<scene::EnvironmentLight>(light.model)) sum += light.color;
    }
    return sum;
}

struct MaterialCompiler {
    const scene::Scene& scene;
    SpectralTables& tables;
    CompiledScene& out;

    device::Material operator()(const scene::Diffuse& m) const {
        const SpectralTables::Reflector reflector = tables.reflector(m.reflectance);
        return material(device::DIFFUSE, reflector.factor, reflector.row);
    }
    device::Material operator()(const scene::Conductor& m) const {
        return material(device::CONDUCTOR, 0.0, tables.metal(m.metal));
    }
    device::Material operator()(const scene::Dielectric& m) const {
        return material(device::DIELECTRIC, m.ior, 0);
    }
    device::Material operator()(const scene::Emissive& m) const {
        return emissive(m.radiance / units::W_per_m2_sr, tables.spectrum(m.spectrum), m.twoSided);
    }
    device::Material operator()(const scene::ThesisDisc& m) const {
        device::Material packed = material(device::THESIS_DISC, m.mirrorReflectance, 0);
        packed.color = toFloat(sumOfLightColors(scene));
        packed.aperture = compileAperture(m.slits, m.faults);
        return packed;
    }
    device::Material operator()(const scene::OpticalDisc& m) const {
        const SpectralTables::Reflector label = tables.reflector(m.labelReflectance);
        out.opticalDiscs.push_back(compileOpticalDisc(m, tables, out.tables));
        out.opticalDiscs.back().label = label.row;
        return material(device::OPTICAL_DISC, label.factor, count(out.opticalDiscs.size() - 1));
    }
};

// ---- shapes -------------------------------------------------------------------------------------

struct ShapeCompiler {
    CompiledScene& out;
    device::uint material;

    void operator()(const scene::Plane& s) const {
        out.planes.push_back({toFloat(s.point), toFloat(s.normal), material});
    }
    void operator()(const scene::Rectangle& s) const {
        out.rectangles.push_back({toFloat(s.center), toFloat(dual(s.u)), toFloat(dual(s.v)), material});
    }
    void operator()(const scene::Disc& s) const {
        out.discs.push_back({toFloat(s.center), toFloat(s.normal), toFloat(s.innerRadius * s.innerRadius),
                             toFloat(s.radius * s.radius), material});
    }
    void operator()(const scene::Sphere& s) const {
        out.spheres.push_back({toFloat(s.center), toFloat(s.radius), material});
    }
    void operator()(const scene::Box& s) const {
        out.boxes.push_back(
            {toFloat(s.center), toFloat(dual(s.u)), toFloat(dual(s.v)), toFloat(dual(s.w)), material});
    }
    void operator()(const scene::Cylinder& s) const {
        const double height = glm::length(s.top - s.base);
        out.cylinders.push_back({toFloat(s.base), toFloat((s.top - s.base) / height), toFloat(height),
                                 toFloat(s.radius), s.capped ? 1U : 0U, material});
    }
    void operator()(const scene::Cone& s) const {
        const double height = glm::length(s.base - s.apex);
        out.cones.push_back({toFloat(s.apex), toFloat((s.base - s.apex) / height), toFloat(height),
                             toFloat(s.radius / height), s.capped ? 1U : 0U, material});
    }
    void operator()(const scene::Triangle& s) const {
        const dvec3 edge1 = s.vertices[1] - s.vertices[0];
        const dvec3 edge2 = s.vertices[2] - s.vertices[0];
        out.triangles.push_back({toFloat(s.vertices[0]), toFloat(edge1), toFloat(edge2),
                                 toFloat(glm::normalize(glm::cross(edge1, edge2))), material});
    }
};

// ---- lights -------------------------------------------------------------------------------------

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
    const scene::Light& light;
    SpectralTables& tables;
    CompiledScene& out;

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
            out.slitGratings.push_back(compileSlits(l, *slits, light.spectrum, tables, out.tables));
        } else {
            out.openingGratings.push_back(compileOpening(l, light.spectrum, tables, out.tables));
        }
    }

private:
    void add(device::Light packed, double emission) const {
        packed.emission = toFloat(emission);
        packed.spectrum = tables.spectrum(light.spectrum);
        out.lights.push_back(packed);
    }
};

// A rectangle, disc or sphere of an emissive material lights the scene; other shapes only glow.
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

// The clear middle of an optical disc, if it has one.
std::optional<scene::Disc> clearHub(const scene::Object& object, const scene::Scene& scene) {
    const auto* disc = std::get_if<scene::OpticalDisc>(&scene.materials[object.material].model);
    const auto* shape = std::get_if<scene::Disc>(&object.shape);
    if (disc == nullptr || shape == nullptr || !disc->metal || shape->innerRadius >= disc->metalInnerRadius)
        return {};
    return scene::Disc{shape->center, shape->normal, std::min(disc->metalInnerRadius, shape->radius),
                       shape->innerRadius};
}

// Shadow casters first, so that shadow rays look at the beginning of each array alone. The shapes of area
// lights take the materials from `firstLightMaterial` on.
void addShapes(const scene::Scene& scene, device::uint firstLightMaterial, CompiledScene& out) {
    const std::vector<scene::Shape> shapes = allShapes(scene);
    const std::vector<bool> casters = shadowCasters(scene);
    std::vector<std::pair<scene::Disc, device::uint>> hubs;
    const auto addAll = [&](bool casting) {
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (casters[i] != casting) continue;
            const device::uint material = i < scene.objects.size()
                                              ? scene.objects[i].material
                                              : firstLightMaterial + count(i - scene.objects.size());
            scene::Shape shape = shapes[i];
            // A clear hub is a shape of its own, which casts no shadow.
            if (const auto hub =
                    i < scene.objects.size() ? clearHub(scene.objects[i], scene) : std::nullopt) {
                hubs.emplace_back(*hub, material);
                if (hub->radius == std::get<scene::Disc>(shape).radius) continue;
                std::get<scene::Disc>(shape).innerRadius = hub->radius;
            }
            std::visit(ShapeCompiler{out, material}, shape);
        }
    };
    addAll(true);
    out.planeCasters = count(out.planes.size());
    out.rectangleCasters = count(out.rectangles.size());
    out.discCasters = count(out.discs.size());
    out.triangleCasters = count(out.triangles.size());
    addAll(false);
    for (const auto& [hub, material] : hubs) ShapeCompiler{out, material}(hub);
    out.clearHubs = !hubs.empty();
}

bool isMetal(const scene::Material& material) {
    return std::holds_alternative<scene::Conductor>(material.model) ||
           std::holds_alternative<scene::OpticalDisc>(material.model);
}

// How much of the scene one sample stands for.
void setPixelWidth(const scene::Scene& scene, device::Frame& frame) {
    const double share = 2.0 / scene.image.height / std::sqrt(1.0 * scene.image.samples);
    if (const auto* perspective = std::get_if<scene::Perspective>(&scene.camera.projection)) {
        frame.pixelAngle = toFloat(share * std::tan(0.5 * (perspective->fov / units::rad)));
    } else {
        frame.pixelWidth =
            toFloat(0.5 * share * std::get<scene::Orthographic>(scene.camera.projection).height);
    }
}

// The colours come first in the tables; gratings, whose places are known, have written theirs already.
void addColors(const SpectralTables& tables, CompiledScene& out) {
    const std::vector<float> colors = tables.colors();
    const std::vector<float> metals = tables.metalIndices();
    const device::uint shift = count(colors.size() + metals.size());
    out.tables.insert(out.tables.begin(), metals.begin(), metals.end());
    out.tables.insert(out.tables.begin(), colors.begin(), colors.end());
    out.frame.reflectanceCount = count(tables.reflectances().size());
    out.frame.metals = count(colors.size());
    for (device::SlitGrating& grating : out.slitGratings) {
        grating.response += shift;
        grating.lines += shift;
        grating.zeroOrder += shift;
        grating.shares += shift;
    }
    for (device::OpeningGrating& grating : out.openingGratings) {
        grating.table += shift;
        grating.samples += shift;
    }
    for (device::OpticalDisc& disc : out.opticalDiscs) {
        disc.orders += shift;
        disc.scatteringShares += shift;
    }
}

// A single opening's spectrum where every surface sees the same one: then the device need not look it up.
void takeSamplesAtHand(CompiledScene& out) {
    if (out.openingGratings.size() != 1 || out.frame.reflectanceCount != 1) return;
    const device::OpeningGrating& grating = out.openingGratings.front();
    if (grating.sampleCount > device::FEW_SAMPLES || grating.sourceBlur > 0.0F) return;
    for (device::uint i = 0; i < grating.sampleCount; ++i) {
        const float* color = &out.tables[grating.samples + 3 * grating.sampleCount + 3 * i];
        out.openingSamples.push_back({out.tables[grating.samples + 3 * i], {color[0], color[1], color[2]}});
    }
}

void addCastingDiscs(const scene::Scene& scene, CompiledScene& out) {
    out.frame.castingDiscs = count(out.tables.size());
    for (const scene::Object& object : scene.objects) {
        const auto* disc = std::get_if<scene::OpticalDisc>(&scene.materials[object.material].model);
        const auto* shape = std::get_if<scene::Disc>(&object.shape);
        if (disc == nullptr || shape == nullptr || !disc->castsLight) continue;
        ++out.castingDiscs;
        for (int i = 0; i < 3; ++i) out.tables.push_back(toFloat(shape->center[i]));
        for (int i = 0; i < 3; ++i) out.tables.push_back(toFloat(shape->normal[i]));
        out.tables.push_back(toFloat(shape->radius));
        out.tables.push_back(static_cast<float>(out.materials[object.material].row));
    }
}

void addDiscSpectra(const SpectralTables& tables, CompiledScene& out) {
    out.frame.discSpectra = count(out.tables.size());
    const std::vector<float> values = discSpectra(tables);
    out.tables.insert(out.tables.end(), values.begin(), values.end());
    for (const optics::Spectrum& spectrum : tables.spectra()) {
        out.discContinuum = out.discContinuum || !spectrum.density.empty();
        out.discLines = out.discLines || !spectrum.lines.empty();
    }
}

template <class Element>
void copyFew(const std::vector<Element>& from, Element (&to)[device::FEW]) {
    if (from.size() <= device::FEW) std::copy(from.begin(), from.end(), to);
}

}  // namespace

CompiledScene compileScene(const scene::Scene& scene, Measure measure) {
    CompiledScene out;
    device::Frame& frame = out.frame;
    frame.camera = compileCamera(scene.camera, double{1.0} * scene.image.width / scene.image.height);
    frame.width = scene.image.width;
    frame.height = scene.image.height;
    frame.filmWidth = (frame.width + device::GROUP_EDGE - 1) / device::GROUP_EDGE * device::GROUP_EDGE;
    frame.seed = scene.image.seed;
    out.samples = scene.image.samples;
    out.printedFaults = scene::hasPrintedFaults(scene);
    if (std::any_of(scene.materials.begin(), scene.materials.end(), isSpecular))
        out.maxDepth = scene.image.maxDepth;

    out.isSpectrum = measure == Measure::spectrum;
    if (out.isSpectrum) frame.height = device::SPECTRAL_BANDS;
    out.inBands = out.isSpectrum || std::any_of(scene.materials.begin(), scene.materials.end(), isMetal);
    setPixelWidth(scene, frame);

    // Reflectances first: what a light needs depends on what it falls on.
    SpectralTables tables(measure, out.inBands ? device::SPECTRAL_BANDS : 1);
    for (const scene::Material& material : scene.materials) {
        out.materials.push_back(std::visit(MaterialCompiler{scene, tables, out}, material.model));
    }
    for (const scene::Object& object : scene.objects) addGlowingObject(object, scene, tables, out);
    const device::uint firstLightMaterial = count(out.materials.size());
    for (const scene::Light& light : scene.lights) std::visit(LightCompiler{light, tables, out}, light.model);
    addShapes(scene, firstLightMaterial, out);
    addColors(tables, out);
    takeSamplesAtHand(out);
    if (!out.opticalDiscs.empty()) addDiscSpectra(tables, out);
    addCastingDiscs(scene, out);
    return out;
}

device::SceneBlock sceneBlock(const CompiledScene& scene) {
    device::SceneBlock block{};
    block.frame = scene.frame;
    copyFew(scene.planes, block.planes);
    copyFew(scene.rectangles, block.rectangles);
    copyFew(scene.discs, block.discs);
    copyFew(scene.spheres, block.spheres);
    copyFew(scene.boxes, block.boxes);
    copyFew(scene.cylinders, block.cylinders);
    copyFew(scene.cones, block.cones);
    copyFew(scene.triangles, block.triangles);
    copyFew(scene.materials, block.materials);
    copyFew(scene.lights, block.lights);
    copyFew(scene.gratings, block.gratings);
    copyFew(scene.slitGratings, block.slitGratings);
    copyFew(scene.openingGratings, block.openingGratings);
    std::copy(scene.openingSamples.begin(), scene.openingSamples.end(), block.openingSamples);
    copyFew(scene.opticalDiscs, block.opticalDiscs);
    return block;
}

}  // namespace fringe::compile
