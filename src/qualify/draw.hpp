// Random numbers for one evaluation: they depend on the seed and the evaluation's number alone, so any of
// them can be had again, in any order and by any thread.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "oracle/sampler.hpp"

namespace fringe::qualify {

class Draw {
public:
    Draw(std::uint64_t seed, std::uint64_t number) : key_(oracle::derived(seed, number)) {}

    std::uint64_t bits() { return oracle::derived(key_, next_++); }
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  // in [0, 1)
    double between(double low, double high) { return low + (high - low) * unit(); }
    std::uint32_t below(std::uint32_t end) {
        return static_cast<std::uint32_t>(((bits() >> 32) * std::uint64_t{end}) >> 32);
    }
    bool oneIn(std::uint32_t times) { return below(times) == 0; }
    double sign() { return oneIn(2) ? -1.0 : 1.0; }

    // Any order of magnitude between the two, both > 0, equally often.
    double magnitude(double low, double high) { return std::exp2(between(std::log2(low), std::log2(high))); }

    template <std::size_t Size>
    double among(const std::array<double, Size>& values) {
        return values[below(Size)];
    }

    // Uniform on the sphere.
    glm::dvec3 direction() {
        const double z = between(-1.0, 1.0), angle = between(0.0, 6.283185307179586);
        const double ring = std::sqrt(1.0 - z * z);
        return {ring * std::cos(angle), ring * std::sin(angle), z};
    }

private:
    std::uint64_t key_;
    std::uint64_t next_ = 0;
};

// Vectors among the numbers that an evaluation gets or gives.
inline glm::dvec3 at(std::span<const float> numbers, std::size_t i) {
    return {numbers[i], numbers[i + 1], numbers[i + 2]};
}
inline void put(std::span<float> numbers, std::size_t i, const glm::dvec3& v) {
    for (int k = 0; k < 3; ++k) numbers[i + static_cast<std::size_t>(k)] = static_cast<float>(v[k]);
}

}  // namespace fringe::qualify
