#include "render/film.hpp"

#include <algorithm>
#include <iterator>
#include <span>

namespace fringe::render {
namespace {

constexpr vk::DeviceSize kHeader = sizeof(std::uint32_t);  // FilmBlock.firstRow

vk::DeviceSize bytesFor(std::uint64_t pixels) {
    return kHeader + pixels * sizeof(device::FilmPixel);
}

image::Pixel resolve(const device::FilmPixel& pixel) {
    const std::uint32_t samples = pixel.state & ~device::NON_FINITE;
    if ((pixel.state & device::NON_FINITE) != 0) return {.nonFinite = true};
    if (samples == 0) return {};  // a cancelled render did not come this far
    const glm::vec3 mean = pixel.sum / static_cast<float>(samples);
    return {mean.x, mean.y, mean.z, false};
}

}  // namespace

Film::Film(const gpu::Device& device, std::uint64_t pixels)
    : device_(device),
      film_(device, bytesFor(pixels),
            gpu::hasSharedMemory(device) ? gpu::Access::shared : gpu::Access::deviceOnly) {
    if (film_.mapped().empty()) readback_.emplace(device, film_.size(), gpu::Access::hostReads);
}

std::uint64_t Film::pixelsIn(vk::DeviceSize bytes) {
    return (bytes - kHeader) / sizeof(device::FilmPixel);
}

void Film::clear(std::uint32_t firstRow, std::uint64_t pixels) {
    gpu::clear(device_, film_.handle(), firstRow, bytesFor(pixels));
}

void Film::read(const device::Frame& frame, std::uint32_t rows, std::vector<image::Pixel>& pixels) {
    const std::uint64_t count = std::uint64_t{rows} * frame.filmWidth;
    if (readback_) gpu::copy(device_, {film_.handle(), readback_->handle(), bytesFor(count)});
    const gpu::Buffer& readable = readback_ ? *readback_ : film_;
    const std::span film(reinterpret_cast<const device::FilmPixel*>(readable.mapped().data() + kHeader),
                         count);
    pixels.reserve(pixels.size() + std::size_t{rows} * frame.width);
    for (std::uint32_t row = 0; row < rows; ++row) {
        const auto used = film.subspan(std::size_t{row} * frame.filmWidth, frame.width);
        std::transform(used.begin(), used.end(), std::back_inserter(pixels), resolve);
    }
}

}  // namespace fringe::render
