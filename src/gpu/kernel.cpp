#include "gpu/kernel.hpp"

#include <cassert>
#include <limits>
#include <map>
#include <vector>

#include "gpu/frozen_constants.hpp"
#include "gpu/live_code.hpp"

namespace fringe::gpu {
namespace {

// Far beyond any tile (render keeps those near 50 ms); a GPU that needs longer hangs. A processor's driver
// compiles in the first dispatch, which on a busy machine takes minutes; what it still works on must not be
// destroyed, so it is given the time.
constexpr std::uint64_t kGpuTimeout_ns = 60'000'000'000;

std::uint64_t timeout_ns(const Device& device) {
    return device.description().isProcessor() ? std::numeric_limits<std::uint64_t>::max() : kGpuTimeout_ns;
}

bool isBound(const Binding& binding) {
    return binding.buffer || binding.image;
}

vk::raii::DescriptorSetLayout createBindings(const Device& device, std::span<const Binding> bindings) {
    std::vector<vk::DescriptorSetLayoutBinding> layout;
    for (const Binding& binding : bindings) {
        layout.emplace_back(static_cast<std::uint32_t>(layout.size()), binding.type, isBound(binding) ? 1 : 0,
                            vk::ShaderStageFlagBits::eCompute);
    }
    return {device.handle(), {{}, layout}};
}

vk::raii::PipelineLayout createLayout(const Device& device, vk::DescriptorSetLayout bindings) {
    return {device.handle(), vk::PipelineLayoutCreateInfo({}, bindings)};
}

vk::raii::Pipeline createPipeline(const Device& device, std::span<const std::uint32_t> spirv,
                                  std::span<const std::uint32_t> constants, vk::PipelineLayout layout) {
    const std::vector<std::uint32_t> code = withoutDeadCode(withFrozenConstants(spirv, constants));
    const vk::raii::ShaderModule module(device.handle(), vk::ShaderModuleCreateInfo({}, code));
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main");
    return {device.handle(), nullptr,
            vk::ComputePipelineCreateInfo(vk::PipelineCreateFlagBits::eDispatchBase, stage, layout)};
}

vk::raii::DescriptorPool createPool(const Device& device, std::span<const Binding> bindings) {
    std::map<vk::DescriptorType, std::uint32_t> counts;
    for (const Binding& binding : bindings)
        if (isBound(binding)) ++counts[binding.type];
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts) sizes.emplace_back(type, count);
    return {device.handle(), {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes}};
}

vk::raii::BufferView createView(const Device& device, const Binding& binding) {
    return {device.handle(),
            vk::BufferViewCreateInfo({}, binding.buffer, kTexelFormat, binding.offset, binding.size)};
}

vk::raii::CommandBuffer createCommands(const Device& device) {
    return std::move(vk::raii::CommandBuffers(
        device.handle(), {*device.commandPool(), vk::CommandBufferLevel::ePrimary, 1})[0]);
}

void submitAndWait(const Device& device, const vk::raii::CommandBuffer& commands,
                   const vk::raii::Fence& done) {
    device.queue().submit(vk::SubmitInfo({}, {}, *commands), *done);
    if (device.handle().waitForFences(*done, VK_TRUE, timeout_ns(device)) == vk::Result::eTimeout) {
        throw DeviceError(device.description().name +
                          " has not answered for a minute; choose another device with --device");
    }
    device.handle().resetFences(*done);
}

using Stage = vk::PipelineStageFlagBits;
using Use = vk::AccessFlagBits;

struct Work {
    vk::PipelineStageFlags stages;
    vk::AccessFlags uses;
};

// What `before` did is done and visible when `after` begins.
void barrier(const vk::raii::CommandBuffer& commands, Work before, Work after) {
    const vk::MemoryBarrier memory(before.uses, after.uses);
    commands.pipelineBarrier(before.stages, after.stages, {}, memory, nullptr, nullptr);
}

// Records one transfer command between what shaders wrote before and what shaders and the host do next;
// waits.
template <class Record>
void transfer(const Device& device, Record record) {
    const vk::raii::CommandBuffer commands = createCommands(device);
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    barrier(commands, {Stage::eComputeShader, Use::eShaderWrite},
            {Stage::eTransfer, Use::eTransferRead | Use::eTransferWrite});
    record(commands);
    barrier(commands, {Stage::eTransfer, Use::eTransferWrite},
            {Stage::eComputeShader | Stage::eHost, Use::eShaderRead | Use::eShaderWrite | Use::eHostRead});
    commands.end();
    submitAndWait(device, commands, vk::raii::Fence(device.handle(), vk::FenceCreateInfo()));
}

}  // namespace

