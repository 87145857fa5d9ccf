// Colour spaces of pictures: the matrices between CIE XYZ and linear RGB, adaptation to a white, and the
// transfer curves of files. XYZ is that of the film: 2 degree observer of 1931, relative to display white,
// whose Y is 1. Everything is double precision; what runs per pixel is in develop.cpp.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace fringe::image {

enum class ColorSpace { srgb, displayP3, rec2020 };

// CIE xy of red, green and blue: IEC 61966-2-1 (sRGB, as Rec. ITU-R BT.709), SMPTE EG 432-1 (Display P3),
// Rec. ITU-R BT.2020.
std::array<glm::dvec2, 3> primaries(ColorSpace space);

// The chromaticity of D65 as these standards round it; files state it.
inline constexpr glm::dvec2 kStandardWhite{0.3127, 0.3290};

// XYZ of display white on the film: D65 as the film integrates it, from 380 to 780 nm. All three spaces
// have it for their white, so that D65 on grey is grey to the last digit.
glm::dvec3 displayWhite();

// Linear RGB to XYZ from the primaries' chromaticities and displayWhite() (SMPTE RP 177), and back.
// Values out of the gamut come out below 0 or above 1.
glm::dmat3 xyzFromLinear(ColorSpace space);
glm::dmat3 linearFromXyz(ColorSpace space);

// XYZ to XYZ: what looks white under `from` becomes `to` (Bradford: Lam 1985, linear as in ICC.1). Nothing
// when a cone response of either is not above 0, as happens with saturated lights: they cannot look white.
std::optional<glm::dmat3> adaptation(const glm::dvec3& from, const glm::dvec3& to);

// The constants of Rec. 2020's curve: the solution of alpha = 1 + 5.5 beta, 4.5 beta = alpha beta^0.45 -
// (alpha - 1), which makes value and slope continuous. The recommendation prints 1.0993 and 0.0181.
inline constexpr double kRec2020Alpha = 1.09929682680944, kRec2020Beta = 0.018053968510807;

// Linear 0..1 to encoded 0..1, and back. sRGB and Display P3: IEC 61966-2-1:1999, section 5.2, with the
// standard's own constants. Rec. 2020: its table 4, with the constants above.
using TransferCurve = double (*)(double);
struct TransferFunction {
    TransferCurve encode, decode;
};
TransferFunction transferFunction(ColorSpace space);

double encodeSrgb(double linear);
double decodeSrgb(double encoded);
double encodeRec2020(double linear);
double decodeRec2020(double encoded);

}  // namespace fringe::image
