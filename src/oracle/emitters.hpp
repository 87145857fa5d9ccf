// Points on the shapes that can light a scene.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "oracle/ray.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

// A point of an emitting surface that stands for `solidAngle` (steradian) of an observer's view: with
// radiance L the mean of L * solidAngle * cosine over all samples is the irradiance.
struct EmitterPoint {
    dvec3 position;
    double solidAngle;  // > 0
};

// Of one side, square metres.
double area(const scene::Rectangle& rectangle);
double area(const scene::Disc& disc);
double area(const scene::Sphere& sphere);

// A point of `shape` that shines on `observer` if nothing is in the way; `u` is uniform in [0, 1]^2, and
// (0.5, 0.5) gives the middle. Nothing if `observer` is behind a shape that shines from its front alone, and
// for shapes that do not light the scene: all but rectangle, disc and sphere.
std::optional<EmitterPoint> pointOn(const scene::Shape& shape, bool twoSided, const dvec3& observer,
                                    const glm::dvec2& u);

}  // namespace fringe::oracle
