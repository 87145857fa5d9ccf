// The axes, and how far a handful of operations on them may be off.
#pragma once

#include <glm/vec3.hpp>

namespace fringe::oracle {

inline constexpr glm::dvec3 kX(1.0, 0.0, 0.0), kY(0.0, 1.0, 0.0), kZ(0.0, 0.0, 1.0);

// Some hundred roundings of values of order 1.
inline constexpr double kRounding = 1e-13;

}  // namespace fringe::oracle
