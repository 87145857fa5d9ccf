#include "optics/sources.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "optics/color.hpp"

namespace fringe::optics {
namespace {

struct Chromaticity {
    double x, y;
};

Chromaticity chromaticity(glm::dvec3 xyz) {
    return {xyz.x / (xyz.x + xyz.y + xyz.z), xyz.y / (xyz.x + xyz.y + xyz.z)};
}

// Index of standard air: Edlen, Metrologia 2, 71 (1966).
double indexOfAir(double wavelength_nm) {
    const double squared_per_um2 = 1e6 / (wavelength_nm * wavelength_nm);
    return 1.0 +
           1e-8 * (8342.13 + 2406030.0 / (130.0 - squared_per_um2) + 15997.0 / (38.9 - squared_per_um2));
}

double waveNumber_per_cm(const Line& line) {
    const double wavelength_nm = line.wavelength / units::nm;
    return 1e7 / (wavelength_nm * indexOfAir(wavelength_nm));
}

TEST(Sources, HaveOneVisibleWatt) {
    for (const std::string_view name : namedSpectra())
        EXPECT_NEAR(visiblePower(namedSpectrum(name).value()), 1.0, 1e-12) << name;
    for (const double kelvin : {50.0, 1000.0, 6500.0, 1e6})
        EXPECT_NEAR(visiblePower(planck(kelvin)), 1.0, 1e-12) << kelvin;
    EXPECT_NEAR(visiblePower(led(470.0 * units::nm, 25.0 * units::nm)), 1.0, 1e-12);
    EXPECT_NEAR(visiblePower(led(380.0 * units::nm, 0.1 * units::nm)), 1.0, 1e-12);
    EXPECT_NEAR(visiblePower(laser(632.8 * units::nm, {})), 1.0, 1e-12);
    EXPECT_NEAR(visiblePower(laser(780.0 * units::nm, 1.0 * units::nm)), 1.0, 1e-12);
}

TEST(Sources, OtherNamesHaveNone) {
    EXPECT_FALSE(namedSpectrum("d65"));
    EXPECT_FALSE(namedSpectrum(""));
}

// CIE 15:2018 publishes chromaticities (2 degrees) as sums over 5 nm, with five decimals, four for lamps. The
// same sums over our tables are those, to the rounding of the last decimal and 1e-5 for what lies outside 380
// to 780 nm. The integral of what is linear in between is another number: most so for lamps with lines.
TEST(Sources, HaveTheirPublishedChromaticities) {
    constexpr double kSmooth = 1.5e-5;
    constexpr double kLamp = 6e-5;
    const struct {
        const char* name;
        Chromaticity published;
        double ofSum;
        double ofIntegral;
    } lamps[] = {
        {"A", {0.44758, 0.40745}, kSmooth, 3e-5},   {"D50", {0.34567, 0.35851}, kSmooth, 3e-5},
        {"D65", {0.31272, 0.32903}, kSmooth, 3e-5}, {"E", {0.33333, 0.33333}, kSmooth, 3e-5},
        {"F2", {0.3721, 0.3751}, kLamp, 3e-4},      {"F7", {0.3129, 0.3292}, kLamp, 3e-4},
        {"F11", {0.3805, 0.3769}, kLamp, 3e-4},     {"LED-B3", {0.3756, 0.3723}, kLamp, 3e-4},
    };
    for (const auto& lamp : lamps) {
        const Spectrum spectrum = namedSpectrum(lamp.name).value();
        glm::dvec3 sum(0.0);
        for (int l_nm = 380; l_nm <= 780; l_nm += 5)
            sum += valueAt(spectrum.density, l_nm) * colorMatching(l_nm);
        EXPECT_NEAR(chromaticity(sum).x, lamp.published.x, lamp.ofSum) << lamp.name;
        EXPECT_NEAR(chromaticity(sum).y, lamp.published.y, lamp.ofSum) << lamp.name;
        const Chromaticity integral = chromaticity(xyzPerWatt(spectrum, constantCurve(1.0)));
        EXPECT_NEAR(integral.x, lamp.published.x, lamp.ofIntegral) << lamp.name;
        EXPECT_NEAR(integral.y, lamp.published.y, lamp.ofIntegral) << lamp.name;
    }
}

TEST(Planck, IsWiensLawWhereTheQuantumIsLarge) {
    // At 1000 K exp(-c2/(wavelength T)) is below 1e-8: Wien's law holds to that.
    const Spectrum spectrum = planck(1000.0);
    const auto wien = [](double l_nm) {
        return std::pow(l_nm, -5.0) * std::exp(-1.438776877e7 / (l_nm * 1000.0));
    };
    for (const double wavelength_nm : {380.0, 500.0, 650.0})
        EXPECT_NEAR(valueAt(spectrum.density, wavelength_nm) / valueAt(spectrum.density, 780.0) /
                        (wien(wavelength_nm) / wien(780.0)),
                    1.0, 1e-7);
}

TEST(Planck, IsRayleighsLawWhereTheQuantumIsSmall) {
    // 1e8 K: c2/(wavelength T) is 4e-4 at most, and half of it is the law's first correction.
    const Spectrum spectrum = planck(1e8);
    EXPECT_NEAR(valueAt(spectrum.density, 400.0) / valueAt(spectrum.density, 700.0), std::pow(7.0 / 4.0, 4.0),
                std::pow(7.0 / 4.0, 4.0) * 2e-4);
}

TEST(Planck, HasItsMaximumWhereWiensDisplacementLawSays) {
    // 2.897771955e-3 m K at 5000 K: 579.55 nm; knots are 1 nm apart.
    const Spectrum spectrum = planck(5000.0);
    double best_nm = 0.0;
    for (const Knot& knot : spectrum.density) {
        if (knot.value > valueAt(spectrum.density, best_nm)) best_nm = knot.wavelength_nm;
    }
    EXPECT_NEAR(best_nm, 579.55, 1.0);
}

TEST(Planck, IsIlluminantAAt2856Kelvin) {
    // The ratio of the second radiation constants moves the temperature of A, 2848 K, to 2855.496 K.
    const Spectrum hot = planck(2848.0 * 1.438776877 / 1.435);
    const Spectrum a = namedSpectrum("A").value();
    for (double l_nm = 380.0; l_nm <= 780.0; l_nm += 20.0)
        EXPECT_NEAR(valueAt(hot.density, l_nm) / valueAt(a.density, l_nm), 1.0, 1e-12);
    // CIE 15: 100 at 560 nm, 9.795100 at 380 nm, 241.675 at 780 nm, six figures.
    EXPECT_NEAR(valueAt(a.density, 380.0) / valueAt(a.density, 560.0), 0.0979510, 1e-6);
    EXPECT_NEAR(valueAt(a.density, 780.0) / valueAt(a.density, 560.0), 2.41675, 1e-5);
}

TEST(Led, IsAGaussian) {
    const Spectrum spectrum = led(530.0 * units::nm, 30.0 * units::nm);
    const double peak = 2.0 * std::sqrt(std::numbers::ln2 / std::numbers::pi) / 30.0;
    // 3e-4 of the peak is what chords of a twentieth of the deviation leave out.
    EXPECT_NEAR(valueAt(spectrum.density, 530.0), peak, 3e-4 * peak);
    EXPECT_NEAR(valueAt(spectrum.density, 515.0), 0.5 * peak, 3e-4 * peak);
    EXPECT_NEAR(valueAt(spectrum.density, 545.0), 0.5 * peak, 3e-4 * peak);
    EXPECT_NEAR(valueAt(spectrum.density, 560.0), peak / 16.0, 3e-4 * peak);
}

TEST(Sodium, IsTheDoubletThatTheLaboratorySees) {
    const Spectrum sodium = namedSpectrum("sodium").value();
    ASSERT_EQ(sodium.lines.size(), 2u);
    EXPECT_TRUE(sodium.density.empty());
    EXPECT_NEAR(sodium.lines[0].wavelength / units::nm, 589.0, 0.05);
    EXPECT_NEAR(sodium.lines[1].wavelength / units::nm, 589.6, 0.05);
    // The levels 3p of sodium (NIST), in the last decimal that all sources agree in.
    EXPECT_NEAR(waveNumber_per_cm(sodium.lines[0]), 16973.366, 1e-3);
    EXPECT_NEAR(waveNumber_per_cm(sodium.lines[1]), 16956.170, 1e-3);
    EXPECT_NEAR(sodium.lines[0].power, 2.0 / 3.0, 1e-12);
}

TEST(Hydrogen, IsTheBalmerSeries) {
    const Spectrum hydrogen = namedSpectrum("hydrogen").value();
    ASSERT_EQ(hydrogen.lines.size(), 7u);
    // Rydberg's formula with the reduced mass. Relativity and spin lower the two parts of the lower level by
    // 0.09 and 0.46 per cm, the upper ones by a third of it at most: the unresolved line is within that.
    constexpr double kRydberg_per_cm = 109737.31568 / (1.0 + 1.0 / 1836.15267);
    int level = 3;
    for (auto line = hydrogen.lines.rbegin(); line != hydrogen.lines.rend(); ++line, ++level) {
        const double excess_per_cm =
            waveNumber_per_cm(*line) - kRydberg_per_cm * (0.25 - 1.0 / (level * level));
        EXPECT_GT(excess_per_cm, 0.09 - 0.15) << level;
        EXPECT_LT(excess_per_cm, 0.46) << level;
    }
}

TEST(Mercury, HasTheCombinationsOfItsLevels) {
    const Spectrum mercury = namedSpectrum("mercury").value();
    ASSERT_EQ(mercury.lines.size(), 7u);
    // 404.7, 435.8 and 546.1 nm leave one level for the three of 6p 3P: 37644.982, 39412.237 and 44042.909
    // per cm (NIST); 0.02 per cm are 4e-4 nm.
    const auto upper = [&](std::size_t line, double lower) {
        return waveNumber_per_cm(mercury.lines[line]) + lower;
    };
    EXPECT_NEAR(upper(0, 37644.982), 62350.325, 0.02);
    EXPECT_NEAR(upper(3, 39412.237), 62350.325, 0.02);
    EXPECT_NEAR(upper(4, 44042.909), 62350.325, 0.02);
}

TEST(Neon, LooksOrangeRed) {
    // Dominant wavelengths of neon signs are given as 600 to 620 nm: between the spectral colours of those
    // two, and of nearly full purity.
    const auto [x, y] = chromaticity(xyzPerWatt(namedSpectrum("neon").value(), constantCurve(1.0)));
    EXPECT_GT(x, 0.627);
    EXPECT_LT(x, 0.691);
    EXPECT_GT(x + y, 0.99);
}

}  // namespace
}  // namespace fringe::optics