Kernel::Kernel(const Device& device, std::span<const std::uint32_t> spirv, std::span<const Binding> bindings,
               std::span<const std::uint32_t> constants)
    : device_(device),
      bindings_(nullptr),
      layout_(nullptr),
      pipeline_(nullptr),
      pool_(nullptr),
      set_(nullptr),
      commands_(nullptr),
      done_(nullptr) {
    guarded("compiling the shader", [&] {
        bindings_ = createBindings(device, bindings);
        layout_ = createLayout(device, *bindings_);
        pipeline_ = createPipeline(device, spirv, constants, *layout_);
        pool_ = createPool(device, bindings);
        set_ = std::move(vk::raii::DescriptorSets(device.handle(), {*pool_, *bindings_})[0]);
        commands_ = createCommands(device);
        done_ = vk::raii::Fence(device.handle(), vk::FenceCreateInfo());
    });
    bind(bindings);
}

void Kernel::bind(std::span<const Binding> bindings) {
    guarded("binding buffers to the shader", [&] {
        texels_.clear();
        std::vector<vk::DescriptorBufferInfo> buffers;
        std::vector<vk::DescriptorImageInfo> images;
        std::vector<vk::BufferView> views(bindings.size());
        for (std::uint32_t i = 0; i < bindings.size(); ++i) {
            const Binding& binding = bindings[i];
            buffers.emplace_back(binding.buffer, binding.offset, binding.size);
            images.emplace_back(nullptr, binding.image, vk::ImageLayout::eShaderReadOnlyOptimal);
            if (binding.type == vk::DescriptorType::eUniformTexelBuffer && isBound(binding))
                views[i] = *texels_.emplace_back(createView(device_, binding));
        }
        std::vector<vk::WriteDescriptorSet> writes;
        for (std::uint32_t i = 0; i < bindings.size(); ++i) {
            if (isBound(bindings[i]))
                writes.emplace_back(*set_, i, 0, 1, bindings[i].type, &images[i], &buffers[i], &views[i]);
        }
        device_.handle().updateDescriptorSets(writes, nullptr);
    });
}

void Kernel::run(std::span<const Groups> firstGroups, Groups groups) const {
    guarded("running the shader", [&] {
        commands_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        commands_.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_);
        commands_.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout_, 0, *set_, nullptr);
        for (const Groups& first : firstGroups) {
            barrier(commands_, {Stage::eComputeShader, Use::eShaderWrite},
                    {Stage::eComputeShader, Use::eShaderRead | Use::eShaderWrite});
            commands_.dispatchBase(first.x, first.y, first.z, groups.x, groups.y, groups.z);
        }
        barrier(commands_, {Stage::eComputeShader, Use::eShaderWrite},
                {Stage::eHost | Stage::eTransfer, Use::eHostRead | Use::eTransferRead});
        commands_.end();
        submitAndWait(device_, commands_, done_);
    });
}

void fill(const Device& device, vk::Buffer from, vk::Image image, vk::Extent3D extent) {
    using Layout = vk::ImageLayout;
    constexpr auto kColor = vk::ImageAspectFlagBits::eColor;
    const auto become = [&](const vk::raii::CommandBuffer& commands, Layout before, Layout after,
                            vk::AccessFlags wrote, vk::AccessFlags reads) {
        commands.pipelineBarrier(
            Stage::eTransfer, Stage::eTransfer | Stage::eComputeShader, {}, nullptr, nullptr,
            vk::ImageMemoryBarrier(wrote, reads, before, after, VK_QUEUE_FAMILY_IGNORED,
                                   VK_QUEUE_FAMILY_IGNORED, image, {kColor, 0, 1, 0, 1}));
    };
    transfer(device, [&](const vk::raii::CommandBuffer& commands) {
        become(commands, Layout::eUndefined, Layout::eTransferDstOptimal, {}, Use::eTransferWrite);
        commands.copyBufferToImage(from, image, Layout::eTransferDstOptimal,
                                   vk::BufferImageCopy(0, 0, 0, {kColor, 0, 0, 1}, {0, 0, 0}, extent));
        become(commands, Layout::eTransferDstOptimal, Layout::eShaderReadOnlyOptimal, Use::eTransferWrite,
               Use::eShaderRead);
    });
}

void copy(const Device& device, const Copy& what) {
    guarded("reading back the film", [&] {
        transfer(device, [&](const vk::raii::CommandBuffer& commands) {
            commands.copyBuffer(what.from, what.to, vk::BufferCopy(0, 0, what.bytes));
        });
    });
}

void clear(const Device& device, vk::Buffer buffer, std::uint32_t first, vk::DeviceSize bytes) {
    guarded("clearing the film", [&] {
        transfer(device, [&](const vk::raii::CommandBuffer& commands) {
            commands.fillBuffer(buffer, 0, sizeof first, first);
            commands.fillBuffer(buffer, sizeof first, bytes - sizeof first, 0);
        });
    });
}

}  // namespace fringe::gpu
