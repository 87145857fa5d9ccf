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

}  // namespace
}  // namespace fringe::preview
