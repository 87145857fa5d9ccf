#include "oracle/world.hpp"

#include <limits>
#include <numbers>

#include "oracle/disc.hpp"
#include "oracle/emitters.hpp"

namespace fringe::oracle {
namespace {

// Puts the scene's materials and lights, of any kind, where they belong in the world.
class Maker {
public:
    Maker(World& world, image::Quantity quantity) : world_(world), quantity_(quantity) {}

    SurfaceMaterial operator()(const scene::Diffuse& material) const {
        if (quantity_ != image::Quantity::irradiance)
            return Matt{world_.palette.addReflectance(material.reflectance)};
        return Matt{
            world_.palette.addReflectance({{kFirst_nm, std::numbers::pi}, {kLast_nm, std::numbers::pi}})};
    }
    SurfaceMaterial operator()(const scene::Conductor& material) const { return Mirror{material.metal}; }
    SurfaceMaterial operator()(const scene::Dielectric& material) const { return material; }
    SurfaceMaterial operator()(const scene::Emissive& material) const {
        return Emitter{material.radiance.si, world_.palette.addSpectrum(material.spectrum),
                       material.twoSided};
    }
    SurfaceMaterial operator()(const scene::ThesisDisc& material) const { return material; }
    SurfaceMaterial operator()(const scene::OpticalDisc& material) const {
        return OpticalDisc{material, std::get<Matt>((*this)(scene::Diffuse{material.labelReflectance})),
                           propagatingScattering(material)};
    }

    void add(const scene::Light& light) {
        std::visit([&](const auto& model) { add(light, model); }, light.model);
    }

private:
    template <class Lamp>
    void add(const scene::Light& light, const Lamp& lamp) {
        world_.lamps.push_back({world_.palette.addSpectrum(light.spectrum), lamp});
        world_.sumOfColors += light.color;
    }
    void add(const scene::Light& light, const scene::EnvironmentLight& sky) {
        world_.skies.push_back({sky.radiance.si, world_.palette.addSpectrum(light.spectrum)});
    }
    void add(const scene::Light& light, const scene::ThesisGrating& grating) {
        world_.thesisGratings.push_back({light.color, grating});
        world_.sumOfColors += light.color;
    }
    void add(const scene::Light& light, const scene::Grating& grating) {
        world_.gratings.emplace_back(grating, light.spectrum);
        world_.sumOfColors += light.color;
    }
    void add(const scene::Light& light, const scene::AreaLight& lamp) {
        const std::size_t spectrum = world_.palette.addSpectrum(light.spectrum);
        std::visit(
            [&](const auto& shape) {
                const double radiance = lamp.power.si / (std::numbers::pi * area(shape));
                world_.surfaces.push_back({shape, Emitter{radiance, spectrum, lamp.twoSided}});
            },
            lamp.shape);
        world_.sumOfColors += light.color;
    }

    World& world_;
    image::Quantity quantity_;
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

World makeWorld(const scene::Scene& scene, image::Quantity quantity) {
    const bool radiant = quantity == image::Quantity::radiance || quantity == image::Quantity::irradiance;
    World world;
    world.palette = Palette(radiant ? radiantResponse : filmResponse);
    Maker maker(world, quantity);
    std::vector<SurfaceMaterial> materials;
    for (const scene::Material& material : scene.materials)
        materials.push_back(std::visit(maker, material.model));
    for (const scene::Object& object : scene.objects)
        world.surfaces.push_back({object.shape, materials[object.material]});
    for (const scene::Light& light : scene.lights) maker.add(light);
    return world;
}

Xyz background(const World& world, const Throughput& throughput) {
    Xyz sum(0.0);
    for (const Sky& sky : world.skies)
        sum += sky.radiance * world.palette.color(sky.spectrum, Palette::kWhite, throughput);
    return sum;
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
