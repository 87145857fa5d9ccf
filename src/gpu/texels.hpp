// Many records of four 32-bit unsigned integers that shaders read by their number, as texels of a buffer or
// of an image. Drivers for processors fetch all four numbers of a texel at once, those of a storage buffer
// one by one.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "gpu/buffer.hpp"
#include "gpu/kernel.hpp"

namespace fringe::gpu {

enum class TexelHome {
    buffer,  // record i is texel i
    image,   // record i is texel (i % row, i / row)
};

// Whether the device reads so many bytes of records from a buffer.
bool fitTexelBuffer(const Device& device, std::size_t bytes);

class Texels {
public:
    // Whole records, of 16 bytes each, and the byte where the first of them is to be.
    struct Part {
        std::size_t offset;
        std::span<const std::byte> records;
    };

    // The parts follow one another; none at all become one texel of any value. `row` is at most 4096, which
    // every device has; `what` names the records in errors. Precondition: they fit their home, if that is a
    // buffer. Throws DeviceError when memory is short or the device has no image so large.
    Texels(const Device& device, const std::string& what, std::span<const Part> parts, TexelHome home,
           std::uint32_t row);

    // How many bytes of records write() has room for; none in an image.
    std::size_t room() const { return home_ == TexelHome::buffer ? buffer_.size() : 0; }

    // Other records in place of those there. Precondition: there is room, and the device reads none just now.
    void write(const Part& part) const;

    // The records are in one of the two, and the other is one texel of any value: a shader that can read
    // either is bound to both.
    Binding buffer() const;
    Binding image() const;

private:
    TexelHome home_;
    Buffer buffer_;
    vk::raii::Image image_;
    vk::raii::DeviceMemory memory_;  // of image_
    vk::raii::ImageView view_;
};

}  // namespace fringe::gpu
