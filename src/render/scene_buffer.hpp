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

// A scene's constants for this device: texels are in images where its texel buffers are too small.
device::Specialisation specialiseFor(const gpu::Device& device, const compile::CompiledScene& scene,
                                     device::Specialisation constants);

// What shaders read as texels.
struct SceneTexels {
    std::optional<gpu::Texels> responses;  // for shaders that know gratings, though the scene may have none
    std::optional<gpu::Texels> tree;       // for those that know one
    compile::ResponseTables tables;        // that are in `responses`
};

// Into `texels`, which may be another scene's: tables that are in their place there stay. Precondition: the
// device reads them no longer.
void uploadTexels(const gpu::Device& device, const compile::CompiledScene& scene,
                  const device::Specialisation& constants, SceneTexels& texels);

// Bindings of shaders/bindings.glsl and shaders/tree.glsl. An array that is not there is bound to the frame's
// bytes, which the specialised shader never reads as such: Vulkan wants every binding to be valid, and this
// costs no memory.
std::vector<gpu::Binding> bindings(const SceneLayout& layout, const gpu::Buffer& scene,
                                   const gpu::Buffer& film, const SceneTexels& texels);

}  // namespace fringe::render
