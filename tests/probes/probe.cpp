#include "probes/probe.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "gpu/kernel.hpp"
#include "shaders/aperture_probe.comp.h"
#include "wanted_device.hpp"

namespace fringe::testing {
namespace {

template <class Value>
gpu::Buffer uploaded(const gpu::Device& device, std::span<const Value> values) {
    gpu::Buffer buffer(device, values.size_bytes(), gpu::Access::hostWrites);
    std::memcpy(buffer.mapped().data(), values.data(), values.size_bytes());
    return buffer;
}

}  // namespace

std::vector<float> evaluate(Probe probe, std::span<const float> parameters,
                            std::span<const glm::vec2> directions) {
    static const gpu::Device device({.selector = wantedDevice(), .validation = true});
    const std::size_t messagesBefore = device.validationMessages().size();
    const gpu::Buffer in = uploaded(device, parameters);
    const gpu::Buffer at = uploaded(device, directions);
    const gpu::Buffer out(device, directions.size() * sizeof(float), gpu::Access::hostReads);
    const auto storage = vk::DescriptorType::eStorageBuffer;
    const std::array bindings{gpu::Binding{storage, in.handle(), 0, in.size()},
                              gpu::Binding{storage, at.handle(), 0, at.size()},
                              gpu::Binding{storage, out.handle(), 0, out.size()}};
    const auto pattern = static_cast<std::uint32_t>(probe);
    const gpu::Groups first{0, 0, 0};
    const gpu::Groups groups{static_cast<std::uint32_t>(directions.size() / 64 + 1), 1, 1};
    gpu::Kernel(device, aperture_probe_comp, bindings, {&pattern, 1}).run({&first, 1}, groups);
    const std::vector<std::string> messages = device.validationMessages();
    for (std::size_t i = messagesBefore; i < messages.size(); ++i)
        ADD_FAILURE() << "validation: " << messages[i];
    std::vector<float> results(directions.size());
    std::memcpy(results.data(), out.mapped().data(), out.size());
    return results;
}

TwoFloats split(double value) {
    const auto high = static_cast<float>(value);
    return {high, static_cast<float>(value - double{high})};
}

void expectNear(std::span<const float> results, std::span<const double> expected,
                std::span<const glm::vec2> directions, double bound) {
    double largest = 0.0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        ASSERT_TRUE(std::isfinite(results[i])) << directions[i].x << ' ' << directions[i].y;
        const double error = std::abs(results[i] - expected[i]);
        if (error > largest) {
            largest = error;
            worst = i;
        }
    }
    EXPECT_LE(largest, bound) << results[worst] << " for " << expected[worst] << " at " << directions[worst].x
                              << ' ' << directions[worst].y;
}

std::vector<glm::vec2> directionsInTwoDimensions(double sizeInWaves) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> uniform(-2.0F, 2.0F);
    const auto peak = static_cast<float>(3.0 / sizeInWaves);
    std::vector<glm::vec2> directions{{0, 0},           {1e-30F, 0},    {0, -1e-30F}, {1e-38F, 1e-38F},
                                      {1e-20F, 3e-16F}, {1e-9F, 1e-9F}, {1.0F, 0.0F}, {0.0F, -1.0F},
                                      {2.0F, 0.0F},     {0.0F, 2.0F}};
    while (directions.size() < 10'000) {
        const float x = uniform(random), y = uniform(random);
        directions.emplace_back(x, y);
        directions.emplace_back(peak * x, peak * y);
        directions.emplace_back(x, 0.0F);
        directions.emplace_back(1e-3F * peak * x, y);
        directions.emplace_back(x, std::abs(x) / 3.0F);
    }
    return directions;
}

}  // namespace fringe::testing
