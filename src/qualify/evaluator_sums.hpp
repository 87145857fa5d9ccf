// The sums over wavelengths that the device has, as the host adds them up: in double precision, and as fast
// as a plain program can.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "qualify/cpu_sum.hpp"
#include "qualify/evaluator_probe.hpp"

namespace fringe::qualify {

// The list of waves that the device has, in double precision.
struct Waves {
    struct Wave {
        float periodHigh, periodLow, width;
        glm::dvec3 color;
    };
    double count;
    std::vector<Wave> waves;
};

// Of slits whose evaluator is a sum.
Waves wavesOf(const PreparedSlits& prepared);

// At a single u, without the undeviated light up to `undeviatedUpTo`, as the device leaves it out.
glm::dvec3 sumAt(const Waves& list, double u, double undeviatedUpTo);

CpuWaves forProcessor(const Waves& list);

}  // namespace fringe::qualify
