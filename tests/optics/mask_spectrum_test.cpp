// The table of a mask's far field against the sum over its pixels and against closed shapes.
#include "optics/mask_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "optics/energy.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {
namespace {

using namespace units;
using glm::dvec2;

MaskAperture openMask(std::uint32_t columns, std::uint32_t rows) {
    return {columns, rows, 1 * um, std::vector<float>(std::size_t{columns} * rows, 1.0F)};
}

// Largest error over frequencies within the first zeros and over all of visible light, relative to the peak.
double largestError(const MaskAperture& mask) {
    const MaskSpectrum spectrum(gridOf(mask));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    double largest = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double scale = i % 2 == 0 ? 4e6 : 2e6 / mask.columns;
        const dvec2 f(scale * uniform(random), scale * uniform(random));
        const double expected = std::norm(transform(mask, f)) / spectrum.peak();
        largest = std::max(largest, std::abs(spectrum.relativePower(f) - expected));
    }
    return largest;
}

TEST(MaskSpectrum, IsTheSumOverThePixels) {
    EXPECT_LT(largestError(openMask(16, 12)), 5e-5);
    EXPECT_LT(largestError(openMask(1, 1)), 5e-5);
    EXPECT_LT(largestError(openMask(5, 64)), 5e-5);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
    MaskAperture noise = openMask(60, 37);
    for (float& transmission : noise.transmission) transmission = uniform(random);
    EXPECT_LT(largestError(noise), 5e-5);
}

// The largest lags alias most: (1/7)^4 + (1/9)^4 along an axis at eight points to a pixel.
TEST(MaskSpectrum, OfLonePixelsStaysWithinItsBound) {
    MaskAperture corners = openMask(32, 32);
    std::fill(corners.transmission.begin(), corners.transmission.end(), 0.0F);
    for (const std::size_t at : {std::size_t{0}, std::size_t{31}, std::size_t{32 * 31}})
        corners.transmission[at] = 1.0F;
    EXPECT_LT(largestError(corners), 5e-4);
}

TEST(MaskSpectrum, HasItsPeakAndItsMirrorImage) {
    MaskAperture mask = openMask(9, 14);
    mask.transmission[20] = 0.25F;
    const MaskSpectrum spectrum(gridOf(mask));
    EXPECT_NEAR(spectrum.relativePower({0.0, 0.0}), 1.0, 5e-5);
    EXPECT_NEAR(spectrum.peak(), std::pow(125.25e-12, 2), 1e-30);
    for (const dvec2 f : {dvec2(3e4, 7e4), dvec2(-8e5, 6e5), dvec2(1e6, 0)})
        EXPECT_NEAR(spectrum.relativePower(f), spectrum.relativePower(-f), 1e-6);  // single precision
}

TEST(MaskSpectrum, ShareIsThatOfTheShape) {
    for (const auto& [alpha, beta] : {std::pair{0.0, 0.0}, {0.2, -0.5}}) {
        for (const std::uint32_t columns : {2U, 20U, 80U}) {
            const RectangularAperture shape{columns * um, 1.5 * columns * um};
            EXPECT_NEAR(MaskSpectrum(gridOf(openMask(columns, 3 * columns / 2)))
                            .propagatingShare(550 * nm, alpha, beta),
                        propagatingShare(shape, 550 * nm, alpha, beta), columns < 5 ? 1e-3 : 1e-4);
        }
        // Wider than 200 wavelengths: the law of the edges, which are exact here.
        const RectangularAperture wide{300 * um, 200 * um};
        const MaskAperture mask = openMask(300, 200);
        EXPECT_NEAR(propagatingShare(mask, 550 * nm, alpha, beta),
                    propagatingShare(wide, 550 * nm, alpha, beta), 1e-5);
    }
}

}  // namespace
}  // namespace fringe::optics
