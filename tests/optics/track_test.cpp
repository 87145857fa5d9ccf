// Efficiencies of an optical disc's track: against numerical Fourier transforms of the pits, against a random
// track summed wave by wave, and against conservation.
#include "optics/track.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>
#include <random>
#include <vector>

namespace fringe::optics {
namespace {

using namespace units;
using std::numbers::pi;
using Complex = std::complex<double>;

Track compactDisc(double pitShare) {
    return {1.6 * um, 0.5 * um, 1.55 * 0.12 * um, pitShare};
}

// |(1/d) int exp(i phase(x)) exp(-2 pi i m x/d) dx|^2 of the height profile by midpoints. The steps of 1/3200
// of the pitch hit the pit's edges, so what errs is the exponential alone.
double byFourierTransform(const Track& track, int order, Length wavelength, double cosines) {
    constexpr int kSteps = 3200;
    const double phase = 2.0 * pi * (track.depth / wavelength) * cosines;
    Complex sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double x = (i + 0.5) / kSteps - 0.5;  // in pitches
        const bool isPit = std::abs(x) * (track.pitch / track.pitWidth) < 0.5;
        sum += std::polar(1.0, (isPit ? phase : 0.0) - 2.0 * pi * order * x) / double{kSteps};
    }
    return std::norm(sum);
}

TEST(Track, OrdersOfAGrooveAreItsFourierCoefficients) {
    const Track track = compactDisc(1.0);
    for (const double wavelength_nm : {400.0, 450.0, 550.0, 650.0, 780.0}) {
        for (const double cosines : {2.0, 1.7, 1.5}) {
            for (int order = -8; order <= 8; ++order) {
                EXPECT_NEAR(orderEfficiency(track, order, wavelength_nm * nm, cosines),
                            byFourierTransform(track, order, wavelength_nm * nm, cosines),
                            1e-6)  // midpoint rule
                    << wavelength_nm << " nm, " << cosines << ", order " << order;
            }
        }
    }
}

// Worked by hand to seven digits: a phase of 3.0, pits of 0.5 um every 1.6 um.
TEST(Track, WorkedValues) {
    const Track track{1.6 * um, 0.5 * um, 3.0 / (4.0 * pi) * 550.0 * nm, 1.0};
    EXPECT_NEAR(orderEfficiency(track, 0, 550.0 * nm, 2.0), 0.1449251, 1e-7);
    EXPECT_NEAR(orderEfficiency(track, 1, 550.0 * nm, 2.0), 0.2787882, 1e-7);
    EXPECT_NEAR(orderEfficiency(track, 2, 550.0 * nm, 2.0), 0.0860503, 1e-7);
}

// The compact disc at normal incidence, to the three digits these figures are known to.
TEST(Track, CompactDisc) {
    struct Row {
        double wavelength_nm, shares[4];
    };
    for (const Row& row : {Row{450.0, {.769, .075, .023, .001}}, Row{550.0, {.379, .203, .063, .001}},
                           Row{650.0, {.184, .266, .082, .002}}}) {
        for (int order = 0; order < 4; ++order) {
            EXPECT_NEAR(orderEfficiency(compactDisc(1.0), order, row.wavelength_nm * nm, 2.0),
                        row.shares[order], 6e-4);
        }
    }
    const double halfPits[] = {.619, .051, .016};
    for (int order = 0; order < 3; ++order)
        EXPECT_NEAR(orderEfficiency(compactDisc(0.5), order, 550.0 * nm, 2.0), halfPits[order], 6e-4);
}

TEST(Track, OrdersAndScatteringSumToOne) {
    for (const double pitShare : {0.0, 0.3, 0.5, 1.0}) {
        const Track track = compactDisc(pitShare);
        constexpr int kLast = 20000;
        double sum = orderEfficiency(track, 0, 500.0 * nm, 1.9) + scatteredShare(track, 500.0 * nm, 1.9);
        for (int order = 1; order <= kLast; ++order)
            sum += 2.0 * orderEfficiency(track, order, 500.0 * nm, 1.9);
        EXPECT_NEAR(sum, 1.0,
                    4.0 / (pi * pi * kLast));  // what is left out: 4 (1/(pi m))^2 per order and side at most
    }
}

// Whole over the plane, and as a part of it within u^2 + v^2 < 1, by a plain sum over small squares.
TEST(Track, ScatteringDensity) {
    const Track track = compactDisc(0.4);
    constexpr int kSteps = 2000;
    double inside = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const double u = (i + 0.5) / kSteps, v = (j + 0.5) / kSteps;
            if (u * u + v * v < 1.0)
                inside += 4.0 / kSteps / kSteps * scatteringDensity(track, 550.0 * nm, u, v);
        }
    }
    EXPECT_NEAR(propagatingScattering(track, 550.0 * nm), inside, 1e-4);  // squares on the rim

    // Far out the rest goes as 1/(pi^2 width u) across and 2/(pi 2 pi length v) along.
    double across = 0.0, along = 0.0;
    constexpr double kReach = 400.0;
    const double width = track.pitWidth / (550.0 * nm), length = track.correlationLength() / (550.0 * nm);
    constexpr int kFine = 400000;
    for (int i = 0; i < kFine; ++i) {
        const double at = (i + 0.5) * kReach / kFine;
        across += 2.0 * kReach / kFine * scatteringDensity(track, 550.0 * nm, at, 0.0) / (2.0 * length);
        along += 2.0 * kReach / kFine * scatteringDensity(track, 550.0 * nm, 0.0, at) / width;
    }
    EXPECT_NEAR(across, 1.0 - 1.0 / (pi * pi * width * kReach), 1e-4);
    EXPECT_NEAR(along, 1.0 - 1.0 / (pi * pi * length * kReach), 1e-4);
}

