// Scene -> CompiledScene: doubles become floats, powers become intensities and radiances, variants become
// records.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "compile/casters.hpp"
#include "compile/compiled_scene.hpp"
#include "compile/metals.hpp"

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

    device::Material operator()(const scene::Diffuse& m) const {
        return {.kind = device::DIFFUSE, .color = toFloat(m.reflectance), .second = {}, .aperture = {}};
    }
    device::Material operator()(const scene::Conductor& m) const {
        const ComplexIndex index = metalIndex(m.metal);
        return {
            .kind = device::CONDUCTOR, .color = toFloat(index.n), .second = toFloat(index.k), .aperture = {}};
    }
    device::Material operator()(const scene::Dielectric& m) const {
        return {.kind = device::DIELECTRIC, .color = toFloat(dvec3(m.ior)), .second = {}, .aperture = {}};
    }
    device::Material operator()(const scene::Emissive& m) const {
        return {.kind = device::EMISSIVE,
                .color = toFloat(m.radiance / units::W_per_m2_sr * m.color),
                .second = {m.twoSided ? 1.0F : 0.0F, 0.0F, 0.0F},
                .aperture = {}};
    }
    device::Material operator()(const scene::ThesisDisc& m) const {
        return {.kind = device::THESIS_DISC,
                .color = toFloat(sumOfLightColors(scene)),
                .second = {toFloat(m.mirrorReflectance), 0.0F, 0.0F},
                .aperture = compileAperture(m.slits, m.faults)};
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

void addEmitter(EmitterGeometry emitter, dvec3 radiance, bool twoSided, CompiledScene& out) {
    emitter.light.emission = toFloat(radiance);
    emitter.light.twoSided = twoSided ? 1 : 0;
    out.lights.push_back(emitter.light);
}

struct LightCompiler {
    const dvec3& color;
    CompiledScene& out;

    void operator()(const scene::PointLight& l) const {
        device::Light light{};
        light.kind = device::POINT_LIGHT;
        light.position = toFloat(l.position);
        light.emission = toFloat(l.power / units::W / (4.0 * pi) * color);
        out.lights.push_back(light);
    }
    // The smoothstep between the two cosines holds half of its width's solid angle.
    void operator()(const scene::SpotLight& l) const {
        const double outer = std::cos(l.angle / units::rad);
        const double inner = std::cos(l.innerAngle / units::rad);
        const double solidAngle = 2.0 * pi * (1.0 - 0.5 * (outer + inner));
        device::Light light{};
        light.kind = device::SPOT_LIGHT;
        light.position = toFloat(l.position);
        light.direction = toFloat(l.direction);
        light.emission = toFloat(l.power / units::W / solidAngle * color);
        light.cosOuter = toFloat(outer);
        light.cosInner = toFloat(inner);
        out.lights.push_back(light);
    }
    void operator()(const scene::DirectionalLight& l) const {
        device::Light light{};
        light.kind = device::DIRECTIONAL_LIGHT;
        light.direction = toFloat(l.direction);
        light.emission = toFloat(l.irradiance / units::W_per_m2 * color);
        out.lights.push_back(light);
    }
    // A Lambertian emitter: radiance = power / (pi area).
    void operator()(const scene::AreaLight& l) const {
        std::visit(
            [&](const auto& shape) {
                const EmitterGeometry emitter = emitterGeometry(shape);
                const dvec3 radiance = l.power / units::W / (pi * emitter.area) * color;
                addEmitter(emitter, radiance, l.twoSided, out);
                out.materials.push_back({.kind = device::EMISSIVE,
                                         .color = toFloat(radiance),
                                         .second = {l.twoSided ? 1.0F : 0.0F, 0.0F, 0.0F},
                                         .aperture = {}});
            },
            l.shape);
    }
    void operator()(const scene::EnvironmentLight& l) const {
        device::Light light{};
        light.kind = device::ENVIRONMENT_LIGHT;
        light.emission = toFloat(l.radiance / units::W_per_m2_sr * color);
        out.frame.environment = light.emission;
        out.lights.push_back(light);
    }
    void operator()(const scene::ThesisGrating& l) const {
        const double radius = 0.5 * (l.beamDiameter / units::m);
        out.gratings.push_back({.position = toFloat(l.position),
                                .normal = toFloat(l.normal),
                                .across = toFloat(glm::cross(l.normal, l.slitDirection)),
                                .slitDirection = toFloat(l.slitDirection),
                                .radius = toFloat(radius),
                                .attenuation = l.attenuated ? toFloat(1.0 / (radius * radius)) : 0.0F,
                                .color = toFloat(l.power / units::W * color),
                                .aperture = compileAperture(l.slits, l.faults)});
    }
};

// A rectangle, disc or sphere of an emissive material lights the scene; other shapes only glow.
void addGlowingObject(const scene::Object& object, const scene::Scene& scene, CompiledScene& out) {
    const auto* emissive = std::get_if<scene::Emissive>(&scene.materials[object.material].model);
    if (emissive == nullptr) return;
    const dvec3 radiance = emissive->radiance / units::W_per_m2_sr * emissive->color;
    std::visit(
        [&](const auto& shape) {
            if constexpr (requires { emitterGeometry(shape); }) {
                addEmitter(emitterGeometry(shape), radiance, emissive->twoSided, out);
            }
        },
        object.shape);
}

// Shadow casters first, so that shadow rays look at the beginning of each array alone. The shapes of area
// lights take the materials from `firstLightMaterial` on.
void addShapes(const scene::Scene& scene, device::uint firstLightMaterial, CompiledScene& out) {
    const std::vector<scene::Shape> shapes = allShapes(scene);
    const std::vector<bool> casters = shadowCasters(scene);
    const auto addAll = [&](bool casting) {
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (casters[i] != casting) continue;
            const device::uint material = i < scene.objects.size()
                                              ? scene.objects[i].material
                                              : firstLightMaterial + count(i - scene.objects.size());
            std::visit(ShapeCompiler{out, material}, shapes[i]);
        }
    };
    addAll(true);
    out.planeCasters = count(out.planes.size());
    out.rectangleCasters = count(out.rectangles.size());
    out.discCasters = count(out.discs.size());
    out.triangleCasters = count(out.triangles.size());
    addAll(false);
}

template <class Element>
void copyFew(const std::vector<Element>& from, Element (&to)[device::FEW]) {
    if (from.size() <= device::FEW) std::copy(from.begin(), from.end(), to);
}

}  // namespace

CompiledScene compileScene(const scene::Scene& scene) {
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

    for (const scene::Material& material : scene.materials) {
        out.materials.push_back(std::visit(MaterialCompiler{scene}, material.model));
    }
    for (const scene::Object& object : scene.objects) addGlowingObject(object, scene, out);
    const device::uint firstLightMaterial = count(out.materials.size());
    for (const scene::Light& light : scene.lights) std::visit(LightCompiler{light.color, out}, light.model);
    addShapes(scene, firstLightMaterial, out);

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
    return block;
}

}  // namespace fringe::compile
