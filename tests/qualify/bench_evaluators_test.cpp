// The ways to the colour of slits: each as far off as it is said to be, "auto" within the tolerance.
#include "qualify/bench_evaluators.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <complex>
#include <numbers>

#include "optics/color.hpp"
#include "optics/sources.hpp"
#include "oracle/slit_color.hpp"
#include "qualify/cpu_sum.hpp"
#include "qualify/device.hpp"

namespace fringe::qualify {
namespace {

using glm::dvec3;

const EvaluatorCase& caseNamed(std::string_view name) {
    for (const EvaluatorCase& which : evaluatorCases())
        if (which.name == name) return which;
    throw std::out_of_range(std::string(name));
}

std::vector<EvaluatorRow> rowsOf(std::string_view name, std::vector<std::string> evaluators,
                                 double tolerance = 1e-3) {
    EvaluatorRequest request;
    request.tolerance = tolerance;
    request.evaluators = std::move(evaluators);
    request.oraclePatterns = 1e6;
    static const std::atomic<bool> never = false;
    return benchEvaluators(device(), caseNamed(name), request, {.rounds = 0, .cancelled = never});
}

const EvaluatorRow& rowWith(const std::vector<EvaluatorRow>& rows, std::string_view setting) {
    for (const EvaluatorRow& row : rows)
        if (row.setting == setting) return row;
    throw std::out_of_range(std::string(setting));
}

// ---- the oracle ----------------------------------------------------------------------------------

oracle::SlitColor slitColor(double count, double width_um, double period_um,
                            const optics::Spectrum& spectrum) {
    return oracle::SlitColor({count, width_um, period_um, spectrum, [](double) { return 1.0; }});
}

// Wave by wave and slit by slit.
TEST(SlitColor, IsTheSumOfTheSlitsWaves) {
    const optics::Spectrum d65 = *optics::namedSpectrum("D65");
    const oracle::SlitColor color = slitColor(4.0, 1.0, 2.0, d65);
    for (const double u : {0.0, 0.05, 0.26, -0.4, 0.9}) {
        dvec3 expected(0.0);
        double peak = 0.0;
        for (const auto& sample : oracle::sampled(d65, 4000)) {
            const double wavelength_um = 1e-3 * sample.wavelength_nm;
            std::complex<double> wave = 0.0;
            for (int slit = 0; slit < 4; ++slit) {
                constexpr int kParts = 64;
                for (int part = 0; part < kParts; ++part) {
                    const double x_um = 2.0 * slit + (part + 0.5) / kParts;
                    wave += std::polar(1.0 / kParts, 2.0 * std::numbers::pi * u * x_um / wavelength_um);
                }
            }
            const double density = std::norm(wave) / (4.0 * wavelength_um);
            expected += sample.power * density * oracle::filmResponse(sample.wavelength_nm);
            peak += sample.power * 4.0 / wavelength_um * oracle::filmResponse(sample.wavelength_nm).y;
        }
        const dvec3 got = color.mean(u, 0.0);
        // 64 parts to a slit: the finest phase is 2 pi/0.38/64 per part, its square over 24 times 2.
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], expected[i], 3e-4 * peak) << u;
    }
}

// All that leaves is somewhere: what of a 20 um slit is evanescent, 1/(pi^2 20/0.55), is all that is missing.
TEST(SlitColor, SendsOutAllPower) {
    const optics::Spectrum d65 = *optics::namedSpectrum("D65");
    const oracle::SlitColor color = slitColor(1.0, 20.0, 20.0, d65);
    const double whole = optics::xyzPerWatt(d65, optics::constantCurve(1.0)).y;
    double sum = 0.0;
    constexpr int kSteps = 4000;
    for (int i = 0; i < kSteps; ++i) sum += color.mean((i + 0.5) * 2.0 / kSteps - 1.0, 0.0).y * 2.0 / kSteps;
    EXPECT_NEAR(sum / whole, 1.0 - 0.55 / (std::numbers::pi * std::numbers::pi * 20.0), 2e-4);
}

TEST(SlitColor, MeanIsThatOfManyPoints) {
    const oracle::SlitColor color = slitColor(50.0, 50.0, 100.0, *optics::namedSpectrum("D65"));
    dvec3 sum(0.0);
    constexpr int kPoints = 400;
    for (int i = 0; i < kPoints; ++i) sum += color.mean(0.02 + 1e-3 * ((i + 0.5) / kPoints - 0.5), 0.0);
    const dvec3 mean = color.mean(0.02, 1e-3);
    EXPECT_NEAR(mean.y, sum.y / kPoints, 1e-4 * mean.y);
}

// Across the end of the spectrum at 380 nm, and across daylight's knot at 430 nm.
TEST(SlitColor, MeanOfNarrowOrdersIsThatOfManyPoints) {
    const oracle::SlitColor color = slitColor(1e4, 0.8, 1.6, *optics::namedSpectrum("D65"));
    const double peak = color.mean(0.446 / 1.6, 0.0).z;
    for (const double u : {0.38 / 1.6 - 2e-5, 0.43 / 1.6}) {
        double sum = 0.0;
        constexpr int kPoints = 200;
        for (int i = 0; i < kPoints; ++i) sum += color.mean(u + 2e-4 * ((i + 0.5) / kPoints - 0.5), 0.0).z;
        const double mean = color.mean(u, 2e-4).z, middle = color.mean(u, 0.0).z;
        EXPECT_NEAR(mean, sum / kPoints, 1e-5 * peak) << u;
        EXPECT_GT(std::abs(mean - middle), 3e-4 * peak) << u;
    }
}

