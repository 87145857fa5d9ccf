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

}  // namespace

bool fitTexelBuffer(const Device& device, std::size_t bytes) {
    return bytes / kTexelBytes <= device.limits().maxTexelBufferElements;
}

Texels::Texels(const Device& device, const std::string& what, std::span<const std::byte> records,
               TexelHome home, std::uint32_t row)
    : buffer_(device, std::max(home == TexelHome::buffer ? records.size() : 0, kTexelBytes),
              Access::hostWrites),
      image_(nullptr),
      memory_(nullptr),
      view_(nullptr) {
    assert(home == TexelHome::image || fitTexelBuffer(device, records.size()));
    guarded("uploading " + what, [&] {
        const vk::Extent3D extent =
            extentOf(device, what, home == TexelHome::image ? records.size() : 0, row);
        image_ = createImage(device, extent);
        memory_ = allocate(device, image_.getMemoryRequirements(), Access::deviceOnly);
        image_.bindMemory(*memory_, 0);
        if (home == TexelHome::image) {
            const Buffer staging(device, kTexelBytes * extent.width * extent.height, Access::hostWrites);
            std::copy(records.begin(), records.end(), staging.mapped().begin());
            fill(device, staging.handle(), *image_, extent);
        } else {
            std::copy(records.begin(), records.end(), buffer_.mapped().begin());
            fill(device, buffer_.handle(), *image_, extent);
        }
        view_ = vk::raii::ImageView(
            device.handle(), vk::ImageViewCreateInfo({}, *image_, vk::ImageViewType::e2D, kTexelFormat, {},
                                                     {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
    });
}

Binding Texels::buffer() const {
    return {vk::DescriptorType::eUniformTexelBuffer, buffer_.handle(), 0, buffer_.size()};
}

Binding Texels::image() const {
    return {vk::DescriptorType::eSampledImage, {}, 0, 0, *view_};
}

}  // namespace fringe::gpu
