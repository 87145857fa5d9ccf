// Pixels and pictures: what every renderer delivers and every file format takes.
// Values are linear sRGB, 1 is display white at exposure 0; rows run from the top.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace fringe::image {

struct Pixel {
    float r = 0.0F, g = 0.0F, b = 0.0F;
    bool nonFinite = false;  // a sample was 0/0 by a formula asked for as printed; then rgb is 0
};

struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<Pixel> pixels;  // width * height, row by row

    const Pixel& at(std::uint32_t x, std::uint32_t y) const { return pixels[std::size_t{y} * width + x]; }
};

// Key and value, in the order written; both UTF-8.
using Metadata = std::vector<std::pair<std::string, std::string>>;

}  // namespace fringe::image
