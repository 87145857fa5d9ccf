#include "preview/false_color.hpp"

#include <cmath>

namespace fringe::preview {
namespace {

constexpr std::array<Decade, 8> kDecades{{{1, {255, 255, 160}},
                                          {0, {255, 200, 60}},
                                          {-1, {250, 120, 60}},
                                          {-2, {225, 70, 130}},
                                          {-3, {150, 70, 200}},
                                          {-4, {70, 90, 230}},
                                          {-5, {50, 160, 200}},
                                          {-6, {60, 170, 90}}}};

std::array<std::uint8_t, 3> colorOf(double luminance) {
    if (!(luminance > 0.0)) return {0, 0, 0};
    const double decade = std::log10(luminance);
    const int exponent = static_cast<int>(std::floor(decade));
    if (exponent > kDecades.front().exponent) return {255, 255, 255};
    if (exponent < kDecades.back().exponent) return {0, 0, 0};
    std::array<std::uint8_t, 3> color =
        kDecades.at(static_cast<std::size_t>(kDecades.front().exponent - exponent)).color;
    const double brightness = 0.5 + 0.5 * (decade - exponent);
    for (std::uint8_t& channel : color)
        channel = static_cast<std::uint8_t>(std::lround(brightness * double{1.0} * channel));
    return color;
}

}  // namespace

std::span<const Decade> decades() {
    return kDecades;
}

void falseColors(std::span<const image::Pixel> pixels, double exposure, std::span<std::uint8_t> rgb) {
    const double factor = std::exp2(exposure);
    std::uint8_t* out = rgb.data();
    for (const image::Pixel& pixel : pixels) {
        const auto color =
            pixel.nonFinite ? std::array<std::uint8_t, 3>{128, 128, 128} : colorOf(factor * double{pixel.y});
        for (const std::uint8_t channel : color) *out++ = channel;
    }
}

}  // namespace fringe::preview
