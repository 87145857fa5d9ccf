// A compute pipeline bound to its buffers; run() returns when the device is done.
#pragma once

#include <cstdint>
#include <span>

#include "gpu/buffer.hpp"

namespace fringe::gpu {

struct Binding {
    vk::DescriptorType type;
    vk::Buffer buffer;
    vk::DeviceSize offset;
    vk::DeviceSize size;
};

struct Groups {
    std::uint32_t x, y, z;
};

struct Copy {
    vk::Buffer from;
    vk::Buffer to;
    vk::DeviceSize bytes;
};

class Kernel {
public:
    // `bindings[i]` is bound to set 0, binding i; `constants[i]` is specialisation constant i.
    Kernel(const Device& device, std::span<const std::uint32_t> spirv, std::span<const Binding> bindings,
           std::span<const std::uint32_t> constants, std::uint32_t pushConstantBytes);

    // Dispatches and waits. Earlier runs' writes are visible to it, its own to later runs and to the host.
    // Throws DeviceError if the device is lost or does not answer.
    void run(std::span<const std::byte> pushConstants, Groups groups) const;

private:
    const Device& device_;
    vk::raii::DescriptorSetLayout bindings_;
    vk::raii::PipelineLayout layout_;  // needs bindings_
    vk::raii::Pipeline pipeline_;      // needs layout_
    vk::raii::DescriptorPool pool_;
    vk::raii::DescriptorSet set_;  // lives in pool_
    vk::raii::CommandBuffer commands_;
    vk::raii::Fence done_;
};

// Copies between buffers and waits.
void copy(const Device& device, const Copy& what);

}  // namespace fringe::gpu
