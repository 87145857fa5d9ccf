#include "image/develop.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/matrix.hpp>

#include "image/quantiser.hpp"

namespace fringe::image {

namespace {

double lowestOf(const glm::dvec3& rgb) {
    return std::min({rgb.x, rgb.y, rgb.z});
}

double highestOf(const glm::dvec3& rgb) {
    return std::max({rgb.x, rgb.y, rgb.z});
}

bool isFinite(const glm::dvec3& rgb) {
    return std::isfinite(rgb.x) && std::isfinite(rgb.y) && std::isfinite(rgb.z);
}

bool fits(const glm::dvec3& rgb) {  // false for NaN
    return rgb.x >= 0.0 && rgb.y >= 0.0 && rgb.z >= 0.0 && rgb.x <= 1.0 && rgb.y <= 1.0 && rgb.z <= 1.0;
}

// The share of the chroma at which the lowest channel is 0; for luminance > 0.
double shareAboveZero(const DisplayColor& color) {
    const double lowest = lowestOf(color.rgb);
    return lowest < 0.0 ? color.luminance / (color.luminance - lowest) : 1.0;
}

// The share of the chroma at which the highest channel is 1; for luminance < 1.
double shareBelowOne(const DisplayColor& color) {
    const double highest = highestOf(color.rgb);
    return highest > 1.0 ? (1.0 - color.luminance) / (highest - color.luminance) : 1.0;
}

glm::dvec3 withChroma(const DisplayColor& color, double share) {
    return color.luminance + share * (color.rgb - color.luminance);
}

template <class Code>
void develop(const Quantiser& quantise, const Development& development, std::span<const Pixel> pixels,
             std::span<Code> rgb) {
    assert(rgb.size() == 3 * pixels.size());
    const DisplayTransform displayed(development);
    Code* out = rgb.data();
    for (const Pixel& pixel : pixels) {
        DisplayColor color = displayed(pixel);
        if (development.toneCurve != ToneCurve::linear) color = toned(development.toneCurve, color);
        if (!fits(color.rgb)) color.rgb = intoGamut(color);
        if (pixel.nonFinite) color.rgb = {};
        *out++ = static_cast<Code>(quantise(color.rgb.x));
        *out++ = static_cast<Code>(quantise(color.rgb.y));
        *out++ = static_cast<Code>(quantise(color.rgb.z));
    }
}

}  // namespace

DisplayTransform::DisplayTransform(const Development& development) {
    const glm::dmat3 adapted = std::exp2(development.exposure) * development.whiteBalance;
    rgbFromXyz_ = linearFromXyz(development.colorSpace) * adapted;
    luminanceFromXyz_ = glm::transpose(adapted)[1];
}

DisplayColor toned(ToneCurve curve, const DisplayColor& color) {
    if (!(color.luminance > 0.0)) return color;
    const double luminance = toned(curve, color.luminance);
    if (!isFinite(color.rgb) || !std::isfinite(color.luminance)) return {glm::dvec3(luminance), luminance};
    return {luminance / color.luminance * color.rgb, luminance};
}

glm::dvec3 withoutNegative(const DisplayColor& color) {
    if (!(color.luminance > 0.0)) return {};
    if (!isFinite(color.rgb)) return glm::dvec3(color.luminance);
    return withChroma(color, shareAboveZero(color));
}

glm::dvec3 intoGamut(const DisplayColor& color) {
    if (!(color.luminance > 0.0)) return {};
    if (color.luminance >= 1.0) return glm::dvec3(1.0);
    if (!isFinite(color.rgb)) return glm::dvec3(color.luminance);
    return withChroma(color, std::min(shareAboveZero(color), shareBelowOne(color)));
}

void develop8(const Development& development, std::span<const Pixel> pixels, std::span<std::uint8_t> rgb) {
    static const Quantiser srgb(255, transferFunction(ColorSpace::srgb));
    static const Quantiser rec2020(255, transferFunction(ColorSpace::rec2020));
    develop(development.colorSpace == ColorSpace::rec2020 ? rec2020 : srgb, development, pixels, rgb);
}

void develop16(const Development& development, std::span<const Pixel> pixels, std::span<std::uint16_t> rgb) {
    static const Quantiser srgb(65535, transferFunction(ColorSpace::srgb));
    static const Quantiser rec2020(65535, transferFunction(ColorSpace::rec2020));
    develop(development.colorSpace == ColorSpace::rec2020 ? rec2020 : srgb, development, pixels, rgb);
}

}  // namespace fringe::image
