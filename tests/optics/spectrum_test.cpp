#include "optics/spectrum.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

namespace fringe::optics {
namespace {

// A sum over many equal steps, which knows nothing of knots. The integrands have a few corners and steps: the
// error is of the order of the step, 1e-4 nm.
double bruteForce(const std::function<double(double)>& f, double from_nm, double to_nm) {
    constexpr int kSteps = 4'000'000;
    long double sum = 0.0L;
    const double step = (to_nm - from_nm) / kSteps;
    for (int i = 0; i < kSteps; ++i) sum += f(from_nm + (i + 0.5) * step);
    return static_cast<double>(sum * step);
}

TEST(Curve, IsLinearBetweenItsKnotsAndZeroOutside) {
    const Curve curve{{400.0, 1.0}, {500.0, 3.0}, {520.0, 0.5}};
    EXPECT_EQ(valueAt(curve, 400.0), 1.0);
    EXPECT_EQ(valueAt(curve, 425.0), 1.5);
    EXPECT_EQ(valueAt(curve, 500.0), 3.0);
    EXPECT_EQ(valueAt(curve, 510.0), 1.75);
    EXPECT_EQ(valueAt(curve, 520.0), 0.5);
    EXPECT_EQ(valueAt(curve, 399.999), 0.0);
    EXPECT_EQ(valueAt(curve, 520.001), 0.0);
    EXPECT_EQ(valueAt({}, 500.0), 0.0);
}

TEST(Curve, KnowsWhetherItIsConstantWhereLightIsVisible) {
    EXPECT_TRUE(isConstant(constantCurve(0.3)));
    EXPECT_TRUE(isConstant({{300.0, 0.3}, {350.0, 0.3}, {600.0, 0.3}, {900.0, 0.3}}));
    EXPECT_TRUE(isConstant({{300.0, 0.7}, {380.0, 0.3}, {780.0, 0.3}, {900.0, 0.1}}));
    EXPECT_FALSE(isConstant({{300.0, 0.7}, {400.0, 0.3}, {780.0, 0.3}}));
    EXPECT_FALSE(isConstant({{380.0, 0.3}, {500.0, 0.4}, {780.0, 0.3}}));
    EXPECT_FALSE(isConstant({{380.0, 0.3}, {780.0, 0.4}}));
    EXPECT_FALSE(isConstant({{390.0, 0.3}, {780.0, 0.3}}));
    EXPECT_FALSE(isConstant({{380.0, 0.3}, {770.0, 0.3}}));
    EXPECT_FALSE(isConstant({}));
}

TEST(Power, IsTheAreaWithinTheVisibleRange) {
    // A triangle over 480 to 520 nm; then a ramp from 0 at 300 nm to 1 at 900 nm, cut at both ends.
    EXPECT_NEAR(visiblePower({{{480.0, 0.0}, {500.0, 3.0}, {520.0, 0.0}}, {}}), 60.0, 1e-12);
    EXPECT_NEAR(visiblePower({{{300.0, 0.0}, {900.0, 1.0}}, {}}), (80.0 + 480.0) / 600.0 / 2.0 * 400.0,
                1e-10);
    EXPECT_EQ(visiblePower({{{800.0, 1.0}, {900.0, 1.0}}, {}}), 0.0);
    EXPECT_EQ(visiblePower({}), 0.0);
}

TEST(Power, OfALineIsWhatLiesWithinTheVisibleRange) {
    EXPECT_EQ(visiblePower({{}, {{589.0 * units::nm, 2.0, {}}, {900.0 * units::nm, 1.0, {}}}}), 2.0);
    EXPECT_EQ(visiblePower({{}, {{kShortestVisible, 2.0, {}}, {kLongestVisible, 1.0, {}}}}), 3.0);
    for (const double width_nm : {1e-4, 0.01, 1.0, 30.0})
        EXPECT_NEAR(visiblePower({{}, {{550.0 * units::nm, 2.0, width_nm * units::nm}}}), 2.0, 2e-9)
            << width_nm;
    // One half at the end; half a width inside it the error function gives the share.
    EXPECT_NEAR(visiblePower({{}, {{kShortestVisible, 1.0, 3.0 * units::nm}}}), 0.5, 1e-9);
    EXPECT_NEAR(visiblePower({{}, {{778.5 * units::nm, 1.0, 3.0 * units::nm}}}),
                0.5 * (1.0 + std::erf(std::sqrt(std::log(2.0)))), 1e-9);
}

TEST(Normalised, SpectraHoldOneWatt) {
    const Spectrum spectrum = normalised({{{300.0, 0.2}, {500.0, 3.0}, {700.0, 0.1}},
                                          {{600.0 * units::nm, 40.0, {}}, {900.0 * units::nm, 9.0, {}}}});
    EXPECT_NEAR(visiblePower(spectrum), 1.0, 1e-12);
    EXPECT_NEAR(valueAt(spectrum.density, 500.0) / spectrum.lines[0].power, 3.0 / 40.0, 1e-15);
    EXPECT_NEAR(spectrum.lines[1].power / spectrum.lines[0].power, 9.0 / 40.0, 1e-15);
}

TEST(WeightedSum, AddsDensitiesEverywhereAndKeepsLines) {
    const std::array<WeightedSpectrum, 3> parts{{
        {2.0, {{{380.0, 1.0}, {780.0, 5.0}}, {{500.0 * units::nm, 1.5, {}}}}},
        {0.5, {{{450.0, 4.0}, {550.0, 2.0}}, {}}},
        {1.0, {{}, {{600.0 * units::nm, 0.5, 2.0 * units::nm}}}},
    }};
    const Spectrum sum = weightedSum(parts);
    for (double wavelength_nm = 379.25; wavelength_nm < 781.0; wavelength_nm += 0.5) {
        double expected = 0.0;
        for (const auto& [weight, spectrum] : parts)
            expected += weight * valueAt(spectrum.density, wavelength_nm);
        EXPECT_NEAR(valueAt(sum.density, wavelength_nm), expected, 1e-13) << wavelength_nm;
    }
    for (std::size_t i = 1; i < sum.density.size(); ++i)
        EXPECT_LT(sum.density[i - 1].wavelength_nm, sum.density[i].wavelength_nm);
    ASSERT_EQ(sum.lines.size(), 2u);
    EXPECT_EQ(sum.lines[0].power, 3.0);
    EXPECT_EQ(sum.lines[1].power, 0.5);
    EXPECT_NEAR(visiblePower(sum), 2.0 * (1200.0 + 1.5) + 0.5 * 300.0 + 0.5, 1e-9);
}

TEST(Filtered, DensityIsTheProductTo1e6OfItsPeak) {
    const Curve lamp{{350.0, 2.0}, {460.0, 9.0}, {505.0, 1.0}, {700.0, 6.0}, {800.0, 0.0}};
    const Curve glass{{400.0, 0.1}, {480.0, 0.9}, {610.0, 0.9}, {650.0, 0.05}, {790.0, 0.4}};
    const Spectrum light = filtered({lamp, {}}, glass);
    for (double wavelength_nm = 370.013; wavelength_nm < 790.0; wavelength_nm += 0.1) {
        const bool visible = wavelength_nm > kShortestVisible_nm && wavelength_nm < kLongestVisible_nm;
        const double exact = valueAt(lamp, wavelength_nm) * valueAt(glass, wavelength_nm);
        EXPECT_NEAR(valueAt(light.density, wavelength_nm), visible ? exact : 0.0, 9.0 * 1e-6)
            << wavelength_nm;
    }
    for (std::size_t i = 1; i < light.density.size(); ++i)
        EXPECT_LT(light.density[i - 1].wavelength_nm, light.density[i].wavelength_nm);
}

TEST(Filtered, LinesLoseWhatTheFilterTakesFromAllOfThem) {
    const Curve edge{{380.0, 0.0}, {588.0, 0.0}, {592.0, 0.8}, {780.0, 0.8}};
    const Line narrow{589.0 * units::nm, 3.0, {}};
    const Line wide{590.0 * units::nm, 2.0, 4.0 * units::nm};
    const Line atTheEnd{779.0 * units::nm, 2.0, 4.0 * units::nm};
    const Line infrared{800.0 * units::nm, 2.0, {}};
    const Spectrum light = filtered({{}, {narrow, wide, atTheEnd, infrared}}, edge);
    ASSERT_EQ(light.lines.size(), 3u);
    EXPECT_NEAR(light.lines[0].power, 3.0 * 0.2, 1e-12);
    const double deviation_nm = 4.0 / (2.0 * std::sqrt(2.0 * std::log(2.0)));
    const double passed = bruteForce(
        [&](double l) {
            const double x = (l - 590.0) / deviation_nm;
            return std::exp(-0.5 * x * x) / (deviation_nm * std::sqrt(2.0 * std::acos(-1.0))) *
                   valueAt(edge, l);
        },
        560.0, 620.0);
    EXPECT_NEAR(light.lines[1].power, 2.0 * passed, 1e-8);  // 1e-9 of the quadrature, the rest is the sum's
    EXPECT_NEAR(light.lines[2].power, 2.0 * 0.8, 1e-8);
    EXPECT_EQ(light.lines[1].width, wide.width);
    EXPECT_EQ(light.lines[1].wavelength, wide.wavelength);
}

TEST(Filtered, ByNothingIsTheSameLight) {
    const Spectrum light{{{380.0, 1.0}, {555.5, 3.0}, {780.0, 2.0}},
                         {{550.0 * units::nm, 2.0, 9.0 * units::nm}}};
    EXPECT_NEAR(visiblePower(filtered(light, constantCurve(1.0))), visiblePower(light), 1e-10);
    EXPECT_NEAR(visiblePower(filtered(light, constantCurve(0.25))), 0.25 * visiblePower(light), 1e-10);
    EXPECT_EQ(visiblePower(filtered(light, {})), 0.0);
}

TEST(Filtered, StepsOfASumAreKept) {
    const std::array<WeightedSpectrum, 2> parts{
        {{1.0, {constantCurve(1.0), {}}}, {1.0, {{{450.0, 4.0}, {550.0, 4.0}}, {}}}}};
    const Curve ramp{{380.0, 0.0}, {780.0, 1.0}};
    const double exact = 400.0 * 0.5 + 4.0 * 100.0 * (500.0 - 380.0) / 400.0;
    EXPECT_NEAR(visiblePower(filtered(weightedSum(parts), ramp)), exact, 1e-8);
}

}  // namespace
}  // namespace fringe::optics
