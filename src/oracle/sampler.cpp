#include "oracle/sampler.hpp"

#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace fringe::oracle {
namespace {

// Finaliser of SplitMix64 (G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators",
// 2014).
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

// The top 53 bits as a fraction in [0, 1).
double fraction(std::uint64_t bits) {
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace

Dimension derived(Dimension parent, std::uint64_t number) {
    return mixed(mixed(parent) ^ number);
}

// A Feistel network permutes the smallest square power of two that holds `count`; walking on from the values
// beyond `count` leaves a permutation of the rest (J. Black, P. Rogaway, "Ciphers with arbitrary finite
// domains", 2002).
std::uint32_t permuted(std::uint32_t index, std::uint32_t count, std::uint64_t key) {
    const int halfBits = (std::bit_width(count - 1U) + 1) / 2;
    const std::uint64_t mask = (std::uint64_t{1} << halfBits) - 1U;
    std::uint64_t value = index;
    do {
        for (std::uint64_t round = 0; round < 4; ++round) {
            const std::uint64_t left = value >> halfBits;
            const std::uint64_t right = value & mask;
            value = right << halfBits | (left ^ (derived(derived(key, round), right) & mask));
        }
    } while (value >= count);
    return static_cast<std::uint32_t>(value);
}

Sampler::Sampler(std::uint32_t seed, std::uint64_t pixel, std::uint32_t index, std::uint32_t count)
    : key_(derived(seed, pixel)), index_(index), count_(count) {}

// Points of the additive recurrence with the plastic number (M. Roberts, "The unreasonable effectiveness of
// quasirandom sequences", 2018). A random shift makes each point uniform, so any mean over them is unbiased.
// A random order makes the points of one dimension independent of those of another. Folding the square's
// halves together spares an integrand the jump at the edge over which the shift wraps.
glm::dvec2 Sampler::pair(Dimension dimension) const {
    constexpr double kPlastic = 1.32471795724474602596;  // g^3 = g + 1
    constexpr glm::dvec2 kStep(1.0 / kPlastic, 1.0 / (kPlastic * kPlastic));

    if (count_ == 1) return glm::dvec2(0.5);
    const std::uint64_t key = derived(key_, dimension);
    const glm::dvec2 shift(fraction(derived(key, 0)), fraction(derived(key, 1)));
    const double number = permuted(index_, count_, derived(key, 2));
    return 1.0 - glm::abs(2.0 * glm::fract(shift + number * kStep) - 1.0);
}

glm::dvec2 onUnitDisc(const glm::dvec2& u) {
    // Squares about the middle become circles; along each, the angle advances evenly.
    const glm::dvec2 offset = 2.0 * u - 1.0;
    if (offset == glm::dvec2(0.0)) return offset;
    const bool flat = std::abs(offset.x) > std::abs(offset.y);
    const double radius = flat ? offset.x : offset.y;
    const double eighth = 0.25 * std::numbers::pi;
    const double angle =
        flat ? eighth * (offset.y / offset.x) : 2.0 * eighth - eighth * (offset.x / offset.y);
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

}  // namespace fringe::oracle
