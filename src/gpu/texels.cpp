#include "gpu/texels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace fringe::gpu {
namespace {

vk::Extent3D extentOf(const Device& device, const std::string& what, std::size_t bytes, std::uint32_t row) {
    const std::size_t rows = std::max<std::size_t>((bytes / kTexelBytes + row - 1) / row, 1);
    const std::uint32_t most = device.limits().maxImageDimension2D;
    if (rows > most) {
        throw DeviceError(fmt::format("{} take {} MiB, but this device has images of at most {} MiB", what,
                                      bytes >> 20, kTexelBytes * row * most >> 20));
    }
    return {bytes == 0 ? 1 : row, static_cast<std::uint32_t>(rows), 1};
}

vk::raii::Image createImage(const Device& device, vk::Extent3D extent) {
    using Usage = vk::ImageUsageFlagBits;
    return {device.handle(), vk::ImageCreateInfo({}, vk::ImageType::e2D, kTexelFormat, extent, 1, 1,
                                                 vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                                                 Usage::eSampled | Usage::eTransferDst)};
}

std::size_t bytesOf(std::span<const Texels::Part> parts) {
    return parts.empty() ? 0 : parts.back().offset + parts.back().records.size();
}

void put(const Texels::Part& part, const Buffer& buffer) {
    std::copy(part.records.begin(), part.records.end(), buffer.mapped().subspan(part.offset).begin());
}

}  // namespace

bool fitTexelBuffer(const Device& device, std::size_t bytes) {
    return bytes / kTexelBytes <= device.limits().maxTexelBufferElements;
}

Texels::Texels(const Device& device, const std::string& what, std::span<const Part> parts, TexelHome home,
               std::uint32_t row)
    : home_(home),
      buffer_(device, std::max(home == TexelHome::buffer ? bytesOf(parts) : 0, kTexelBytes),
              Access::hostWrites),
      image_(nullptr),
      memory_(nullptr),
      view_(nullptr) {
    assert(home == TexelHome::image || fitTexelBuffer(device, bytesOf(parts)));
    guarded("uploading " + what, [&] {
        const vk::Extent3D extent =
            extentOf(device, what, home == TexelHome::image ? bytesOf(parts) : 0, row);
        image_ = createImage(device, extent);
        memory_ = allocate(device, image_.getMemoryRequirements(), Access::deviceOnly);
        image_.bindMemory(*memory_, 0);
        if (home == TexelHome::image) {
            const Buffer staging(device, kTexelBytes * extent.width * extent.height, Access::hostWrites);
            for (const Part& part : parts) put(part, staging);
            fill(device, staging.handle(), *image_, extent);
        } else {
            for (const Part& part : parts) put(part, buffer_);
            fill(device, buffer_.handle(), *image_, extent);
        }
        view_ = vk::raii::ImageView(
            device.handle(), vk::ImageViewCreateInfo({}, *image_, vk::ImageViewType::e2D, kTexelFormat, {},
                                                     {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
    });
}

void Texels::write(const Part& part) const {
    assert(part.offset + part.records.size() <= room());
    put(part, buffer_);
}

Binding Texels::buffer() const {
    return {vk::DescriptorType::eUniformTexelBuffer, buffer_.handle(), 0, buffer_.size()};
}

Binding Texels::image() const {
    return {vk::DescriptorType::eSampledImage, {}, 0, 0, *view_};
}

}  // namespace fringe::gpu
