// All of a compiled scene's arrays in one buffer: one allocation and one upload.
#pragma once

#include <optional>
#include <vector>

#include "compile/compiled_scene.hpp"
#include "gpu/kernel.hpp"
#include "gpu/texels.hpp"

namespace fringe::render {

// Where each array of a scene lies in the buffer, in the order of shaders/bindings.glsl without the film.
struct SceneLayout {
    struct Range {
        vk::DescriptorType type;
        vk::DeviceSize offset;
        vk::DeviceSize size;  // 0: the scene has none of these
        const void* data;     // into the CompiledScene; null for the block
    };
    device::SceneBlock block;
    std::vector<Range> ranges;  // the block first
    vk::DeviceSize size = 0;
};

// Throws gpu::DeviceError if an array is larger than the device can bind.
SceneLayout layOut(const compile::CompiledScene& scene, const gpu::Device& device);

// Copies the arrays to their places.
void upload(const SceneLayout& layout, const gpu::Buffer& buffer);

// The response tables for shaders that know gratings, one texel where the scene has none of them; nothing for
// other shaders.
std::optional<gpu::Texels> uploadResponses(const compile::CompiledScene& scene, const gpu::Device& device);

// Bindings of shaders/bindings.glsl. An array that is not there is bound to the frame's bytes, which the
// specialised shader never reads as such: Vulkan wants every binding to be valid, and this costs no memory.
std::vector<gpu::Binding> bindings(const SceneLayout& layout, const gpu::Buffer& scene,
                                   const gpu::Buffer& film, const std::optional<gpu::Texels>& responses);

}  // namespace fringe::render
