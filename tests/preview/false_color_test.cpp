// Luminance as colours by decades.
#include "preview/false_color.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace fringe::preview {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

Rgb shown(const image::Pixel& pixel, double exposure = 0.0) {
    Rgb rgb{};
    falseColors({&pixel, 1}, exposure, rgb);
    return rgb;
}

image::Pixel luminous(double luminance) {
    return {0.0F, static_cast<float>(luminance), 0.0F, false};
}

TEST(FalseColors, EveryDecadeHasItsOwn) {
    for (const Decade& decade : decades()) {
        const double justBelowTheNext = 9.999 * std::pow(10.0, decade.exponent);
        const Rgb rgb = shown(luminous(justBelowTheNext));
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(rgb.at(i), decade.color.at(i), 1) << decade.exponent;
    }
}

TEST(FalseColors, GetBrighterWithinADecade) {
    EXPECT_LT(shown(luminous(0.2))[0], shown(luminous(0.8))[0]);
}

TEST(FalseColors, EndInBlackAndWhite) {
    EXPECT_EQ(shown(luminous(0.0)), (Rgb{0, 0, 0}));
    EXPECT_EQ(shown(luminous(1e-8)), (Rgb{0, 0, 0}));
    EXPECT_EQ(shown(luminous(1e3)), (Rgb{255, 255, 255}));
    EXPECT_EQ(shown({.nonFinite = true}), (Rgb{128, 128, 128}));
}

TEST(FalseColors, FollowTheExposure) {
    EXPECT_EQ(shown(luminous(0.5), 3.0), shown(luminous(4.0)));
}

std::array<std::uint8_t, 3> tinted(double y, const glm::dvec3& color, const image::Development& development) {
    const image::Pixel pixel{0.0F, static_cast<float>(y), 0.0F, false};
    std::array<std::uint8_t, 3> rgb{};
    tint({&pixel, 1}, development, color, rgb);
    return rgb;
}

TEST(Tint, IsTheColorOfItsWavelength) {
    const auto strongest = [](double wavelength_nm) {
        const glm::dvec3 color = tintOf(wavelength_nm);
        EXPECT_EQ(std::max({color.x, color.y, color.z}), 1.0);
        EXPECT_GE(std::min({color.x, color.y, color.z}), 0.0);
        return color.x == 1.0 ? 'r' : color.y == 1.0 ? 'g' : 'b';
    };
    EXPECT_EQ(strongest(650.0), 'r');
    EXPECT_EQ(strongest(530.0), 'g');
    EXPECT_EQ(strongest(450.0), 'b');
}

TEST(Tint, FollowsExposureAndToneCurve) {
    using Code = std::array<std::uint8_t, 3>;
    const glm::dvec3 white(1.0), green(0.0, 1.0, 0.0);
    EXPECT_EQ(tinted(0.25, white, {.exposure = 1.0}), (Code{188, 188, 188}));
    EXPECT_EQ(tinted(0.25, green, {.exposure = 1.0}), (Code{0, 188, 0}));
    EXPECT_EQ(tinted(9.0, green, {}), (Code{0, 255, 0}));
    EXPECT_LT(tinted(4.0, green, {.toneCurve = image::ToneCurve::reinhard})[1], 255);
    EXPECT_EQ(tinted(-1.0, white, {}), (Code{0, 0, 0}));
}

}  // namespace
}  // namespace fringe::preview