// ---- the processor's sum -------------------------------------------------------------------------

TEST(CpuSum, IsOneAtTheMiddleAndThePatternElsewhere) {
    const CpuWaves waves{5.0F, {4.0F}, {2.0F}, {1.0F}, {2.0F}, {3.0F}};
    const std::array<float, 2> u{0.0F, 0.03F};
    std::array<float, 6> xyz{};
    cpuSum(waves, u, xyz);
    EXPECT_NEAR(xyz[0], 1.0F, 1e-5);
    EXPECT_NEAR(xyz[2], 3.0F, 3e-5);
    const double half = std::numbers::pi * 0.06, turn = std::numbers::pi * 0.12;
    const double expected =
        std::pow(std::sin(half) / half * std::sin(5.0 * turn) / (5.0 * std::sin(turn)), 2);
    EXPECT_NEAR(xyz[4], 2.0 * expected, 1e-5);
}

// ---- evaluators ----------------------------------------------------------------------------------

class EvaluatorsOnDevice : public ::testing::TestWithParam<std::string_view> {
protected:
    void TearDown() override {
        for (const std::string& message : device().validationMessages())
            ADD_FAILURE() << "validation: " << message;
    }
};

TEST_P(EvaluatorsOnDevice, AutoKeepsTheToleranceAndTheStableSumItsDigits) {
    const std::vector<EvaluatorRow> rows = rowsOf(GetParam(), {"auto", "direct"});
    EXPECT_LE(rows.at(0).maxError, 1e-3) << rows[0].detail;
    EXPECT_LT(rows[0].deltaE, 1.0) << rows[0].detail;
    EXPECT_EQ(rows[0].nonFinite, 0U);
    if (rows.size() == 1) return;  // lines
    // 81 patterns of 3e-7 each (docs/stress.md), in a sum of single precision.
    const EvaluatorRow& sum = rowWith(rows, "81 wavelengths, rounding alone");
    EXPECT_LE(sum.maxError, 2e-5);
    EXPECT_EQ(sum.nonFinite, 0U);
}

std::vector<std::string_view> names() {
    std::vector<std::string_view> list;
    for (const EvaluatorCase& which : evaluatorCases()) list.push_back(which.name);
    return list;
}

INSTANTIATE_TEST_SUITE_P(All, EvaluatorsOnDevice, ::testing::ValuesIn(names()), [](const auto& info) {
    std::string name;
    for (const char c : info.param) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return name;
});

TEST(EvaluatorOnDevice, AFinerToleranceGivesAFinerTable) {
    const EvaluatorRow usual = rowsOf("5 slits of 1/2 um, D65", {"auto"}, 1e-3).at(0);
    const EvaluatorRow coarse = rowsOf("5 slits of 1/2 um, D65", {"auto"}, 1e-1).at(0);
    const EvaluatorRow fine = rowsOf("5 slits of 1/2 um, D65", {"auto"}, 1e-4).at(0);
    EXPECT_LT(fine.maxError, usual.maxError);
    EXPECT_LT(usual.maxError, coarse.maxError);
    EXPECT_LE(coarse.maxError, 1e-1);
    EXPECT_LE(fine.maxError, 1e-4);
    EXPECT_GT(fine.tableBytes, 3 * usual.tableBytes);
}

TEST(EvaluatorOnDevice, PrintedFormulaIsWrongNextToOrders) {
    const std::vector<EvaluatorRow> rows = rowsOf("1000 slits of 0.8/1.6 um, D65", {"naive"});
    EXPECT_GT(rowWith(rows, "81 wavelengths, rounding alone").maxError, 1e-2);
}

TEST(EvaluatorOnDevice, PrintedFormulaIsMarkedWhereItIsNoNumber) {
    EXPECT_GE(rowsOf("5 slits of 1/2 um, D65", {"naive"}).at(0).nonFinite, 1U);  // the first input is u = 0
}

TEST(EvaluatorOnDevice, SmallAnglesAreRightAtSmallAnglesOnly) {
    EXPECT_LT(rowWith(rowsOf("5 slits of 1/2 um, D65, to 3 deg", {"small-angle"}), "81 wavelengths").maxError,
              1e-2);
    EXPECT_GT(rowWith(rowsOf("5 slits of 1/2 um, D65", {"small-angle"}), "81 wavelengths").maxError, 0.05);
}

TEST(EvaluatorOnDevice, OrdersErrAsOneOverTheCount) {
    const double many = rowsOf("10^4 slits of 0.8/1.6 um, D65", {"orders"}).at(0).maxError;
    const double few = rowsOf("1000 slits of 0.8/1.6 um, D65", {"orders"}).at(0).maxError;
    EXPECT_LE(many, 1e-4 + 3.0 / 1e4);
    EXPECT_LE(few, 1e-4 + 3.0 / 1e3);
    EXPECT_LT(many, few);
}

}  // namespace
}  // namespace fringe::qualify
