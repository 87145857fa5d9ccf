#include "gpu/kernel.hpp"

#include <cassert>
#include <map>
#include <vector>

namespace fringe::gpu {
namespace {

// Far beyond any tile (render keeps those near 50 ms); a device that needs longer hangs.
constexpr std::uint64_t kTimeout_ns = 60'000'000'000;

vk::raii::DescriptorSetLayout createBindings(const Device& device, std::span<const Binding> bindings) {
    std::vector<vk::DescriptorSetLayoutBinding> layout;
    for (const Binding& binding : bindings) {
        layout.emplace_back(static_cast<std::uint32_t>(layout.size()), binding.type, 1,
                            vk::ShaderStageFlagBits::eCompute);
    }
    return {device.handle(), {{}, layout}};
}

vk::raii::PipelineLayout createLayout(const Device& device, vk::DescriptorSetLayout bindings,
                                      std::uint32_t pushBytes) {
    const vk::PushConstantRange range(vk::ShaderStageFlagBits::eCompute, 0, pushBytes);
    vk::PipelineLayoutCreateInfo info({}, bindings);
    if (pushBytes > 0) info.setPushConstantRanges(range);
    return {device.handle(), info};
}

vk::raii::Pipeline createPipeline(const Device& device, std::span<const std::uint32_t> spirv,
                                  std::span<const std::uint32_t> constants, vk::PipelineLayout layout) {
    const vk::raii::ShaderModule module(device.handle(), {{}, spirv.size_bytes(), spirv.data()});
    std::vector<vk::SpecializationMapEntry> entries;
    for (std::uint32_t i = 0; i < constants.size(); ++i) entries.emplace_back(i, i * 4, 4);
    const vk::SpecializationInfo values(static_cast<std::uint32_t>(entries.size()), entries.data(),
                                        constants.size_bytes(), constants.data());
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main",
                                                  &values);
    return {device.handle(), nullptr, vk::ComputePipelineCreateInfo({}, stage, layout)};
}

vk::raii::DescriptorPool createPool(const Device& device, std::span<const Binding> bindings) {
    std::map<vk::DescriptorType, std::uint32_t> counts;
    for (const Binding& binding : bindings) ++counts[binding.type];
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts) sizes.emplace_back(type, count);
    return {device.handle(), {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes}};
}

vk::raii::CommandBuffer createCommands(const Device& device) {
    return std::move(vk::raii::CommandBuffers(
        device.handle(), {*device.commandPool(), vk::CommandBufferLevel::ePrimary, 1})[0]);
}

void submitAndWait(const Device& device, const vk::raii::CommandBuffer& commands,
                   const vk::raii::Fence& done) {
    device.queue().submit(vk::SubmitInfo({}, {}, *commands), *done);
    if (device.handle().waitForFences(*done, VK_TRUE, kTimeout_ns) == vk::Result::eTimeout) {
        throw DeviceError(device.description().name +
                          " has not answered for a minute; choose another device with --device");
    }
    device.handle().resetFences(*done);
}

}  // namespace

Kernel::Kernel(const Device& device, std::span<const std::uint32_t> spirv, std::span<const Binding> bindings,
               std::span<const std::uint32_t> constants, std::uint32_t pushConstantBytes)
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
        layout_ = createLayout(device, *bindings_, pushConstantBytes);
        pipeline_ = createPipeline(device, spirv, constants, *layout_);
        pool_ = createPool(device, bindings);
        set_ = std::move(vk::raii::DescriptorSets(device.handle(), {*pool_, *bindings_})[0]);
        commands_ = createCommands(device);
        done_ = vk::raii::Fence(device.handle(), vk::FenceCreateInfo());

        std::vector<vk::DescriptorBufferInfo> buffers;
        for (const Binding& binding : bindings)
            buffers.emplace_back(binding.buffer, binding.offset, binding.size);
        std::vector<vk::WriteDescriptorSet> writes;
        for (std::uint32_t i = 0; i < bindings.size(); ++i) {
            writes.emplace_back(*set_, i, 0, 1, bindings[i].type, nullptr, &buffers[i]);
        }
        device.handle().updateDescriptorSets(writes, nullptr);
    });
}

void Kernel::run(std::span<const std::byte> pushConstants, Groups groups) const {
    guarded("running the shader", [&] {
        using Stage = vk::PipelineStageFlagBits;
        using Use = vk::AccessFlagBits;
        commands_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        const vk::MemoryBarrier before(Use::eShaderWrite, Use::eShaderRead | Use::eShaderWrite);
        commands_.pipelineBarrier(Stage::eComputeShader, Stage::eComputeShader, {}, before, nullptr, nullptr);
        commands_.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_);
        commands_.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout_, 0, *set_, nullptr);
        if (!pushConstants.empty()) {
            commands_.pushConstants<std::byte>(
                *layout_, vk::ShaderStageFlagBits::eCompute, 0,
                {static_cast<std::uint32_t>(pushConstants.size()), pushConstants.data()});
        }
        commands_.dispatch(groups.x, groups.y, groups.z);
        const vk::MemoryBarrier after(Use::eShaderWrite, Use::eHostRead | Use::eTransferRead);
        commands_.pipelineBarrier(Stage::eComputeShader, Stage::eHost | Stage::eTransfer, {}, after, nullptr,
                                  nullptr);
        commands_.end();
        submitAndWait(device_, commands_, done_);
    });
}

void copy(const Device& device, const Copy& what) {
    guarded("reading back the film", [&] {
        using Stage = vk::PipelineStageFlagBits;
        using Use = vk::AccessFlagBits;
        const vk::raii::CommandBuffer commands = createCommands(device);
        commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        const vk::MemoryBarrier before(Use::eShaderWrite, Use::eTransferRead);
        commands.pipelineBarrier(Stage::eComputeShader, Stage::eTransfer, {}, before, nullptr, nullptr);
        commands.copyBuffer(what.from, what.to, vk::BufferCopy(0, 0, what.bytes));
        const vk::MemoryBarrier after(Use::eTransferWrite, Use::eHostRead);
        commands.pipelineBarrier(Stage::eTransfer, Stage::eHost, {}, after, nullptr, nullptr);
        commands.end();
        submitAndWait(device, commands, vk::raii::Fence(device.handle(), vk::FenceCreateInfo()));
    });
}

}  // namespace fringe::gpu
