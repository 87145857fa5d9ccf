#include "preview/false_color.hpp"

#include <algorithm>
#include <cmath>

#include "image/color_space.hpp"
#include "optics/color.hpp"
#include "preview/switches.hpp"

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

void spreadOverColors(std::span<image::Pixel> pixels) {
    constexpr auto kFactor =
        static_cast<float>((optics::kLongestVisible_nm - optics::kShortestVisible_nm) / kBand_nm);
    for (image::Pixel& pixel : pixels) {
        pixel.x *= kFactor;
        pixel.y *= kFactor;
        pixel.z *= kFactor;
    }
}

glm::dvec3 tintOf(double wavelength_nm) {
    const glm::dvec3 linear =
        image::linearFromXyz(image::ColorSpace::srgb) * optics::colorMatching(wavelength_nm);
    const glm::dvec3 shown = glm::max(linear, 0.0);
    return shown / std::max({shown.x, shown.y, shown.z});
}

void tint(std::span<const image::Pixel> pixels, const image::Development& development,
          const glm::dvec3& color, std::span<std::uint8_t> rgb) {
    const double factor = std::exp2(development.exposure);
    std::uint8_t* out = rgb.data();
    for (const image::Pixel& pixel : pixels) {
        const double light = pixel.nonFinite ? 0.0 : std::max(factor * double{pixel.y}, 0.0);
        const double brightness = std::min(image::toned(development.toneCurve, light), 1.0);
        for (int i = 0; i < 3; ++i)
            *out++ = static_cast<std::uint8_t>(std::lround(255.0 * image::encodeSrgb(brightness * color[i])));
    }
}

}  // namespace fringe::preview
