// A compute pipeline bound to its buffers; run() returns when the device is done. There are no push
// constants: what differs between dispatches comes in as the first workgroup (docs/architecture.md, "No
// uniform decides").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.hpp"

namespace fringe::gpu {

// Of texel buffers: four unsigned words, which every device reads.
constexpr vk::Format kTexelFormat = vk::Format::eR32G32B32A32Uint;
constexpr vk::DeviceSize kTexelBytes = 16;

struct Binding {
    vk::DescriptorType type;  // uniform, storage or uniform texel buffer, or sampled image
    vk::Buffer buffer;        // null for an image; without either, nothing is bound to this number
    vk::DeviceSize offset;
    vk::DeviceSize size;
    vk::ImageView image{};
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
           std::span<const std::uint32_t> constants);

    // Binds other buffers, of the same types in the same order, for the next run().
    void bind(std::span<const Binding> bindings);

    // Dispatches `groups` once from each of the first workgroups, one after the other, and waits. Earlier
    // writes are visible to each, the last ones to the host. Throws DeviceError if the device is lost or does
    // not answer.
    void run(std::span<const Groups> firstGroups, Groups groups) const;

private:
    const Device& device_;
    vk::raii::DescriptorSetLayout bindings_;
    vk::raii::PipelineLayout layout_;           // needs bindings_
    vk::raii::Pipeline pipeline_;               // needs layout_
    std::vector<vk::raii::BufferView> texels_;  // of texel buffers
    vk::raii::DescriptorPool pool_;
    vk::raii::DescriptorSet set_;  // lives in pool_
    vk::raii::CommandBuffer commands_;
    vk::raii::Fence done_;
};

// Copies a buffer's bytes, row by row, to an image nobody has used yet, makes it readable by shaders, and
// waits.
void fill(const Device& device, vk::Buffer from, vk::Image image, vk::Extent3D extent);

// Copies between buffers and waits.
void copy(const Device& device, const Copy& what);

// Sets the buffer's first word to `first` and the rest of its first `bytes` to zero, and waits.
void clear(const Device& device, vk::Buffer buffer, std::uint32_t first, vk::DeviceSize bytes);

}  // namespace fringe::gpu
