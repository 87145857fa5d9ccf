// Wavelengths from places: against directions that the grating sends light to, phases of the way across the
// slits, and patterns summed slit by slit.
#include "profile/spectrometer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

namespace fringe::profile {
namespace {

using namespace units;
using std::numbers::pi;

// 2500 slits of 1 um every 2 um, in the plane z = 0, light to -z; x across.
scene::Light lightOf(std::uint32_t count) {
    scene::Grating grating{};
    grating.position = {0, 0, 0};
    grating.normal = {0, 0, -1};
    grating.slitDirection = {0, -1, 0};
    grating.aperture = optics::Slits{count, 1.0 * um, 2.0 * um};
    grating.beam = {scene::BeamProfile::rectangle, 1.0 * m, 10.0 * mm, {0, 0, -1}, 1.0 * W, 0.0 * rad, {}};
    scene::Light light{"grating", {1, 1, 1}, {}, grating};
    light.spectrum.lines = {{588.995 * nm, 2.0, 0.0 * nm}, {589.592 * nm, 1.0, 0.0 * nm}};
    return light;
}

scene::Grating& lampsGrating(scene::Light& light) {
    return std::get<scene::Grating>(light.model);
}

dvec3 randomUnit(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
}

// The light of an order goes where its wave vector in the grating's plane is that of the beam plus the
// grating's (k-space, with vectors); anywhere on that ray the spectrometer has to read its wavelength.
TEST(Spectrometer, ReadsTheWavelengthOfEveryOrderObliqueAndConical) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
        scene::Light light = lightOf(1000);
        scene::Grating& grating = lampsGrating(light);
        grating.normal = randomUnit(random);
        grating.slitDirection = glm::normalize(glm::cross(grating.normal, randomUnit(random)));
        grating.position = randomUnit(random);
        grating.beam.direction = randomUnit(random);
        const double wavelength_nm = 380.0 + 400.0 * uniform(random);
        const int order = 1 + static_cast<int>(3.0 * uniform(random));
        const int signedOrder = uniform(random) < 0.5 ? -order : order;

        const dvec3 across = glm::cross(grating.slitDirection, grating.normal);
        const dvec3 in = grating.beam.direction;
        const dvec3 inPlane = in - glm::dot(in, grating.normal) * grating.normal +
                              signedOrder * wavelength_nm * 1e-9 / 2e-6 * across;
        const double squared = 1.0 - glm::dot(inPlane, inPlane);
        if (squared <= 1e-4) continue;  // evanescent, or grazing
        const dvec3 out = inPlane + std::sqrt(squared) * grating.normal;
        const double distance = 0.1 + 5.0 * uniform(random);
        const dvec3 point = grating.position + distance * out;

        const Spectrometer spectrometer(light);
        ASSERT_TRUE(spectrometer.reaches(point));
        // The point is at the height of the middle of the slits only without the part along them; the light
        // from elsewhere on the slits goes there in parallel, and so it does not matter.
        const dvec3 shifted = point + (uniform(random) - 0.5) * 0.01 * grating.slitDirection;
        for (const dvec3& place : {point, shifted}) {
            const double sine = spectrometer.sine(place);
            EXPECT_NEAR(spectrometer.wavelength_nm(sine, signedOrder), wavelength_nm, 1e-9);
            EXPECT_EQ(spectrometer.order(sine, wavelength_nm), signedOrder);
        }
        EXPECT_NEAR(spectrometer.distance(point), distance, 1e-9);
        ++seen;
    }
    EXPECT_GT(seen, 500);
}

TEST(Spectrometer, SeesNothingFromBehind) {
    EXPECT_FALSE(Spectrometer(lightOf(2)).reaches({0.1, 0, 0.1}));
}

