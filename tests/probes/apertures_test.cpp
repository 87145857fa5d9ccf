// Openings in two dimensions on the device, against the host's transforms in double precision and, for round
// ones, the standard library's Bessel functions, at the very floats that the device got.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "compile/opening_tables.hpp"
#include "optics/mask_spectrum.hpp"
#include "optics/shapes.hpp"
#include "optics/transform.hpp"
#include "oracle/opening.hpp"
#include "oracle/quadrature.hpp"
#include "probes/probe.hpp"

namespace fringe::testing {
namespace {

using namespace units;
using glm::dvec2;
using glm::vec2;
using optics::PolygonalAperture;

double sincSquared(double x) {
    const double y = std::numbers::pi * x;
    const double amplitude = std::abs(y) < 1e-9 ? 1.0 : std::sin(y) / y;
    return amplitude * amplitude;
}

TEST(AperturesOnDevice, Rectangle) {
    for (const auto& [width, height] : {std::pair{0.3F, 2.0F}, {10.0F, 7.0F}, {3000.0F, 0.1F}}) {
        const std::vector<vec2> directions = directionsInTwoDimensions(std::max(width, height));
        std::vector<double> expected;
        for (const vec2& uv : directions)
            expected.push_back(sincSquared(double{uv.x} * width) * sincSquared(double{uv.y} * height));
        const std::array parameters{width, height};
        expectNear(evaluate(Probe::rectangle, parameters, directions), expected, directions, kSineBound);
    }
}

// 2 J1(x)/x.
double airy(double x) {
    return x < 1e-9 ? 1.0 : 2.0 * std::cyl_bessel_j(1.0, x) / x;
}

TEST(AperturesOnDevice, Circle) {
    for (const float diameter : {0.3F, 1.0F, 12.5F, 300.0F}) {
        const std::vector<vec2> directions = directionsInTwoDimensions(diameter);
        std::vector<double> expected;
        for (const vec2& uv : directions) {
            const double x = std::numbers::pi * diameter * std::hypot(double{uv.x}, double{uv.y});
            expected.push_back(std::pow(airy(x), 2));
        }
        expectNear(evaluate(Probe::circle, {&diameter, 1}, directions), expected, directions, kSineBound);
    }
}

TEST(AperturesOnDevice, Ring) {
    for (const auto& [diameter, inner] :
         {std::pair{1.0F, 0.5F}, {12.5F, 0.1F}, {12.5F, 0.9F}, {200.0F, 0.99F}}) {
        const std::vector<vec2> directions = directionsInTwoDimensions(diameter);
        std::vector<double> expected;
        const double share = double{inner} * inner;
        for (const vec2& uv : directions) {
            const double x = std::numbers::pi * diameter * std::hypot(double{uv.x}, double{uv.y});
            expected.push_back(std::pow((airy(x) - share * airy(inner * x)) / (1.0 - share), 2));
        }
        const std::array parameters{diameter, inner};
        // Two digits less for a ring of a hundredth of its radius.
        expectNear(evaluate(Probe::ring, parameters, directions), expected, directions,
                   std::min(kSineBound / (1.0 - share), 1e-5));
    }
}

// Of vertices in um; each is rounded to a float first, so that the reference sees the same polygon. The
// reference is a quadrature over the area where that is no more than some hundred nodes, else the host's
// closed form.
void comparePolygon(const std::vector<dvec2>& vertices, double wavelength_um, double bound,
                    bool isSymmetric = false) {
    PolygonalAperture polygon;
    std::vector<float> parameters{static_cast<float>(1.0 / wavelength_um), 0.0F};
    double radius = 0.0;
    for (const dvec2& vertex : vertices) {
        const vec2 rounded(vertex);
        parameters.push_back(rounded.x);
        parameters.push_back(rounded.y);
        polygon.vertices.emplace_back(1e-6 * double{rounded.x}, 1e-6 * double{rounded.y});
        radius = std::max(radius, std::hypot(vertex.x, vertex.y));
    }
    const double area = optics::area(polygon);
    parameters[1] = static_cast<float>(1e12 * area);
    const std::vector<vec2> directions = directionsInTwoDimensions(2.0 * radius / wavelength_um);
    const double perMetre = 1e6 * double{parameters[0]};
    const bool isSmall = radius < 5.0 * wavelength_um;
    const oracle::Opening opening(polygon, isSmall ? 6.0 / radius * 1e6 + 3.0 * perMetre : 0.0);
    std::vector<double> expected;
    for (const vec2& uv : directions) {
        const dvec2 f = perMetre * dvec2(uv);
        expected.push_back(
            std::norm((isSmall ? opening.amplitude(f) : optics::transform(polygon, f)) / area));
    }
    expectNear(evaluate(Probe::polygon, parameters, directions), expected, directions, bound);
    if (!isSymmetric) return;
    parameters.resize(2 + 2 * (vertices.size() / 2 + 1));
    expectNear(evaluate(Probe::symmetricPolygon, parameters, directions), expected, directions, bound);
    expectNear(evaluate(Probe::evenPolygon, parameters, directions), expected, directions, bound);
}

std::vector<dvec2> scaled(PolygonalAperture polygon, double factor) {
    for (dvec2& vertex : polygon.vertices) vertex *= factor;
    return polygon.vertices;
}

TEST(AperturesOnDevice, RegularPolygons) {
    for (const int vertices : {3, 4, 5, 6, 9, 64})
        for (const double radius_um : {0.1, 2.0, 60.0, 2000.0})
            comparePolygon(scaled(optics::regularPolygon(vertices, 1.0), radius_um), 0.55, 2.0 * kSineBound,
                           vertices % 2 == 0);
}

TEST(AperturesOnDevice, PolygonsThatAreNotConvex) {
    for (const double factor : {0.1e6, 1e6, 100e6})
        comparePolygon(scaled(optics::ell(), factor), 0.48, 2.0 * kSineBound);
    PolygonalAperture star;
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 10.0 : 4.0, angle = std::numbers::pi * i / 5.0;
        star.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    comparePolygon(star.vertices, 0.6, 2.0 * kSineBound);
    // A needle, of which perimeter * radius/area is 40.
    comparePolygon({{-10.0, -0.5}, {10.0, -0.5}, {10.0, 0.5}, {-10.0, 0.5}}, 0.6, 1e-5, true);
}

std::vector<float> maskParameters(float perWavelength_um, const compile::MaskTables& tables) {
    const optics::MaskSpectrum& spectrum = tables.spectrum;
    std::vector<float> parameters{perWavelength_um,
                                  static_cast<float>(spectrum.columns()),
                                  static_cast<float>(spectrum.rows()),
                                  static_cast<float>(1e6 * spectrum.pixel().x),
                                  static_cast<float>(1e6 * spectrum.pixel().y),
                                  spectrum.hasHats() ? 2.0F : 1.0F};
    parameters.insert(parameters.end(), tables.levels.begin(), tables.levels.end());
    return parameters;
}

// A picture of noise; its table's own error, 5e-4 at most, is tested with the table (tests/optics): here the
// host's interpolation in it is what the device is to repeat. Coefficients of 1e-3 and less err by 1e-7 of
// the peak; a float's frequency is 2e-4 of a step off at the table's far end.
TEST(AperturesOnDevice, Mask) {
    optics::MaskAperture mask{12, 7, 1.0 * um, {}};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
    for (std::uint32_t i = 0; i < mask.columns * mask.rows; ++i) mask.transmission.push_back(uniform(random));
    const compile::MaskTables tables = compile::tablesOf(optics::gridOf(mask));
    const std::vector<float> parameters = maskParameters(1.0F / 0.55F, tables);
    const std::vector<vec2> directions = directionsInTwoDimensions(12.0);
    std::vector<double> expected;
    for (const vec2& uv : directions)
        expected.push_back(tables.spectrum.relativePower(1e6 * double{parameters[0]} * dvec2(uv)));
    expectNear(evaluate(Probe::mask, parameters, directions), expected, directions, 1e-5);
}

// In a Gaussian beam, within the directions that the table knows. `power`: relative to the peak, at a
// frequency per metre; it is asked for one in `every` directions.
template <class Power>
void compareLit(const optics::Aperture& opening, units::Length beamWidth, std::size_t every,
                const Power& power) {
    const compile::MaskTables tables =
        compile::tablesOf(optics::gaussianGrid(opening, beamWidth / m, compile::kPixelsAcross));
    const float perWavelength_um = 1.0F / 0.55F;
    std::vector<vec2> directions;
    std::vector<double> expected;
    for (const vec2& uv : directionsInTwoDimensions(30.0)) {
        if (directions.size() * every > 10'000) break;
        directions.push_back(uv);
        expected.push_back(power(1e6 * double{perWavelength_um} * dvec2(uv)));
    }
    expectNear(evaluate(Probe::mask, maskParameters(perWavelength_um, tables), directions), expected,
               directions, 1e-5);
}

// A cosine under a Gaussian of the 1/e^2 diameter `beam`, integrated along a side.
double litSide(double side, double beam, double frequency) {
    double sum = 0.0;
    const auto panels = static_cast<std::size_t>(1.0 + std::abs(side * frequency) + 4.0 * side / beam);
    oracle::forNodes(-0.5 * side, 0.5 * side, panels, [&](double x, double weight) {
        sum += weight * std::exp(-4.0 * x * x / (beam * beam)) *
               std::cos(2.0 * std::numbers::pi * frequency * x);
    });
    return sum;
}

// The same of a Bessel function along the radius.
double litRadius(double from, double to, double beam, double frequency) {
    double sum = 0.0;
    const auto panels = static_cast<std::size_t>(1.0 + 2.0 * to * frequency + 8.0 * to / beam);
    oracle::forNodes(from, to, panels, [&](double r, double weight) {
        sum += weight * r * std::exp(-4.0 * r * r / (beam * beam)) *
               ::j0(2.0 * std::numbers::pi * frequency * r);
    });
    return sum;
}

TEST(AperturesOnDevice, RectanglesAndRoundOpeningsInAGaussianBeam) {
    for (const auto& [width, height, beam] :
         {std::array{20e-6, 20e-6, 40e-6}, {30e-6, 4e-6, 20e-6}, {24e-6, 40e-6, 12e-6}}) {
        const double peak = litSide(width, beam, 0.0) * litSide(height, beam, 0.0);
        compareLit(optics::RectangularAperture{width * m, height * m}, beam * m, 1,
                   [&, width = width, height = height, beam = beam](const dvec2& f) {
                       return std::pow(litSide(width, beam, f.x) * litSide(height, beam, f.y) / peak, 2);
                   });
    }
    for (const auto& [diameter, inner, beam] :
         {std::array{20e-6, 0.0, 60e-6}, {20e-6, 0.0, 6e-6}, {40e-6, 0.0, 40e-6}, {20e-6, 10e-6, 15e-6}}) {
        const double peak = litRadius(0.5 * inner, 0.5 * diameter, beam, 0.0);
        compareLit(optics::CircularAperture{diameter * m, inner * m}, beam * m, 1,
                   [&, diameter = diameter, inner = inner, beam = beam](const dvec2& f) {
                       return std::pow(litRadius(0.5 * inner, 0.5 * diameter, beam, glm::length(f)) / peak,
                                       2);
                   });
    }
}

TEST(AperturesOnDevice, PolygonsInAGaussianBeam) {
    const PolygonalAperture hexagon{scaled(optics::regularPolygon(6, 1.0), 3e-6)};
    for (const PolygonalAperture& polygon : {hexagon, PolygonalAperture{scaled(optics::ell(), 1.0)}}) {
        scene::Beam beam{};
        beam.profile = scene::BeamProfile::gaussian;
        beam.width = beam.height = 5.0 * um;
        const oracle::Opening opening(polygon, 2.0 / 0.55e-6, beam);
        const double peak = std::norm(opening.amplitude(dvec2(0.0)));
        compareLit(polygon, beam.width, 8,
                   [&](const dvec2& f) { return std::norm(opening.amplitude(f)) / peak; });
    }
}

TEST(AperturesOnDevice, Lattice) {
    const double wavelength_um = 0.55;
    for (const auto& [first, second] :
         {std::pair{dvec2(3.0, 0.0), dvec2(0.0, 2.0)}, {dvec2(3.0, 0.4), dvec2(-1.1, 2.7)}}) {
        for (const auto& [firstCount, secondCount] :
             {std::pair{1.0F, 1.0F}, {4.0F, 7.0F}, {1000.0F, 50.0F}, {100'000.0F, 3.0F}}) {
            std::vector<float> parameters{static_cast<float>(1.0 / wavelength_um)};
            dvec2 given[2];  // in wavelengths
            for (int i = 0; i < 2; ++i) {
                const dvec2 step_um = i == 0 ? first : second;
                const TwoFloats x = split(step_um.x), y = split(step_um.y);
                given[i] = double{parameters[0]} * dvec2(double{x.high} + x.low, double{y.high} + y.low);
                for (const float value : {x.high, y.high, x.low, y.low}) parameters.push_back(value);
            }
            parameters.push_back(firstCount);
            parameters.push_back(secondCount);
            // Half of the directions next to an order, in both.
            std::vector<vec2> directions = directionsInTwoDimensions(10.0);
            const double determinant = given[0].x * given[1].y - given[0].y * given[1].x;
            for (std::size_t i = 20; i < directions.size(); i += 2) {
                const double m = std::nearbyint(2.0 * directions[i].x) + directions[i - 1].x / firstCount;
                const double n = std::nearbyint(2.0 * directions[i].y) + directions[i - 1].y / secondCount;
                directions[i] = vec2(dvec2(m * given[1].y - n * given[0].y, n * given[0].x - m * given[1].x) /
                                     determinant);
            }
            std::vector<double> expected;
            for (const vec2& uv : directions) {
                double product = 1.0;
                const float counts[2] = {firstCount, secondCount};
                for (int i = 0; i < 2; ++i) {
                    // Sum of the phasors as a geometric series: numerator and denominator from the same long
                    // double.
                    const long double t = static_cast<long double>(uv.x) * given[i].x +
                                          static_cast<long double>(uv.y) * given[i].y;
                    const long double r = t - std::nearbyint(t), pi = std::numbers::pi_v<long double>;
                    if (r != 0.0L) {
                        const long double quotient =
                            std::sin(pi * r * counts[i]) / (counts[i] * std::sin(pi * r));
                        product *= static_cast<double>(quotient * quotient);
                    }
                }
                expected.push_back(product);
            }
            expectNear(evaluate(Probe::lattice, parameters, directions), expected, directions, kSineBound);
        }
    }
}

}  // namespace
}  // namespace fringe::testing
