#include "optics/color_difference.hpp"

#include <cmath>
#include <numbers>

namespace fringe::optics {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

double compressed(double ratio) {
    constexpr double kCube = 216.0 / 24389.0, kSlope = 24389.0 / 27.0;
    return ratio > kCube ? std::cbrt(ratio) : (kSlope * ratio + 16.0) / 116.0;
}

// In degrees, 0 to 360; 0 for a grey.
double hueOf(double a, double b) {
    const double hue = std::atan2(b, a) / kDegree;
    return hue < 0.0 ? hue + 360.0 : hue;
}

double cosine(double degrees) {
    return std::cos(degrees * kDegree);
}

// x^7/(x^7 + 25^7)
double seventhPower(double x) {
    const double power = std::pow(x, 7.0);
    return power / (power + 6103515625.0);
}

}  // namespace

Lab labFromXyz(const glm::dvec3& xyz, const glm::dvec3& white) {
    const double x = compressed(xyz.x / white.x), y = compressed(xyz.y / white.y),
                 z = compressed(xyz.z / white.z);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

// In the order of G. Sharma, W. Wu and E. N. Dalal, "The CIEDE2000 Color-Difference Formula: Implementation
// Notes, Supplementary Test Data, and Mathematical Observations", Color Res. Appl. 30(1), 2005.
double colorDifference(const Lab& first, const Lab& second) {
    const double meanRaw = 0.5 * (std::hypot(first.a, first.b) + std::hypot(second.a, second.b));
    const double stretch = 1.5 - 0.5 * std::sqrt(seventhPower(meanRaw));
    const double a1 = stretch * first.a, a2 = stretch * second.a;
    const double chroma1 = std::hypot(a1, first.b), chroma2 = std::hypot(a2, second.b);
    const double hue1 = hueOf(a1, first.b), hue2 = hueOf(a2, second.b);
    const bool hasGrey = chroma1 * chroma2 == 0.0;

    double turn = hasGrey ? 0.0 : hue2 - hue1;
    if (turn > 180.0) turn -= 360.0;
    if (turn < -180.0) turn += 360.0;
    const double lightness = second.l - first.l, chroma = chroma2 - chroma1;
    const double hue = 2.0 * std::sqrt(chroma1 * chroma2) * std::sin(0.5 * turn * kDegree);

    const double meanLightness = 0.5 * (first.l + second.l), meanChroma = 0.5 * (chroma1 + chroma2);
    double meanHue = hue1 + hue2;
    if (!hasGrey) {
        if (std::abs(hue1 - hue2) > 180.0) meanHue += meanHue < 360.0 ? 360.0 : -360.0;
        meanHue *= 0.5;
    }
    const double weight = 1.0 - 0.17 * cosine(meanHue - 30.0) + 0.24 * cosine(2.0 * meanHue) +
                          0.32 * cosine(3.0 * meanHue + 6.0) - 0.20 * cosine(4.0 * meanHue - 63.0);
    const double fromBlue = (meanHue - 275.0) / 25.0;
    const double rotation = 30.0 * std::exp(-fromBlue * fromBlue);
    const double fromMiddle = (meanLightness - 50.0) * (meanLightness - 50.0);
    const double lightnessScale = 1.0 + 0.015 * fromMiddle / std::sqrt(20.0 + fromMiddle);
    const double chromaScale = 1.0 + 0.045 * meanChroma;
    const double hueScale = 1.0 + 0.015 * meanChroma * weight;
    const double mixed = -std::sin(2.0 * rotation * kDegree) * 2.0 * std::sqrt(seventhPower(meanChroma));

    const double dl = lightness / lightnessScale, dc = chroma / chromaScale, dh = hue / hueScale;
    return std::sqrt(dl * dl + dc * dc + dh * dh + mixed * dc * dh);
}

}  // namespace fringe::optics
