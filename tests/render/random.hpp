// Random numbers that are the same everywhere.
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

namespace fringe::testing {

class Random {
public:
    explicit Random(std::uint32_t seed) : generator_(seed) {}

    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(generator_()) / 4294967295.0);
    }
    bool oneIn(int times) { return between(0.0, times) < 1.0; }
    glm::dvec3 point(double extent) {
        const double x = between(-extent, extent), y = between(-extent, extent);
        return {x, y, between(-extent, extent)};
    }
    // Any, of unit length; not evenly.
    glm::dvec3 direction() { return glm::normalize(point(1.0) + glm::dvec3(1e-3)); }

private:
    std::mt19937 generator_;
};

}  // namespace fringe::testing
