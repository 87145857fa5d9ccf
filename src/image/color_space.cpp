#include "image/color_space.hpp"

#include <cassert>
#include <cmath>
#include <glm/matrix.hpp>

namespace fringe::image {

namespace {

glm::dvec3 xyzOf(const glm::dvec2& chromaticity) {
    return {chromaticity.x, chromaticity.y, 1.0 - chromaticity.x - chromaticity.y};
}

constexpr double kAlpha = kRec2020Alpha, kBeta = kRec2020Beta;

}  // namespace

std::array<glm::dvec2, 3> primaries(ColorSpace space) {
    switch (space) {
        case ColorSpace::srgb:
            return {{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}};
        case ColorSpace::displayP3:
            return {{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}}};
        case ColorSpace::rec2020:
            return {{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}}};
    }
    assert(false);
    return {};
}

glm::dvec3 displayWhite() {
    return {0.95041981723052, 1.0, 1.08858307046381};
}

glm::dmat3 xyzFromLinear(ColorSpace space) {
    const auto [red, green, blue] = primaries(space);
    const glm::dmat3 directions(xyzOf(red), xyzOf(green), xyzOf(blue));
    const glm::dvec3 amounts = glm::inverse(directions) * displayWhite();  // that add up to white
    return {directions[0] * amounts.x, directions[1] * amounts.y, directions[2] * amounts.z};
}

glm::dmat3 linearFromXyz(ColorSpace space) {
    return glm::inverse(xyzFromLinear(space));
}

std::optional<glm::dmat3> adaptation(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dmat3 conesFromXyz =
        glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
    const glm::dvec3 seen = conesFromXyz * from, wanted = conesFromXyz * to;
    const auto isPositive = [](const glm::dvec3& cones) {
        return cones.x > 0.0 && cones.y > 0.0 && cones.z > 0.0;
    };
    if (!isPositive(seen) || !isPositive(wanted)) return {};
    const glm::dvec3 gain = wanted / seen;
    const glm::dmat3 scaled(gain.x, 0.0, 0.0, 0.0, gain.y, 0.0, 0.0, 0.0, gain.z);
    return glm::inverse(conesFromXyz) * scaled * conesFromXyz;
}

TransferFunction transferFunction(ColorSpace space) {
    if (space == ColorSpace::rec2020) return {encodeRec2020, decodeRec2020};
    return {encodeSrgb, decodeSrgb};
}

double encodeSrgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double decodeSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double encodeRec2020(double linear) {
    return linear < kBeta ? 4.5 * linear : kAlpha * std::pow(linear, 0.45) - (kAlpha - 1.0);
}

double decodeRec2020(double encoded) {
    return encoded < 4.5 * kBeta ? encoded / 4.5 : std::pow((encoded + (kAlpha - 1.0)) / kAlpha, 1.0 / 0.45);
}

}  // namespace fringe::image
