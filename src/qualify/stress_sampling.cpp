// Samples, camera rays and colours.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "optics/color.hpp"
#include "oracle/frame.hpp"
#include "oracle/sampler.hpp"
#include "qualify/cases.hpp"
#include "shaders/stress_sampling.comp.h"

namespace fringe::qualify {
namespace {

using glm::dvec2;
using glm::dvec3;
using Inputs = std::span<const float>;

// The worst of several results.
Judgement worst(std::initializer_list<Judgement> all) {
    return *std::max_element(all.begin(), all.end(),
                             [](const Judgement& a, const Judgement& b) { return a.error < b.error; });
}

// Of a vector, relative to `scale`.
Judgement comparedVector(Inputs got, std::size_t i, const dvec3& expected, double scale) {
    Judgement result{};
    for (int k = 0; k < 3; ++k) {
        Judgement one = compared(got[i + static_cast<std::size_t>(k)], expected[k]);
        one.error /= scale;
        if (k == 0 || one.error > result.error) result = one;
    }
    return result;
}

// ---- the sampler, by the definition of Sobol's sequence
// ------------------------------------------------------

std::uint32_t reversed(std::uint32_t x) {
    std::uint32_t result = 0;
    for (int i = 0; i < 32; ++i) result |= (x >> i & 1U) << (31 - i);
    return result;
}

// Direction numbers of the second dimension: each is the last one, plus the same shifted by one (P. Bratley,
// B. Fox, "Algorithm 659", 1988, with the polynomial x + 1).
std::uint32_t sobolSecond(std::uint32_t index) {
    std::uint32_t result = 0, direction = 0x80000000U;
    for (; index != 0; index >>= 1, direction ^= direction >> 1)
        if ((index & 1U) != 0) result ^= direction;
    return result;
}

std::uint32_t hashed(std::uint32_t x) {
    x = (x ^ x >> 16) * 0x7feb352dU;
    x = (x ^ x >> 15) * 0x846ca68bU;
    return x ^ x >> 16;
}

// An Owen scrambling, as a hash in which each bit depends on those before it alone.
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x = reversed(x) + seed;
    for (const std::uint32_t factor : {0x6c50b47cU, 0xb82f1e52U, 0xc7afe638U, 0x8d22f6e6U}) x ^= x * factor;
    return reversed(x);
}

dvec2 samplePair(std::uint32_t pixelSeed, std::uint32_t index, std::uint32_t dimension) {
    const std::uint32_t seed = hashed(pixelSeed ^ (dimension + (pixelSeed << 6) + (pixelSeed >> 2)));
    const std::uint32_t shuffled = scrambled(index, seed);
    const std::uint32_t x = scrambled(reversed(shuffled), hashed(seed ^ 0x5bd1e995U));
    const std::uint32_t y = scrambled(sobolSecond(shuffled), hashed(seed ^ 0x27d4eb2fU));
    return dvec2(x >> 8, y >> 8) * 0x1p-24;
}

void drawSeed(Draw& draw, std::span<float> inputs) {
    inputs[0] = static_cast<float>(draw.below(1U << 16));
    inputs[1] = static_cast<float>(draw.below(1U << 16));
}
std::uint32_t seedOf(Inputs in) {
    return static_cast<std::uint32_t>(in[0]) << 16 | static_cast<std::uint32_t>(in[1]);
}

void drawPair(Draw& draw, std::span<float> inputs) {
    drawSeed(draw, inputs);
    inputs[2] = static_cast<float>(draw.oneIn(2) ? draw.below(64) : draw.below(1U << 24));
    inputs[3] = static_cast<float>(draw.below(1000));
}

Judgement judgePair(Inputs in, Inputs results) {
    const dvec2 expected =
        samplePair(seedOf(in), static_cast<std::uint32_t>(in[2]), static_cast<std::uint32_t>(in[3]));
    return worst({compared(results[0], expected.x), compared(results[1], expected.y)});
}

// ---- directions
// ---------------------------------------------------------------------------------------------

double anyShare(Draw& draw) {
    return draw.oneIn(4) ? draw.among<4>({0.0, 0.5, 0x1p-24, 1.0 - 0x1p-24}) : draw.unit();
}

void drawRing(Draw& draw, std::span<float> inputs) {
    inputs[0] = static_cast<float>(anyShare(draw));
    inputs[1] = static_cast<float>(draw.oneIn(8) ? inputs[0] : anyShare(draw));
    inputs[2] = static_cast<float>(draw.oneIn(2) ? 0.0 : anyShare(draw));
}

Judgement judgeRing(Inputs in, Inputs results) {
    const dvec2 full = oracle::onUnitDisc(dvec2(in[0], in[1]));
    const double radius = glm::length(full);
    const double onRing = std::sqrt(in[2] + (1.0 - in[2]) * radius * radius);
    const dvec2 expected = radius > 0.0 ? full * (onRing / radius) : full;
    return worst({compared(results[0], expected.x), compared(results[1], expected.y)});
}

// About the poles, where one or the other branch divides by next to nothing.
dvec3 anyOrPole(Draw& draw) {
    if (draw.oneIn(2)) return draw.direction();
    const double tilt = draw.oneIn(4) ? 0.0 : draw.magnitude(1e-38, 0.1);
    return glm::normalize(dvec3(tilt * draw.between(-1.0, 1.0), tilt * draw.between(-1.0, 1.0), draw.sign()));
}

void drawFrame(Draw& draw, std::span<float> inputs) {
    put(inputs, 0, anyOrPole(draw));
}

Judgement judgeFrame(Inputs in, Inputs results) {
    const dvec3 n = at(in, 0), t = at(results, 0), b = at(results, 3);
    double error = glm::length(glm::cross(t, b) - n);
    for (const double off :
         {glm::dot(t, t) - 1.0, glm::dot(b, b) - 1.0, glm::dot(t, b), glm::dot(t, n), glm::dot(b, n)})
        error = std::max(error, std::abs(off));
    return {error, error * 0x1p23, error, 0.0};
}

// From the point to the light's middle, the point's normal, two random numbers, the light's radius.
void drawSphereLight(Draw& draw, std::span<float> inputs) {
    const double distance = draw.magnitude(1e-3, 1e3);
    put(inputs, 0, distance * draw.direction());
    put(inputs, 3, draw.direction());
    inputs[6] = static_cast<float>(anyShare(draw));
    inputs[7] = static_cast<float>(anyShare(draw));
    inputs[8] = static_cast<float>(distance * (draw.oneIn(4) ? 1.0 - draw.sign() * draw.magnitude(1e-7, 0.1)
                                                             : draw.magnitude(1e-6, 30.0)));
}

// The way has to end on the light, relative to its distance and radius, and bring what its share of the solid
// angle, or of the surface from inside, brings.
Judgement judgeSphereLight(Inputs in, Inputs results) {
    const dvec3 offset = at(in, 0), normal = at(in, 3), direction = at(results, 0);
    const double radius = in[8], distance = results[3], square = glm::dot(offset, offset);
    const double scale = std::max(std::sqrt(square), radius);
    const dvec3 place = distance * direction - offset;
    Judgement place_ = compared(static_cast<float>(glm::length(place)), radius);
    place_.error = std::abs(glm::length(place) - radius) / scale;
    const double facing = std::max(glm::dot(direction, normal), 0.0);
    const double share = std::min(radius * radius / square, 1.0);
    const double cap = 2.0 * std::numbers::pi * (1.0 - std::sqrt(1.0 - share));
    const double whole = 4.0 * std::numbers::pi * radius * radius / (distance * distance);
    Judgement outside = compared(results[4], cap * facing);
    outside.error /= cap;
    Judgement inside = compared(results[4], whole * facing * std::abs(glm::dot(direction, place)) / radius);
    inside.error /= whole;
    // On the surface either is as good.
    const double beyond = square - radius * radius;
    if (std::abs(beyond) < 1e-6 * square) return inside.error < outside.error ? inside : outside;
    return worst({place_, beyond > 0.0 ? outside : inside});
}

// Seed and sample, place in the picture, camera.
void drawCamera(Draw& draw, std::span<float> inputs) {
    drawSeed(draw, inputs);
    inputs[2] = static_cast<float>(draw.below(1U << 20));
    inputs[3] = static_cast<float>(draw.between(0.0, 1000.0));
    inputs[4] = static_cast<float>(draw.between(0.0, 1000.0));
    const double size = draw.magnitude(1e-6, 1e6), focus = size * draw.magnitude(1e-2, 1e2);
    const oracle::Frame frame = oracle::Frame::around(draw.direction());
    const double open = draw.magnitude(1e-3, 10.0), lens = focus * draw.magnitude(1e-8, 0.3);
    put(inputs, 5, size * draw.direction());
    put(inputs, 8, frame.z);
    put(inputs, 11, open * frame.x);
    put(inputs, 14, open * draw.between(0.1, 1.0) * frame.y);
    put(inputs, 17, lens * frame.x);
    put(inputs, 20, lens * frame.y);
    inputs[23] = static_cast<float>(focus);
}

Judgement judgeCamera(Inputs in, Inputs results) {
    const dvec2 lens = oracle::onUnitDisc(samplePair(seedOf(in), static_cast<std::uint32_t>(in[2]), 1));
    const dvec3 fromCenter = lens.x * at(in, 17) + lens.y * at(in, 20);
    const dvec3 onPlane = (in[3] / 500.0 - 1.0) * at(in, 11) + (1.0 - in[4] / 500.0) * at(in, 14);
    const dvec3 origin = at(in, 5) + fromCenter;
    const dvec3 direction = glm::normalize(double{in[23]} * (at(in, 8) + onPlane) - fromCenter);
    return worst({comparedVector(results, 0, origin, glm::length(at(in, 5)) + glm::length(at(in, 17))),
                  comparedVector(results, 3, direction, 1.0)});
}

// ---- colour
// -------------------------------------------------------------------------------------------------

// At a band's middle, beside it, and beyond the first and the last.
void drawWavelength(Draw& draw, std::span<float> inputs) {
    inputs[0] = static_cast<float>(draw.oneIn(3) ? 0.4 + 0.0025 * draw.below(121) : draw.between(0.38, 0.78));
}

// Linear between the middles, of the middles themselves: the wavelength, or the range's end.
Judgement judgeWavelength(Inputs in, Inputs results) {
    return compared(results[0], std::clamp(double{in[0]}, 0.4, 0.7));
}

void drawColor(Draw& draw, std::span<float> inputs) {
    for (float& channel : inputs)
        channel = static_cast<float>(draw.oneIn(8) ? 0.0 : draw.magnitude(1e-40, 1.0));
}

Judgement judgeColor(Inputs in, Inputs results) {
    static const glm::dmat3 matrix = optics::xyzFromLinearSrgb();
    return comparedVector(results, 0, matrix * at(in, 0), 1.0);
}

}  // namespace

