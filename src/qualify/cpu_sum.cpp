#include "qualify/cpu_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fringe::qualify {

void cpuSum(const CpuWaves& waves, std::span<const float> u, std::span<float> xyz) {
    constexpr float kPi = 3.14159265F, kLeast = 1e-12F;
    const std::size_t size = waves.period.size();
    const float* const period = waves.period.data();
    const float* const width = waves.width.data();
    const float* const xs = waves.x.data();
    const float* const ys = waves.y.data();
    const float* const zs = waves.z.data();
    for (std::size_t i = 0; i < u.size(); ++i) {
        float x = 0.0F, y = 0.0F, z = 0.0F;
        for (std::size_t k = 0; k < size; ++k) {
            // Off 0 by less than counts, so that no quotient is 0/0.
            const float turns = u[i] * period[k];
            const float past = std::abs(turns - std::nearbyint(turns)) + kLeast;
            const float slit = std::abs(u[i] * width[k]) + kLeast;
            const float many = std::sin(kPi * waves.count * past) / (waves.count * std::sin(kPi * past));
            const float single = std::sin(kPi * slit) / (kPi * slit);
            const float value = many * many * single * single;
            x += value * xs[k];
            y += value * ys[k];
            z += value * zs[k];
        }
        xyz[3 * i] = x;
        xyz[3 * i + 1] = y;
        xyz[3 * i + 2] = z;
    }
}

}  // namespace fringe::qualify
