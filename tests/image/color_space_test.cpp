// Matrices against published ones and against what defines them; transfer curves against their standards;
// adaptation against Little CMS.
#include "image/color_space.hpp"

#include <gtest/gtest.h>
#include <lcms2.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "optics/color.hpp"
#include "optics/sources.hpp"

namespace fringe::image {
namespace {

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double bound) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], bound) << i;
}

class Space : public testing::TestWithParam<ColorSpace> {};
INSTANTIATE_TEST_SUITE_P(All, Space,
                         testing::Values(ColorSpace::srgb, ColorSpace::displayP3, ColorSpace::rec2020));

// The two properties that define the matrix. 1e-14: a few roundings of numbers near 1.
TEST_P(Space, PrimariesHaveTheirChromaticitiesAndAddUpToWhite) {
    const glm::dmat3 matrix = xyzFromLinear(GetParam());
    for (int i = 0; i < 3; ++i) {
        const double sum = matrix[i].x + matrix[i].y + matrix[i].z;
        EXPECT_NEAR(matrix[i].x / sum, primaries(GetParam())[static_cast<std::size_t>(i)].x, 1e-14);
        EXPECT_NEAR(matrix[i].y / sum, primaries(GetParam())[static_cast<std::size_t>(i)].y, 1e-14);
    }
    expectNear(matrix * glm::dvec3(1.0), displayWhite(), 1e-14);
    expectNear(linearFromXyz(GetParam()) * displayWhite(), glm::dvec3(1.0), 1e-14);
}

// The film's white is within 4e-5 of the standards' rounded chromaticity, which moves Z of white by 5e-4.
TEST(DisplayWhite, IsTheStandardsBeforeRounding) {
    const glm::dvec3 white = displayWhite();
    const double sum = white.x + white.y + white.z;
    EXPECT_NEAR(white.x / sum, kStandardWhite.x, 6e-5);
    EXPECT_NEAR(white.y / sum, kStandardWhite.y, 6e-5);
    EXPECT_EQ(white.y, 1.0);
}

// The number written down here and the integral over the tables: 1e-12 for the roundings of 400 terms.
TEST(DisplayWhite, IsThatOfTheSpectralTables) {
    const optics::Spectrum d65 = optics::normalised(optics::namedSpectrum("D65").value());
    expectNear(displayWhite(), optics::xyzPerWatt(d65, optics::constantCurve(1.0)), 1e-12);
    for (int i = 0; i < 3; ++i)
        expectNear(xyzFromLinear(ColorSpace::srgb)[i], optics::xyzFromLinearSrgb()[i], 1e-12);
}

// Luminance of the primaries as the standards print them: IEC 61966-2-1, SMPTE EG 432-1, Rec. ITU-R BT.2020;
// the other rows as in CSS Color 4. 5e-4 as above.
TEST(PublishedMatrices, AreThese) {
    const glm::dmat3 srgb = glm::transpose(xyzFromLinear(ColorSpace::srgb));
    expectNear(srgb[0], {0.4124, 0.3576, 0.1805}, 5e-4);
    expectNear(srgb[1], {0.2126, 0.7152, 0.0722}, 2e-4);
    expectNear(srgb[2], {0.0193, 0.1192, 0.9505}, 5e-4);
    const glm::dmat3 displayP3 = glm::transpose(xyzFromLinear(ColorSpace::displayP3));
    expectNear(displayP3[0], {0.4866, 0.2657, 0.1982}, 5e-4);
    expectNear(displayP3[1], {0.2290, 0.6917, 0.0793}, 2e-4);
    expectNear(displayP3[2], {0.0, 0.0451, 1.0439}, 5e-4);
    const glm::dmat3 rec2020 = glm::transpose(xyzFromLinear(ColorSpace::rec2020));
    expectNear(rec2020[0], {0.6370, 0.1446, 0.1689}, 5e-4);
    expectNear(rec2020[1], {0.2627, 0.6780, 0.0593}, 2e-4);
    expectNear(rec2020[2], {0.0, 0.0281, 1.0610}, 5e-4);
}

