// The scene as the reference renderer looks at it: every surface with all it needs to be shaded, and the
// lights sorted by how they reach a surface. What emits is a surface like any other, be it an object or an
// area light.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <variant>
#include <vector>

#include "oracle/ray.hpp"
#include "oracle/shapes.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

using scene::Rgb;

struct Mirror {
    std::array<std::complex<double>, 3> index;  // of the metal, per channel
};

struct Emitter {
    Rgb radiance;
    bool twoSided;  // false: only from the side that the shape's normal points to
};

using SurfaceMaterial = std::variant<scene::Diffuse, Mirror, scene::Dielectric, Emitter, scene::ThesisDisc>;

struct Surface {
    scene::Shape shape;
    SurfaceMaterial material;
};

// A light without extent: it reaches a point along one direction.
struct Lamp {
    Rgb color;
    std::variant<scene::PointLight, scene::SpotLight, scene::DirectionalLight> model;
};

struct Grating {
    Rgb color;
    scene::ThesisGrating model;
};

struct World {
    std::vector<Surface> surfaces;
    std::vector<Lamp> lamps;
    std::vector<Grating> gratings;
    Rgb background{0.0};  // radiance from where there is no surface
    Rgb sumOfColors{
        0.0};  // of every light but the background: the disc of the thesis adds its pattern once per light
};

World makeWorld(const scene::Scene& scene);

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
