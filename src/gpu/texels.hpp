// Many records of four 32-bit unsigned integers that shaders read by their number, as an image. Drivers for
// processors fetch all four numbers of an image's texel at once, those of a buffer one by one.
#pragma once

#include <cstddef>
#include <span>

#include "gpu/device.hpp"

namespace fringe::gpu {

class Texels {
public:
    // Record i becomes texel (i % row, i / row); `records` holds whole ones, of 16 bytes; none at all become
    // one texel of any value. `row` is at most 4096, which every device has. Throws DeviceError when memory
    // is short or the device has no image so large.
    Texels(const Device& device, std::span<const std::byte> records, std::uint32_t row);

    vk::ImageView view() const { return *view_; }

private:
    vk::raii::Image image_;
    vk::raii::DeviceMemory memory_;  // of image_
    vk::raii::ImageView view_;
};

}  // namespace fringe::gpu