// Illuminant A and a greenish lamp. Little CMS has the same matrix of Bradford's, rounded to four digits too,
// but computes in its own way: 1e-9 for a few more roundings than ours.
TEST(Adaptation, IsThatOfLittleCms) {
    for (const glm::dvec3 from : {glm::dvec3(1.09850, 1.0, 0.35585), glm::dvec3(0.9, 1.0, 0.8)}) {
        const glm::dvec3 to = displayWhite();
        const glm::dmat3 matrix = adaptation(from, to).value();
        expectNear(matrix * from, to, 1e-14);
        const cmsCIEXYZ source{from.x, from.y, from.z}, target{to.x, to.y, to.z};
        for (const glm::dvec3 color : {glm::dvec3(0.2, 0.3, 0.1), glm::dvec3(0.5, 0.2, 0.02)}) {
            const cmsCIEXYZ given{color.x, color.y, color.z};
            cmsCIEXYZ adapted;
            ASSERT_TRUE(cmsAdaptToIlluminant(&adapted, &source, &target, &given));
            expectNear(matrix * color, {adapted.X, adapted.Y, adapted.Z}, 1e-9);
        }
    }
}

TEST(Adaptation, ToTheSameWhiteChangesNothing) {
    const glm::dmat3 matrix = adaptation(displayWhite(), displayWhite()).value();
    for (int i = 0; i < 3; ++i) expectNear(matrix[i], glm::dmat3(1.0)[i], 1e-14);
}

// 1e-15 is a few roundings of a value up to 1. At sRGB's breakpoints, which the standard rounds to 0.0031308
// and 0.04045, its two branches are 2.9e-8 apart.
TEST_P(Space, DecodeInvertsEncode) {
    const auto [encode, decode] = transferFunction(GetParam());
    for (int i = 0; i <= 4096; ++i) {
        const double encoded = i / 4096.0;
        EXPECT_NEAR(encode(decode(encoded)), encoded, 1e-15) << encoded;
    }
    EXPECT_NEAR(encodeSrgb(decodeSrgb(0.04045)), 0.04045, 3e-8);
}

// Rec. ITU-R BT.2020, table 4, evaluated by hand with its own constants for 12 bits, which are rounded to
// 1e-4.
TEST(TransferFunction, KnownValuesOfRec2020) {
    EXPECT_DOUBLE_EQ(encodeRec2020(0.01), 0.045);
    EXPECT_NEAR(encodeRec2020(0.18), 1.0993 * std::pow(0.18, 0.45) - 0.0993, 1e-4);
    EXPECT_NEAR(encodeRec2020(0.5), 1.0993 * std::pow(0.5, 0.45) - 0.0993, 1e-4);
    EXPECT_NEAR(encodeRec2020(1.0), 1.0, 1e-15);
}

// Value and slope meet where the branches do, which is how alpha and beta are defined.
TEST(TransferFunction, Rec2020IsSmooth) {
    const double below = encodeRec2020(kRec2020Beta * (1.0 - 1e-15)), at = encodeRec2020(kRec2020Beta);
    EXPECT_NEAR(below, at, 1e-13);
    const double slope = 0.45 * kRec2020Alpha * std::pow(kRec2020Beta, 0.45 - 1.0);
    EXPECT_NEAR(slope, 4.5, 1e-12);
}

// A laser of 470 nm, by the colour-matching functions: the long cones see less than nothing of it.
TEST(Adaptation, OfASaturatedLightThereIsNone) {
    EXPECT_FALSE(adaptation({0.1954, 0.0910, 1.2876}, displayWhite()));
    EXPECT_FALSE(adaptation(displayWhite(), glm::dvec3(0.0)));
}

}  // namespace
}  // namespace fringe::image
