// Luminance as colours, a decade each: what an exposure cannot show at once.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "image/image.hpp"

namespace fringe::preview {

// From the brightest decade, 10 to 100 times display white, downwards; sRGB. Within its decade a colour goes
// from half as bright to full.
struct Decade {
    int exponent;  // luminance relative to display white, from 10^exponent to ten times that
    std::array<std::uint8_t, 3> color;
};
std::span<const Decade> decades();

// What is below the last decade is black, what is above the first is white; a pixel marked nonFinite is grey.
// rgb holds 3 * pixels.size() values.
void falseColors(std::span<const image::Pixel> pixels, double exposure, std::span<std::uint8_t> rgb);

}  // namespace fringe::preview
