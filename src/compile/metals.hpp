// Complex refractive indices of metals for a renderer of three colours.
#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace fringe::compile {

struct ComplexIndex {
    glm::dvec3 n;
    glm::dvec3 k;
};

// n and k for red, green and blue: the tables of third_party/metals, interpolated linearly at the dominant
// wavelengths of the sRGB primaries (611.4, 549.1 and 464.2 nm).
ComplexIndex metalIndex(scene::Metal metal);

}  // namespace fringe::compile
