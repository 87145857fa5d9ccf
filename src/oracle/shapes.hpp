// Where a ray first meets a shape: plain Euclidean geometry, one shape at a time.
#pragma once

#include <optional>

#include "oracle/ray.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

struct Hit {
    double distance;  // along the ray, > 0
    dvec3
        normal;  // unit; the shape's own, whichever side the ray comes from: outward for sphere, box,
                 // cylinder and cone (open ones too), u x v for a rectangle, counter-clockwise for a triangle
};

// The nearest point of `shape` in front of the ray's origin.
std::optional<Hit> intersect(const Ray& ray, const scene::Shape& shape);

}  // namespace fringe::oracle
