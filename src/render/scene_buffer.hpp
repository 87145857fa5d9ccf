// All of a compiled scene's arrays in one buffer, and what is read as texels in two images.
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

// What shaders read as texels (gpu::Texels says why); empty where a scene's shader has no such binding.
struct SceneImages {
    std::optional<gpu::Texels>
        responses;  // one texel where a shader knows gratings and the scene has no tables
    std::optional<gpu::Texels> tree;
};

// Throws gpu::DeviceError if the device has no image so large.
SceneImages uploadImages(const compile::CompiledScene& scene, const gpu::Device& device);

// Bindings of shaders/bindings.glsl. An array that is not there is bound to the frame's bytes, which the
// specialised shader never reads as such: Vulkan wants every binding to be valid, and this costs no memory.
std::vector<gpu::Binding> bindings(const SceneLayout& layout, const gpu::Buffer& scene,
                                   const gpu::Buffer& film, const SceneImages& images);

}  // namespace fringe::render
