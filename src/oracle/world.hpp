// The scene as the reference renderer looks at it: every surface with all it needs to be shaded, and the
// lights sorted by how they reach a surface. What emits is a surface like any other, be it an object or an
// area light.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "image/image.hpp"
#include "oracle/grating.hpp"
#include "oracle/palette.hpp"
#include "oracle/ray.hpp"
#include "oracle/shapes.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

struct Matt {
    std::size_t reflectance;  // in the palette
};

struct Mirror {
    scene::Metal metal;
};

struct Emitter {
    double radiance;
    std::size_t spectrum;  // in the palette
    bool twoSided;         // false: only from the side that the shape's normal points to
};

struct OpticalDisc {
    scene::OpticalDisc model;
    Matt label;
    optics::Curve propagatingScattering;  // oracle/disc.hpp
};

using SurfaceMaterial =
    std::variant<Matt, Mirror, scene::Dielectric, Emitter, scene::ThesisDisc, OpticalDisc>;

struct Surface {
    scene::Shape shape;
    SurfaceMaterial material;
};

// A light without extent: it reaches a point along one direction.
struct Lamp {
    std::size_t spectrum;  // in the palette
    std::variant<scene::PointLight, scene::SpotLight, scene::DirectionalLight> model;
};

struct ThesisGrating {
    Rgb color;
    scene::ThesisGrating model;
};

// What is seen where there is no surface.
struct Sky {
    double radiance;
    std::size_t spectrum;  // in the palette
};

struct World {
    Palette palette;
    std::vector<Surface> surfaces;
    std::vector<Lamp> lamps;
    std::vector<ThesisGrating> thesisGratings;
    std::vector<Grating> gratings;
    std::vector<Sky> skies;
    Rgb sumOfColors{
        0.0};  // of every light but the background: the disc of the thesis adds its pattern once per light
};

// For a film of radiance, the palette's colours are (0, 1, 0); for one of irradiance they are so too, and
// matt surfaces send back pi times what they get. Values of the thesis have no unit and are sRGB for every
// film.
World makeWorld(const scene::Scene& scene, image::Quantity quantity = image::Quantity::color);

// XYZ of the skies at the end of a path.
Xyz background(const World& world, const Throughput& throughput);

struct SurfaceHit {
    const Surface* surface;
    dvec3 position;
    dvec3 normal;  // the shape's own, as in Hit
};

std::optional<SurfaceHit> nearest(const World& world, const Ray& ray);

// Whether nothing but `light` itself stands between a surface point (with its normal) and `target`. Anything
// stops light, glass too; what ends or begins within `clearance` of `target` does not.
bool sees(const World& world, const dvec3& position, const dvec3& normal, const dvec3& target,
          const Surface* light = nullptr);

// Whether nothing lies in `direction` (unit) from a surface point.
bool seesSky(const World& world, const dvec3& position, const dvec3& normal, const dvec3& direction);

}  // namespace fringe::oracle