// A track of pits and lands of random lengths, its waves summed along it: the mean power in a direction v off
// the orders, against the share and the density of what is scattered; and at v = 0 nothing but the coherent
// part, which grows as length^2.
TEST(Track, RandomPitsScatterAsStated) {
    const Track track = compactDisc(0.4);
    const double pit = track.meanPitLength() / um, land = pit * 0.6 / 0.4;
    const double wavelength_um = 0.55;
    constexpr int kTracks = 4000;
    const double length_um = 400.0;
    std::mt19937 random(5);
    for (const double v : {0.05, 0.12, 0.3}) {
        const double k = 2.0 * pi * v / wavelength_um;
        double power = 0.0;
        for (int t = 0; t < kTracks; ++t) {
            bool isPit = std::bernoulli_distribution(0.4)(random);
            double at = 0.0;
            Complex sum = 0.0;
            while (at < length_um) {
                const double next =
                    std::min(at + std::exponential_distribution<double>(1.0 / (isPit ? pit : land))(random),
                             length_um);
                if (isPit) sum += (std::polar(1.0, k * next) - std::polar(1.0, k * at)) / Complex(0.0, k);
                at = next;
                isPit = !isPit;
            }
            power += std::norm(sum) / length_um / kTracks;
        }
        // Per track and direction cosine: share s (1 - s) times the spectrum, divided by the wavelength.
        const double spectrum = scatteringDensity(track, wavelength_um * um, 0.0, v) / (0.5 / wavelength_um);
        const double ends =
            2.0 * 0.4 * 0.4 / (k * k * length_um);  // |mean pit share (e^{i k L} - 1)/k|^2 / L, about
        EXPECT_NEAR(power / (0.4 * 0.6 * spectrum * wavelength_um), 1.0,
                    0.06 + 2.0 * ends / (0.24 * spectrum * wavelength_um))
            << v;  // 1/sqrt(4000) is 1.6 %, four times that
    }
}

// A record's groove: |(1/d) int exp(i phase) exp(-2 pi i m x/d) dx|^2 of a parabola, smoothed over 41 orders,
// since the ends of the groove leave a ripple that stationary phase does not have; and what does not deviate.
TEST(Track, WideGrooveReflectsByItsSlopes) {
    const Track record{113.0 * um, 56.0 * um, 10.0 * um, 1.0};
    ASSERT_TRUE(isWideGroove(record));
    const Length wavelength = 550.0 * nm;
    constexpr double kCosines = 1.8;
    const double step = wavelength / record.pitch;
    const double duty = record.pitWidth / record.pitch;
    const auto amplitudeSquared = [&](int order) {
        constexpr int kSteps = 40000;
        Complex sum = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const double x = 2.0 * (i + 0.5) / kSteps - 1.0;  // in half widths
            const double phase = 2.0 * pi * (record.depth / wavelength) * kCosines * (1.0 - x * x);
            sum += std::polar(duty / kSteps, phase - pi * order * duty * x);
        }
        return std::norm(sum);
    };
    for (const int middle : {60, 120, 180}) {
        double mean = 0.0;
        for (int order = middle - 20; order <= middle + 20; ++order) mean += amplitudeSquared(order) / 41.0;
        EXPECT_NEAR(mean / grooveEfficiency(record, middle, wavelength, kCosines), 1.0, 0.03) << middle;
    }
    const int last = static_cast<int>(steepestSlope(record) * kCosines / step);
    EXPECT_GT(grooveEfficiency(record, last, wavelength, kCosines), 0.0);
    EXPECT_EQ(grooveEfficiency(record, last + 1, wavelength, kCosines), 0.0);
    EXPECT_NEAR(2.0 * last * grooveEfficiency(record, 1, wavelength, kCosines), duty, 2.0 / last);
}

TEST(Track, ContinuousGroovesScatterNothing) {
    EXPECT_EQ(scatteredShare(compactDisc(1.0), 550.0 * nm, 2.0), 0.0);
}

}  // namespace
}  // namespace fringe::optics
