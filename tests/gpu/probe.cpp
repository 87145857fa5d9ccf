#include "gpu/probe.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <string>

#include "gpu/kernel.hpp"
#include "wanted_device.hpp"

namespace fringe::testing {

std::vector<std::uint32_t> runProbe(std::span<const std::uint32_t> spirv, std::span<const std::byte> uniforms,
                                    const std::vector<std::uint32_t>& constants, std::size_t words) {
    std::vector<std::uint32_t> result(words);
    const gpu::Device device({.selector = wantedDevice(), .validation = true});
    const gpu::Buffer in(device, uniforms.size(), gpu::Access::hostWrites);
    const gpu::Buffer out(device, words * sizeof(std::uint32_t), gpu::Access::hostReads);
    std::memcpy(in.mapped().data(), uniforms.data(), uniforms.size());
    const std::array bindings{gpu::Binding{vk::DescriptorType::eUniformBuffer, in.handle(), 0, in.size()},
                              gpu::Binding{vk::DescriptorType::eStorageBuffer, out.handle(), 0, out.size()}};
    const gpu::Groups first{0, 0, 0};
    gpu::Kernel(device, spirv, bindings, constants).run({&first, 1}, {1, 1, 1});
    for (const std::string& message : device.validationMessages()) ADD_FAILURE() << "validation: " << message;
    std::memcpy(result.data(), out.mapped().data(), out.size());
    return result;
}

}  // namespace fringe::testing
