// An orthonormal frame around a direction, for directions and points scattered about it.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace fringe::oracle {

struct Frame {
    glm::dvec3 x, y, z;

    // Right-handed, with the unit vector `axis` as z; how far it is turned about `axis` is arbitrary.
    static Frame around(const glm::dvec3& axis) {
        // Any vector well away from the axis will do.
        const glm::dvec3 other =
            std::abs(axis.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        const glm::dvec3 x = glm::normalize(glm::cross(other, axis));
        return {x, glm::cross(axis, x), axis};
    }

    glm::dvec3 toWorld(const glm::dvec3& local) const { return local.x * x + local.y * y + local.z * z; }
};

}  // namespace fringe::oracle
