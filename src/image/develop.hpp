// Develop: linear sRGB to the code values that a display and a PNG file take. The one implementation,
// so that every picture of the program, on the screen or in a file, shows the same values.
//
// A channel value v becomes round(max * encodeSrgb(clamp(v * 2^exposure, 0, 1))), where max is 255 or
// 65535 and halves round up. The result is that of this formula in double precision.
// NaN and negative values give 0, +infinity gives max; a pixel marked nonFinite is black.
#pragma once

#include <cstdint>
#include <span>

#include "image/image.hpp"

namespace fringe::image {

// The sRGB transfer function, IEC 61966-2-1:1999, section 5.2: linear 0..1 to encoded 0..1.
double encodeSrgb(double linear);

// Its inverse, with the standard's own constants: encoded 0..1 to linear 0..1.
double decodeSrgb(double encoded);

// Develop pixels at an exposure in stops (0: 1.0 is display white) into red, green, blue, red, ...;
// rgb holds 3 * pixels.size() values.
void develop8(std::span<const Pixel> pixels, double exposure, std::span<std::uint8_t> rgb);
void develop16(std::span<const Pixel> pixels, double exposure, std::span<std::uint16_t> rgb);

}  // namespace fringe::image
