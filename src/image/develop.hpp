// Develop: the film's XYZ to the code values that a display and a PNG file take. The one implementation, so
// that every picture of the program, on the screen or in a file, shows the same values.
//
// The steps, all in double precision: white balance and exposure; XYZ to linear RGB of the colour space; tone
// curve (of the luminance, all channels by the same factor); gamut mapping; transfer curve; rounding to max =
// 255 or 65535, halves up. A colour whose channels then all lie in 0..1 is not mapped: it becomes round(max *
// encode(channel)).
//
// Gamut mapping keeps the luminance and goes along the straight line to the grey of that luminance, as far as
// it takes for the last channel to fit into 0..1: the dominant wavelength stays and no channel is clipped.
// What is brighter than white is white, and since less and less chroma fits on the way there, a colour fades
// into it without a step. Luminance that is 0, negative or NaN is black; a colour whose other channels are
// not finite is grey of its luminance; a pixel marked nonFinite is black.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "image/color_space.hpp"
#include "image/image.hpp"
#include "image/tone_curve.hpp"

namespace fringe::image {

struct Development {
    ColorSpace colorSpace = ColorSpace::srgb;
    double exposure = 0.0;  // stops: light is multiplied by 2^exposure
    ToneCurve toneCurve = ToneCurve::linear;
    glm::dmat3 whiteBalance{1.0};  // XYZ to XYZ: adaptation(white of the scene, displayWhite())
};

// What a pixel sends to the display before it is fitted into the gamut.
struct DisplayColor {
    glm::dvec3 rgb;    // linear, in the colour space
    double luminance;  // 1: that of display white
};

// Film to display, for all pixels of a picture: white balance, exposure and colour space in one matrix.
class DisplayTransform {
public:
    explicit DisplayTransform(const Development& development);

    DisplayColor operator()(const Pixel& pixel) const {
        const glm::dvec3 xyz(pixel.x, pixel.y, pixel.z);
        const double luminance = glm::dot(luminanceFromXyz_, xyz);
        // An infinite x times a weight of 0 is NaN; then y alone tells.
        return {rgbFromXyz_ * xyz, std::isfinite(luminance) ? luminance : luminanceFromXyz_.y * xyz.y};
    }

private:
    glm::dmat3 rgbFromXyz_;
    glm::dvec3 luminanceFromXyz_;
};

// The colour as the curve has it: another luminance, the same chromaticity.
DisplayColor toned(ToneCurve curve, const DisplayColor& color);

// The colour of the same luminance and dominant wavelength with no channel below 0.
glm::dvec3 withoutNegative(const DisplayColor& color);

// The same with no channel above 1 either.
glm::dvec3 intoGamut(const DisplayColor& color);

// Develop pixels into red, green, blue, red, ...; rgb holds 3 * pixels.size() values.
void develop8(const Development& development, std::span<const Pixel> pixels, std::span<std::uint8_t> rgb);
void develop16(const Development& development, std::span<const Pixel> pixels, std::span<std::uint16_t> rgb);

}  // namespace fringe::image