// The lens has to make up for the second derivative of the way from across the slits, here by differences; of
// light that leaves perpendicular to the slits.
TEST(Spectrometer, TheFocusMakesUpForTheWay) {
    const Spectrometer spectrometer(lightOf(2500));
    for (const double x : {0.0, 0.3, -0.8}) {
        const dvec3 point(x, 0.0, -1.0);
        const double h = 1e-3;
        const double bend =
            (std::hypot(x - h, 1.0) - 2.0 * std::hypot(x, 1.0) + std::hypot(x + h, 1.0)) / (h * h);
        EXPECT_NEAR(spectrometer.focusFor(point), 1.0 / bend, 1e-5);

        scene::Light focused = lightOf(2500);
        lampsGrating(focused).beam.focus = spectrometer.focusFor(point) * m;
        EXPECT_NEAR(Spectrometer(focused).footprint(point), 0.0, 1e-12);
        // Without a lens the footprint is the difference of the sines from either end of the slits.
        const double left = (x + 2.5e-3) / std::hypot(x + 2.5e-3, 1.0);
        const double right = (x - 2.5e-3) / std::hypot(x - 2.5e-3, 1.0);
        EXPECT_NEAR(spectrometer.footprint(point), left - right, 1e-7);
    }
}

TEST(Spectrometer, TheSlopeOfOneSlitIsThatOfItsPattern) {
    const Spectrometer spectrometer(lightOf(2));
    const auto logarithm = [](double sine) {
        const double x = pi * 1e-6 * sine / 600e-9;
        return 2.0 * std::log(std::sin(x) / x);
    };
    for (const double sine : {-0.4, 1e-5, 0.1, 0.5}) {
        const double h = 1e-6;
        EXPECT_NEAR(spectrometer.envelopeSlope(sine, 600.0),
                    (logarithm(sine + h) - logarithm(sine - h)) / (2.0 * h), 1e-5);
    }
}

TEST(Spectrometer, NeedsAGratingOfSeveralSlits) {
    EXPECT_THROW(Spectrometer(lightOf(1)), LineError);
    scene::Light circle = lightOf(2);
    lampsGrating(circle).aperture = optics::CircularAperture{1.0 * mm, 0.0 * mm};
    EXPECT_THROW(Spectrometer{circle}, LineError);
    EXPECT_THROW((Spectrometer{scene::Light{"lamp", {1, 1, 1}, {}, scene::PointLight{}}}), LineError);
}

// What the wall at one metre gets, slit by slit: the far field, as in a lens's focus.
Samples pattern(const scene::Light& light, double from, double to, int count) {
    const auto& slits = std::get<optics::Slits>(std::get<scene::Grating>(light.model).aperture);
    Samples samples;
    samples.step = (to - from) / count;
    for (int i = 0; i < count; ++i) {
        const double x = from + (i + 0.5) * samples.step;
        const double sine = x / std::hypot(x, 1.0);
        double sum = 0.0, moment = 0.0;
        for (const optics::Line& line : light.spectrum.lines) {
            const double phase = 2.0 * pi * sine * (slits.period / line.wavelength);
            std::complex<double> wave = 0.0;
            for (std::uint32_t k = 0; k < slits.count; ++k) wave += std::polar(1.0, phase * k);
            sum += line.power * std::norm(wave);
            moment += line.power * std::norm(wave) * (line.wavelength / nm);
        }
        samples.points.push_back({x, 0, -1});
        samples.irradiance.push_back(sum);
        samples.meanWavelength_nm.push_back(sum > 0.0 ? moment / sum : 0.0);
    }
    return samples;
}

scene::Light focusedLight(std::uint32_t count, int order = 1) {
    scene::Light light = lightOf(count);
    const double sine = order * 589.3e-9 / 2e-6;
    lampsGrating(light).beam.focus = 1.0 * m / std::pow(1.0 - sine * sine, 1.5);
    return light;
}

