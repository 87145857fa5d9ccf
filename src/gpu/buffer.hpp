// A storage or uniform buffer with memory of its own, mapped where the host takes part.
#pragma once

#include <cstddef>
#include <span>

#include "gpu/vulkan.hpp"

namespace fringe::gpu {

enum class Access {
    hostWrites,  // mapped; in device memory if that can be mapped
    hostReads,   // mapped and cached, so that reading it back is not slow
    shared,      // device memory that is mapped and cached too: integrated GPUs and CPUs have it (see
                 // hasSharedMemory)
    deviceOnly,
};

class Buffer {
public:
    // Contents are undefined. Throws DeviceError when memory is short.
    Buffer(const Device& device, vk::DeviceSize bytes, Access access);

    vk::Buffer handle() const { return *buffer_; }
    vk::DeviceSize size() const { return size_; }

    // The mapped bytes; empty with Access::deviceOnly.
    std::span<std::byte> mapped() const { return mapped_; }

private:
    vk::DeviceSize size_;
    vk::raii::Buffer buffer_;
    vk::raii::DeviceMemory memory_;
    std::span<std::byte> mapped_;
};

// Memory for something that needs it. Throws DeviceError when there is none; out of memory as vk::Error.
vk::raii::DeviceMemory allocate(const Device& device, const vk::MemoryRequirements& needs, Access access);

// Whether Access::shared can be had: then a result needs no copy to be read.
bool hasSharedMemory(const Device& device);

}  // namespace fringe::gpu
