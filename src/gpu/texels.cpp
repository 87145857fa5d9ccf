#include "gpu/texels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "gpu/buffer.hpp"
#include "gpu/kernel.hpp"

namespace fringe::gpu {
namespace {

constexpr vk::Format kFormat = vk::Format::eR32G32B32A32Uint;
constexpr std::size_t kRecord = 4 * sizeof(std::uint32_t);

vk::Extent3D extentOf(const Device& device, std::size_t bytes, std::uint32_t row) {
    const std::size_t rows = std::max<std::size_t>((bytes / kRecord + row - 1) / row, 1);
    const std::uint32_t most = device.limits().maxImageDimension2D;
    if (rows > most) {
        throw DeviceError(
            fmt::format("response tables take {} MiB, but this device has images of at most {} MiB",
                        bytes >> 20, kRecord * row * most >> 20));
    }
    return {bytes == 0 ? 1 : row, static_cast<std::uint32_t>(rows), 1};
}

vk::raii::Image createImage(const Device& device, vk::Extent3D extent) {
    using Usage = vk::ImageUsageFlagBits;
    return {device.handle(),
            vk::ImageCreateInfo({}, vk::ImageType::e2D, kFormat, extent, 1, 1, vk::SampleCountFlagBits::e1,
                                vk::ImageTiling::eOptimal, Usage::eSampled | Usage::eTransferDst)};
}

}  // namespace

Texels::Texels(const Device& device, std::span<const std::byte> records, std::uint32_t row)
    : image_(nullptr), memory_(nullptr), view_(nullptr) {
    guarded("uploading the response tables", [&] {
        const vk::Extent3D extent = extentOf(device, records.size(), row);
        image_ = createImage(device, extent);
        memory_ = allocate(device, image_.getMemoryRequirements(), Access::deviceOnly);
        image_.bindMemory(*memory_, 0);
        const Buffer staging(device, vk::DeviceSize{kRecord} * extent.width * extent.height,
                             Access::hostWrites);
        std::memcpy(staging.mapped().data(), records.data(), records.size());
        fill(device, staging.handle(), *image_, extent);
        view_ = vk::raii::ImageView(device.handle(),
                                    vk::ImageViewCreateInfo({}, *image_, vk::ImageViewType::e2D, kFormat, {},
                                                            {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
    });
}

}  // namespace fringe::gpu