TEST(Sodium, IsTwoLinesWithEnoughSlits) {
    for (const std::uint32_t count : {1400U, 2500U}) {
        const scene::Light light = focusedLight(count);
        const Spectrometer spectrometer(light);
        const auto maxima = readMaxima(pattern(light, 0.306, 0.311, 1000), &spectrometer);
        ASSERT_EQ(maxima.size(), 2U) << count;
        for (std::size_t i = 0; i < 2; ++i) {
            ASSERT_TRUE(maxima[i].reading);
            const Reading& reading = *maxima[i].reading;
            EXPECT_EQ(reading.order, 1);
            EXPECT_FALSE(reading.blend);
            const double error = std::abs(reading.wavelength_nm - (i == 0 ? 588.995 : 589.592));
            EXPECT_LE(error, 0.05);  // what is asked for
            EXPECT_LE(error, 3.0 * reading.uncertainty_nm);
            EXPECT_LE(reading.uncertainty_nm, 0.05);
        }
    }
}

TEST(Sodium, IsUnresolvedWithTooFew) {
    const scene::Light light = focusedLight(700);
    const Spectrometer spectrometer(light);
    const auto maxima = readMaxima(pattern(light, 0.306, 0.311, 1000), &spectrometer);
    ASSERT_EQ(maxima.size(), 1U);
    ASSERT_TRUE(maxima[0].reading && maxima[0].reading->blend);
    const Blend& blend = *maxima[0].reading->blend;
    EXPECT_EQ(blend.lines_nm, (std::vector{588.995, 589.592}));
    EXPECT_NEAR(blend.slitsNeeded, 589.2 / 0.597, 1.0);  // wavelength / (order difference), Rayleigh
    EXPECT_FALSE(blend.focus);
    // In the second order the same slits do: 700 > 493.
    const scene::Light onSecond = focusedLight(700, 2);
    const Spectrometer secondSpectrometer(onSecond);
    const auto second = readMaxima(pattern(onSecond, 0.724, 0.736, 2000), &secondSpectrometer);
    ASSERT_EQ(second.size(), 2U);
    EXPECT_EQ(second[0].reading->order, 2);
}

TEST(Sodium, AFootprintThatCoversTheLinesAsksForALens) {
    const scene::Light light = lightOf(2500);  // a parallel beam: the pattern is the beam's shape, twice
    Samples samples;
    samples.step = 2e-5;
    for (int i = 0; i < 1000; ++i) {
        const double x = 0.298 + i * samples.step;
        double sum = 0.0;
        for (const optics::Line& line : light.spectrum.lines) {
            const double sine = line.wavelength / (2.0 * um);
            const double place = sine / std::sqrt(1.0 - sine * sine);
            if (std::abs(x - place) < 2.5e-3) sum += line.power * (1.0 + 0.2 * std::cos(4e3 * (x - place)));
        }
        samples.points.push_back({x, 0, -1});
        samples.irradiance.push_back(sum);
        samples.meanWavelength_nm.push_back(sum > 0.0 ? 589.2 : 0.0);
    }
    const Spectrometer spectrometer(light);
    const auto maxima = readMaxima(samples, &spectrometer);
    ASSERT_EQ(maxima.size(), 1U);
    ASSERT_TRUE(maxima[0].reading && maxima[0].reading->blend);
    ASSERT_TRUE(maxima[0].reading->blend->focus);
    EXPECT_NEAR(*maxima[0].reading->blend->focus, std::pow(1.0 - 0.08679, -1.5), 2e-3);  // 1 m/gamma^3
    EXPECT_LE(std::abs(maxima[0].reading->wavelength_nm - 589.194), maxima[0].reading->uncertainty_nm);
}

TEST(Readings, AreMissingWithoutAGratingAndInTheZeroOrder) {
    const scene::Light light = focusedLight(100);
    const Samples samples = pattern(light, -0.05, 0.05, 1000);
    const auto plain = readMaxima(samples, nullptr);
    ASSERT_FALSE(plain.empty());
    EXPECT_FALSE(plain[0].reading);
    const Spectrometer spectrometer(light);
    const auto maxima = readMaxima(samples, &spectrometer);
    ASSERT_EQ(maxima.size(), 1U);
    EXPECT_FALSE(maxima[0].reading);
}

}  // namespace
}  // namespace fringe::profile
