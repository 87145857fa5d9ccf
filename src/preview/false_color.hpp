// Pictures in other colours than theirs: luminance in decades, and the light of one wavelength.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "image/develop.hpp"

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

// The radiance of a band of kBand_nm as that of the whole visible range if it were the same in all of it:
// then white in daylight is about as bright as in colour.
void spreadOverColors(std::span<image::Pixel> pixels);

// Linear sRGB of light of this wavelength, as strong as it can be shown.
glm::dvec3 tintOf(double wavelength_nm);

// The y of the film as brightness of one colour, by exposure and tone curve; what is above 1 is as 1.
void tint(std::span<const image::Pixel> pixels, const image::Development& development,
          const glm::dvec3& color, std::span<std::uint8_t> rgb);

}  // namespace fringe::preview
