// Pixels and pictures: what every renderer delivers and every file format takes, and what is read back.
// Rows run from the top.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace fringe::image {

// What a picture shows.
enum class Quantity {
    color,      // CIE XYZ relative to display white, whose Y is 1 at exposure 0
    luminance,  // cd/m^2
    radiance,   // W/(m^2 sr) of visible light
    irradiance  // W/m^2 of visible light, on the surface that a pixel shows
};

// "color", "luminance", ...: the name of the channel in a file, and of the option.
const char* nameOf(Quantity quantity);

// "cd/m^2", ...; empty for a colour.
const char* unitOf(Quantity quantity);

// Of the film. A renderer asked for radiance or irradiance puts it into y.
struct Pixel {
    float x = 0.0F, y = 0.0F, z = 0.0F;
    bool nonFinite = false;  // a sample was 0/0 by a formula asked for as printed; then xyz is 0
};

struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<Pixel> pixels;  // width * height, row by row

    const Pixel& at(std::uint32_t x, std::uint32_t y) const { return pixels[std::size_t{y} * width + x]; }
};

// Of a file. Linear sRGB; the value itself, three times, where the quantity is no colour.
struct RgbPixel {
    float r = 0.0F, g = 0.0F, b = 0.0F;
    bool nonFinite = false;
};

struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    Quantity quantity = Quantity::color;
    std::vector<RgbPixel> pixels;  // width * height, row by row

    const RgbPixel& at(std::uint32_t x, std::uint32_t y) const { return pixels[std::size_t{y} * width + x]; }
};

// Key and value, in the order written; both UTF-8.
using Metadata = std::vector<std::pair<std::string, std::string>>;

}  // namespace fringe::image
