#include "oracle/world.hpp"

#include <limits>
#include <numbers>

#include "oracle/emitters.hpp"
#include "oracle/metals.hpp"

namespace fringe::oracle {
namespace {

using namespace units;

// Dominant wavelengths of the sRGB primaries, where a metal's index stands for the whole channel.
constexpr std::array<Length, 3> kPrimaries{611.4 * nm, 549.1 * nm, 464.2 * nm};

SurfaceMaterial prepared(const scene::Conductor& conductor) {
    Mirror mirror;
    for (int channel = 0; channel < 3; ++channel) {
        mirror.index[channel] = refractiveIndex(conductor.metal, kPrimaries[channel]);
    }
    return mirror;
}

SurfaceMaterial prepared(const scene::Emissive& material) {
    return Emitter{material.radiance.si * material.color, material.twoSided};
}

// The others are used as the scene has them.
template <class Material>
SurfaceMaterial prepared(const Material& material) {
    return material;
}

// Puts one light, of any kind, where it belongs in the world.
class LightSorter {
public:
    LightSorter(World& world, const Rgb& color) : world_(world), color_(color) {}

    void operator()(const scene::PointLight& light) { addLamp(light); }
    void operator()(const scene::SpotLight& light) { addLamp(light); }
    void operator()(const scene::DirectionalLight& light) { addLamp(light); }
    void operator()(const scene::EnvironmentLight& light) { world_.background += light.radiance.si * color_; }
    void operator()(const scene::ThesisGrating& light) {
        world_.gratings.push_back({color_, light});
        world_.sumOfColors += color_;
    }
    void operator()(const scene::AreaLight& light) {
        std::visit(
            [&](const auto& shape) {
                const double radiance = light.power.si / (std::numbers::pi * area(shape));
                world_.surfaces.push_back({shape, Emitter{radiance * color_, light.twoSided}});
            },
            light.shape);
        world_.sumOfColors += color_;
    }

private:
    template <class Model>
    void addLamp(const Model& light) {
        world_.lamps.push_back({color_, light});
        world_.sumOfColors += color_;
    }

    World& world_;
    Rgb color_;
};

bool blocked(const World& world, const Ray& ray, double distance, const Surface* light) {
    for (const Surface& surface : world.surfaces) {
        if (&surface == light) continue;
        const std::optional<Hit> hit = intersect(ray, surface.shape);
        if (hit && hit->distance < distance) return true;
    }
    return false;
}

}  // namespace

World makeWorld(const scene::Scene& scene) {
    World world;
    for (const scene::Object& object : scene.objects) {
        const auto material =
            std::visit([](const auto& m) { return prepared(m); }, scene.materials[object.material].model);
        world.surfaces.push_back({object.shape, material});
    }
    for (const scene::Light& light : scene.lights) std::visit(LightSorter(world, light.color), light.model);
    return world;
}

std::optional<SurfaceHit> nearest(const World& world, const Ray& ray) {
    std::optional<SurfaceHit> found;
    double distance = std::numeric_limits<double>::infinity();
    for (const Surface& surface : world.surfaces) {
        const std::optional<Hit> hit = intersect(ray, surface.shape);
        if (!hit || hit->distance >= distance) continue;
        distance = hit->distance;
        found = SurfaceHit{&surface, ray.at(distance), hit->normal};
    }
    return found;
}

bool sees(const World& world, const dvec3& position, const dvec3& normal, const dvec3& target,
          const Surface* light) {
    const dvec3 start = liftOff(position, normal, target - position);
    const double distance = glm::length(target - start);
    return !blocked(world, {start, (target - start) / distance}, distance - clearance(target), light);
}

bool seesSky(const World& world, const dvec3& position, const dvec3& normal, const dvec3& direction) {
    const Ray ray{liftOff(position, normal, direction), direction};
    return !blocked(world, ray, std::numeric_limits<double>::infinity(), nullptr);
}

}  // namespace fringe::oracle
