#include "gpu/buffer.hpp"

#include <fmt/format.h>

#include <array>

namespace fringe::gpu {
namespace {

using Property = vk::MemoryPropertyFlagBits;

constexpr vk::MemoryPropertyFlags kMapped = Property::eHostVisible | Property::eHostCoherent;
constexpr vk::MemoryPropertyFlags kShared = kMapped | Property::eHostCached | Property::eDeviceLocal;

// What each access would like, and what it can do with.
std::array<vk::MemoryPropertyFlags, 2> wishes(Access access) {
    switch (access) {
        case Access::hostWrites:
            return {kMapped | Property::eDeviceLocal, kMapped};
        case Access::hostReads:
            return {kMapped | Property::eHostCached, kMapped};
        case Access::shared:
            return {kShared, kShared};
        case Access::deviceOnly:
            return {Property::eDeviceLocal, vk::MemoryPropertyFlags{}};
    }
    return {};
}

vk::raii::Buffer createBuffer(const Device& device, vk::DeviceSize bytes) {
    using Usage = vk::BufferUsageFlagBits;
    const vk::BufferUsageFlags usage = Usage::eStorageBuffer | Usage::eUniformBuffer |
                                       Usage::eUniformTexelBuffer | Usage::eTransferSrc | Usage::eTransferDst;
    return {device.handle(), {{}, bytes, usage}};
}

}  // namespace

vk::raii::DeviceMemory allocate(const Device& device, const vk::MemoryRequirements& needs, Access access) {
    for (const vk::MemoryPropertyFlags wish : wishes(access)) {
        if (const auto type = memoryType(device, needs.memoryTypeBits, wish)) {
            return {device.handle(), {needs.size, *type}};
        }
    }
    throw DeviceError(
        "the device has no memory of the kind needed (Vulkan promises one; the driver is faulty)");
}

Buffer::Buffer(const Device& device, vk::DeviceSize bytes, Access access)
    : size_(bytes), buffer_(nullptr), memory_(nullptr) {
    guarded(fmt::format("allocating {} bytes", bytes), [&] {
        buffer_ = createBuffer(device, bytes);
        memory_ = allocate(device, buffer_.getMemoryRequirements(), access);
        buffer_.bindMemory(*memory_, 0);
        if (access != Access::deviceOnly) {
            mapped_ = {static_cast<std::byte*>(memory_.mapMemory(0, bytes)), static_cast<std::size_t>(bytes)};
        }
    });
}

bool hasSharedMemory(const Device& device) {
    constexpr std::uint32_t kAnyType = ~0U;
    return memoryType(device, kAnyType, kShared).has_value();
}

}  // namespace fringe::gpu