std::vector<StressCase> samplingCases() {
    const std::span<const std::uint32_t> shader(stress_sampling_comp);
    return {
        {"sample",
         "samplePair, sampler.glsl",
         0.0,
         "whole numbers",
         shader,
         0,
         {"seed_high", "seed_low", "index", "dimension"},
         2,
         drawPair,
         judgePair,
         kFullCount},
        {"ring-sample",
         "sampleRing, lights.glsl",
         0x1p-11,
         "what Vulkan allows of sine and cosine",
         shader,
         1,
         {"x", "y", "inner_squared"},
         2,
         drawRing,
         judgeRing,
         kFullCount},
        {"frame",
         "completeFrame, lights.glsl",
         1e-6,
         "a dozen roundings",
         shader,
         2,
         {"nx", "ny", "nz"},
         6,
         drawFrame,
         judgeFrame,
         kFullCount},
        {"sphere-light",
         "fromSphere, lights.glsl",
         0x1p-11,
         "what Vulkan allows of sine and cosine",
         shader,
         3,
         {"x", "y", "z", "nx", "ny", "nz", "random_x", "random_y", "radius"},
         5,
         drawSphereLight,
         judgeSphereLight,
         kFullCount},
        {"camera",
         "cameraRay, camera.glsl",
         0x1p-11,
         "what Vulkan allows of sine and cosine, on the lens",
         shader,
         4,
         {"seed_high",
          "seed_low",
          "index",
          "place_x",
          "place_y",
          "x",
          "y",
          "z",
          "forward_x",
          "forward_y",
          "forward_z",
          "right_x",
          "right_y",
          "right_z",
          "up_x",
          "up_y",
          "up_z",
          "lens_right_x",
          "lens_right_y",
          "lens_right_z",
          "lens_up_x",
          "lens_up_y",
          "lens_up_z",
          "focus"},
         6,
         drawCamera,
         judgeCamera,
         kFullCount},
        {"band",
         "throughputAt, spectral.glsl",
         1e-6,
         "the last band is reached to a hundred-thousandth of 12.5 nm, 1.3e-7 um; roundings",
         shader,
         5,
         {"wavelength"},
         1,
         drawWavelength,
         judgeWavelength,
         kFullCount},
        {"srgb",
         "xyzFromLinearSrgb, spectral.glsl",
         5e-7,
         "half a dozen roundings",
         shader,
         6,
         {"r", "g", "b"},
         3,
         drawColor,
         judgeColor,
         kFullCount},
    };
}

}  // namespace fringe::qualify
