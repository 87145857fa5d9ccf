#include "render/scene_buffer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace fringe::render {
namespace {

class LayoutBuilder {
public:
    explicit LayoutBuilder(const gpu::Device& device)
        : alignment_(std::max(device.limits().minStorageBufferOffsetAlignment,
                              device.limits().minUniformBufferOffsetAlignment)),
          largest_(device.limits().maxStorageBufferRange) {}

    void addBlock(const device::SceneBlock& block) {
        layout_.block = block;
        add(vk::DescriptorType::eUniformBuffer, nullptr, sizeof block);
    }

    // Arrays of no more than FEW elements lie in the block and take no room here.
    template <class Element>
    void addMany(const char* name, const std::vector<Element>& elements) {
        if (elements.size() > device::FEW) addAll(name, elements);
        else add(vk::DescriptorType::eStorageBuffer, nullptr, 0);
    }

    template <class Element>
    void addAll(const char* name, const std::vector<Element>& elements) {
        const vk::DeviceSize size = elements.size() * sizeof(Element);
        if (size > largest_) {
            throw gpu::DeviceError(
                fmt::format("{} {} take {} MiB, but this device binds at most {} MiB at once",
                            elements.size(), name, size >> 20, largest_ >> 20));
        }
        add(vk::DescriptorType::eStorageBuffer, elements.data(), size);
    }

    SceneLayout take() { return std::move(layout_); }

private:
    void add(vk::DescriptorType type, const void* data, vk::DeviceSize size) {
        const vk::DeviceSize offset = (layout_.size + alignment_ - 1) / alignment_ * alignment_;
        layout_.ranges.push_back({type, offset, size, data});
        layout_.size = std::max(layout_.size, offset + size);
    }

    SceneLayout layout_;
    vk::DeviceSize alignment_;
    vk::DeviceSize largest_;
};

template <class Element>
std::span<const std::byte> bytesOf(const std::vector<Element>& elements) {
    return std::as_bytes(std::span(elements));
}

std::size_t sizeOf(const compile::ResponseTables& tables) {
    return tables.size() * sizeof(device::ResponseEntry);
}

gpu::Texels::Part texelsOf(const compile::ResponseTables::Part& part) {
    return {part.first * sizeof(device::ResponseEntry), bytesOf(*part.table)};
}

}  // namespace

SceneLayout layOut(const compile::CompiledScene& scene, const gpu::Device& device) {
    LayoutBuilder builder(device);
    builder.addBlock(compile::sceneBlock(scene));
    builder.addMany("planes", scene.planes);
    builder.addMany("rectangles", scene.rectangles);
    builder.addMany("discs", scene.discs);
    builder.addMany("spheres", scene.spheres);
    builder.addMany("boxes", scene.boxes);
    builder.addMany("cylinders", scene.cylinders);
    builder.addMany("cones", scene.cones);
    builder.addMany("triangles", scene.triangles);
    builder.addMany("materials", scene.materials);
    builder.addMany("lights", scene.lights);
    builder.addMany("gratings", scene.gratings);
    builder.addMany("gratings", scene.slitGratings);
    builder.addAll("table entries", scene.tables);
    builder.addMany("gratings", scene.openingGratings);
    builder.addMany("optical discs", scene.opticalDiscs);
    return builder.take();
}

void upload(const SceneLayout& layout, const gpu::Buffer& buffer) {
    for (const SceneLayout::Range& range : layout.ranges) {
        const void* data = range.data != nullptr ? range.data : &layout.block;
        if (range.size > 0) std::memcpy(buffer.mapped().data() + range.offset, data, range.size);
    }
}

device::Specialisation specialiseFor(const gpu::Device& device, const compile::CompiledScene& scene,
                                     device::Specialisation constants) {
    if (!gpu::fitTexelBuffer(device, sizeOf(scene.responses)) ||
        !gpu::fitTexelBuffer(device, bytesOf(scene.tree.nodes).size())) {
        constants.TEXELS_IN_IMAGES = 1;
    }
    return constants;
}

void uploadTexels(const gpu::Device& device, const compile::CompiledScene& scene,
                  const device::Specialisation& constants, SceneTexels& texels) {
    const gpu::TexelHome home =
        constants.TEXELS_IN_IMAGES != 0 ? gpu::TexelHome::image : gpu::TexelHome::buffer;
    if (scene.slitGratings.empty() && scene.openingGratings.empty() && !scene.inBands) {
        texels.responses.reset();
    } else if (home == gpu::TexelHome::buffer && texels.responses &&
               sizeOf(scene.responses) <= texels.responses->room()) {
        const auto& known = texels.tables.parts();
        for (const compile::ResponseTables::Part& part : scene.responses.parts())
            if (std::find(known.begin(), known.end(), part) == known.end())
                texels.responses->write(texelsOf(part));
    } else {
        std::vector<gpu::Texels::Part> parts;
        for (const compile::ResponseTables::Part& part : scene.responses.parts())
            parts.push_back(texelsOf(part));
        texels.responses.reset();  // before there are two
        texels.responses.emplace(device, "response tables", parts, home, device::TEXEL_ROW);
    }
    texels.tables = scene.responses;
    texels.tree.reset();
    if (scene.tree.nodes.empty()) return;
    const gpu::Texels::Part nodes{0, bytesOf(scene.tree.nodes)};
    texels.tree.emplace(device, "the tree of shapes", std::span(&nodes, 1), home, device::TEXEL_ROW);
}

std::vector<gpu::Binding> bindings(const SceneLayout& layout, const gpu::Buffer& scene,
                                   const gpu::Buffer& film, const SceneTexels& texels) {
    const SceneLayout::Range& block = layout.ranges.front();
    std::vector<gpu::Binding> result;
    for (const SceneLayout::Range& range : layout.ranges) {
        const SceneLayout::Range& place = range.size > 0 ? range : block;
        result.push_back({range.type, scene.handle(), place.offset, place.size});
    }
    result.insert(result.begin() + 1, {vk::DescriptorType::eStorageBuffer, film.handle(), 0, film.size()});
    for (const std::optional<gpu::Texels>* some : {&texels.responses, &texels.tree}) {
        if (*some) {
            result.push_back((*some)->buffer());
            result.push_back((*some)->image());
        } else {
            result.push_back({vk::DescriptorType::eUniformTexelBuffer, {}, 0, 0});
            result.push_back({vk::DescriptorType::eSampledImage, {}, 0, 0});
        }
    }
    return result;
}

}  // namespace fringe::render
