// Doubles and sizes of the host as the device's numbers.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "compile/interface.hpp"

namespace fringe::compile {

inline float toFloat(double value) {
    return static_cast<float>(value);
}
inline device::vec3 toFloat(glm::dvec3 value) {
    return {value};
}
inline device::uint count(std::size_t size) {
    return static_cast<device::uint>(size);
}

}  // namespace fringe::compile
