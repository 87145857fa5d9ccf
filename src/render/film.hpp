// The film: for every pixel of a picture, or of a band of it, the sum of its samples so far, on the device.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compile/interface.hpp"
#include "gpu/kernel.hpp"
#include "image/image.hpp"

namespace fringe::render {

class Film {
public:
    // Room for so many pixels; contents are undefined. Keeps a reference to the device. Throws
    // gpu::DeviceError.
    Film(const gpu::Device& device, std::uint64_t pixels);

    // Pixels that there is room for in so many bytes.
    static std::uint64_t pixelsIn(vk::DeviceSize bytes);

    std::uint64_t pixels() const { return pixelsIn(film_.size()); }

    // From now on its first rows are rows firstRow.. of the picture, without samples; `pixels` of them.
    void clear(std::uint32_t firstRow, std::uint64_t pixels);

    // Appends the means of the first `rows` rows to `pixels`: of each, what belongs to the picture. Black
    // where there is no sample yet.
    void read(const device::Frame& frame, std::uint32_t rows, std::vector<image::Pixel>& pixels);

    const gpu::Buffer& buffer() const { return film_; }

private:
    const gpu::Device& device_;
    gpu::Buffer film_;
    std::optional<gpu::Buffer> readback_;  // only where the film's own memory cannot be read quickly
};

}  // namespace fringe::render
