// Gratings as lights: their place in the scene, their colours, and the source's size.
#include "oracle/grating.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "gratings.hpp"
#include "oracle/axes.hpp"
#include "oracle/lighting.hpp"
#include "oracle/opening_share.hpp"
#include "oracle/quadrature.hpp"
#include "oracle/reference.hpp"
#include "scenes.hpp"

namespace fringe::oracle {
namespace {

using namespace units;
using glm::dvec2;
using optics::Slits;
using scene::BeamProfile;
using std::numbers::pi;

const optics::Spectrum kGreen{{}, {{550.0 * nm, 1.0, 0.0 * nm}}};
const optics::Curve kWhite{{380.0, 1.0}, {780.0, 1.0}};
const optics::Curve kRed{{380.0, 0.02}, {580.0, 0.02}, {620.0, 0.8}, {780.0, 0.9}};

Xyz color(const scene::Grating& grating, const dvec3& position, const optics::Curve& reflectance = kWhite,
          std::size_t steps = 400) {
    return Grating(grating, d65()).color(position, -kZ, {reflectance, {}, filmResponse}, steps);
}

// I(0) = power area / (wavelength^2 share), and Airy's first dark ring.
TEST(Grating, CircleSendsOutAirysPattern) {
    const optics::CircularAperture circle{20.0 * um, 0.0 * um};
    scene::Grating grating = lit(circle, BeamProfile::flat, 2.0 * mm);
    grating.beam.power = 5e-3 * W;
    const Grating light(grating, kGreen);
    const double passing = 5e-3 * 1e-4;  // (20 um / 2 mm)^2
    const double share = propagatingShare(circle, 540e-9, dvec2(0.0)) * 0.5 +
                         propagatingShare(circle, 560e-9, dvec2(0.0)) * 0.5;
    const double axial = passing * pi * 1e-10 / (550e-9 * 550e-9) / share;
    EXPECT_NEAR(light.irradiance(2.0 * kZ, -kZ, 550.0), axial / 4.0, 1e-12 * axial);
    const double dark = 1.219669891 * 550e-9 / 20e-6;
    EXPECT_LT(light.irradiance({2.0 * dark, 0.0, 2.0 * std::sqrt(1.0 - dark * dark)}, -kZ, 550.0),
              1e-12 * axial);
    EXPECT_LT(light.irradiance({0.0, 2.0 * dark, 2.0 * std::sqrt(1.0 - dark * dark)}, -kZ, 550.0),
              1e-12 * axial);
}

// Over the hemisphere, which is a box as good as any, every opening sends out its power: the beam's times the
// open share of its area, or as stated.
TEST(Grating, OpeningsSendOutTheirPower) {
    const std::vector<optics::Aperture> apertures{
        optics::RectangularAperture{1.5 * um, 0.8 * um}, optics::CircularAperture{2.0 * um, 1.0 * um},
        optics::PolygonalAperture{{{-1e-6, -0.6e-6}, {1.2e-6, -0.2e-6}, {-0.2e-6, 0.8e-6}}},
        optics::LatticeAperture{
            optics::RectangularAperture{0.7 * um, 0.5 * um}, {1.1e-6, 0.2e-6}, {0.0, 0.9e-6}, 2, 3},
        optics::MaskAperture{3, 2, 0.6 * um, {1.0F, 0.5F, 0.0F, 0.0F, 1.0F, 1.0F}}};
    const std::vector<double> areas{1.2e-12, 0.75 * pi * 1e-12, 1.38e-12, 6.0 * 0.35e-12, 3.25 * 0.36e-12};
    for (std::size_t i = 0; i < apertures.size(); ++i) {
        scene::Grating grating = lit(apertures[i], BeamProfile::rectangle, 10.0 * um);
        grating.beam.direction = towards(0.3, -0.1);
        const auto power = [&] {
            const Grating light(grating, kGreen);
            double sum = 0.0;
            forNodes(0.0, 1.0, 5, [&](double z, double dz) {
                for (int k = 0; k < 160; ++k) {
                    const double angle = 2.0 * pi * k / 160;
                    const dvec3 out(std::sqrt(1.0 - z * z) * dvec2(std::cos(angle), std::sin(angle)), z);
                    sum += light.irradiance(0.5 * out, -out, 560.0) * 0.25 * dz * 2.0 * pi / 160;
                }
            });
            return sum;
        };
        const double expected = areas[i] / 1e-10;
        EXPECT_NEAR(power(), expected, 1e-6 * expected) << i;
        grating.efficiency = 0.4;
        EXPECT_NEAR(power(), 0.4, 4e-7) << i;
    }
}

// A wide Gaussian is as strong as at its middle, P 2 / (pi w^2); a narrow one less: for a square opening,
// erf^2.
TEST(Grating, OpeningsInAGaussianBeam) {
    scene::Grating grating =
        lit(optics::RectangularAperture{100.0 * um, 100.0 * um}, BeamProfile::gaussian, 0.4 * mm);
    const double inGaussian = Grating(grating, kGreen).irradiance(kZ, -kZ, 560.0);
    grating.efficiency = std::pow(std::erf(std::sqrt(2.0) * 50e-6 / 200e-6), 2);
    EXPECT_NEAR(inGaussian / Grating(grating, kGreen).irradiance(kZ, -kZ, 560.0), 1.0, 1e-9);
}

TEST(Grating, MovesWithItsFrame) {
    scene::Grating grating = lit(Slits{3, 1.0 * um, 2.0 * um}, BeamProfile::flat, 2.0 * mm);
    grating.beam.direction = towards(0.1, 0.2);
    const dvec3 point(0.3, 0.15, 0.7);
    const double expected = Grating(grating, kGreen).irradiance(point, -kZ, 550.0);

    // x is slitDirection x normal.
    scene::Grating moved = grating;
    const dvec3 normal = glm::normalize(dvec3(1.0, 2.0, -2.0));
    const dvec3 along = glm::normalize(dvec3(2.0, 0.0, 1.0));
    const dvec3 across = glm::cross(along, normal);
    const auto turned = [&](const dvec3& v) { return v.x * across + v.y * along + v.z * normal; };
    moved.position = {4.0, -1.0, 2.0};
    moved.normal = normal;
    moved.slitDirection = along;
    moved.beam.direction = turned(grating.beam.direction);
    const Grating light(moved, kGreen);
    EXPECT_NEAR(light.irradiance(moved.position + turned(point), -normal, 550.0), expected, 1e-6 * expected);

    // A reflected beam leaves on the side that it came from.
    moved.beam.direction = turned({0.1, 0.2, -grating.beam.direction.z});
    EXPECT_NEAR(Grating(moved, kGreen).irradiance(moved.position + turned(point), -normal, 550.0), expected,
                1e-6 * expected);
    EXPECT_EQ(light.irradiance(moved.position - turned(point), normal, 550.0), 0.0) << "behind";
    EXPECT_FALSE(light.sourceFor(moved.position - turned(point)));
}

// Where the light comes from: along the slits from where the beam is, across from the middle.
TEST(Grating, ShadowsFollowTheBeam) {
    scene::Grating grating = lit(Slits{3, 1.0 * um, 2.0 * um}, BeamProfile::flat, 4.0 * mm);
    const Grating light(grating, kGreen);
    EXPECT_LT(glm::length(*light.sourceFor({0.2, 0.5e-3, 1.0}) - dvec3(0.0, 0.5e-3, 0.0)), 1e-15);
    EXPECT_LT(glm::length(*light.sourceFor({0.2, -0.7, 1.0}) - dvec3(0.0, -2e-3, 0.0)), 1e-15);

    scene::Scene scene;
    addLight(scene, grating);
    World world = makeWorld(scene);
    const Receiver receiver{{0.1, 0.0, 1.0}, -kZ};
    const Xyz open = fromGratings(world, receiver, {});
    EXPECT_GT(open.y, 0.0);
    EXPECT_EQ(fromGratings(world, {{0.1, 0.0, 1.0}, kZ}, {}), Xyz(0.0)) << "the wall's other side";
    world.surfaces.push_back({scene::Plane{dvec3(0.0), kZ}, Mirror{scene::Metal::gold}});
    EXPECT_EQ(fromGratings(world, receiver, {}), open) << "the plate that carries the slits";
    world.surfaces.push_back({scene::Sphere{{0.05, 0.0, 0.5}, 0.01}, Mirror{scene::Metal::gold}});
    EXPECT_EQ(fromGratings(world, receiver, {}), Xyz(0.0));
}

TEST(Grating, ColourIsTheSumOverItsWavelengths) {
    const scene::Grating grating = lit(Slits{4, 1.0 * um, 2.0 * um}, BeamProfile::flat, 2.0 * mm);
    const dvec3 point(0.28, 0.3e-3, 0.9);
    const Grating line(grating, kGreen);
    EXPECT_LT(glm::length(line.color(point, -kZ, {kWhite, {}, filmResponse}) -
                          line.irradiance(point, -kZ, 550.0) * filmResponse(550.0)),
              1e-15);
    const Grating white(grating, d65());
    Throughput path;
    path.passShare(0.7);
    path.reflectFrom(scene::Metal::copper, 0.8);
    Xyz expected(0.0);
    for (const SpectralSample& sample : sampled(d65(), 4000)) {
        const double left = path.at(sample.wavelength_nm) * curveAt(kRed, sample.wavelength_nm);
        expected += sample.power * left * white.irradiance(point, -kZ, sample.wavelength_nm) *
                    filmResponse(sample.wavelength_nm);
    }
    EXPECT_LT(glm::length(white.color(point, -kZ, {kRed, path, filmResponse}) - expected),
              1e-4 * glm::length(expected));
}

// So many wavelengths that more change nothing: with many slits orders pass a wall like spectral lines.
TEST(Grating, ColourHasEnoughWavelengths) {
    for (const std::uint32_t count : {1U, 50U, 300U}) {
        const scene::Grating grating =
            lit(Slits{count, 0.5 * um, 1.6 * um}, BeamProfile::rectangle, 4.0 * mm);
        double worst = 0.0;
        double peak = 0.0;
        for (const double x : {0.2, 0.4123}) {
            const Xyz value = color(grating, {x, 0.1e-3, 1.0});
            const Xyz finer = color(grating, {x, 0.1e-3, 1.0}, kWhite, 3600);
            worst = std::max(worst, glm::length(value - finer));
            peak = std::max(peak, glm::length(finer));
        }
        EXPECT_LT(worst, 2e-4 * peak) << count;
    }
}

// An order in white light is a spectrum, red outside, and a red wall is not a grey one times a colour.
TEST(Grating, OrdersAreSpectra) {
    const scene::Grating grating = lit(Slits{50, 0.5 * um, 1.6 * um}, BeamProfile::flat, 2.0 * mm);
    const auto at = [&](double wavelength_nm, const optics::Curve& reflectance) {
        return color(grating, {std::tan(std::asin(wavelength_nm / 1600.0)), 0.0, 1.0}, reflectance);
    };
    const Xyz blue = at(450.0, kWhite);
    const Xyz red = at(640.0, kWhite);
    EXPECT_GT(blue.z, 3.0 * blue.y);
    EXPECT_GT(red.x, 1.5 * red.y);
    EXPECT_NEAR(at(640.0, kRed).x / red.x, curveAt(kRed, 640.0), 0.05);
    EXPECT_NEAR(at(450.0, kRed).z / blue.z, curveAt(kRed, 450.0), 0.01);
}

// A source of some size is many points beside each other: what each sends falls on a shifted place.
TEST(Grating, WideSourcesBlurThePattern) {
    scene::Grating grating = lit(Slits{8, 1.0 * um, 4.0 * um}, BeamProfile::flat, 2.0 * mm);
    grating.beam.angularSize = 9.3e-3 * rad;
    const Grating wide(grating, kGreen);
    scene::Grating point = grating;
    point.beam.angularSize = 0.0 * rad;
    double peak = 0.0;
    double worst = 0.0;
    for (const double x : {0.0, 0.01, 0.1385}) {
        for (const double y : {0.0, 3.5e-3, 5.3e-3}) {
            double mean = 0.0;
            constexpr int kCount = 60;
            for (int i = 0; i < kCount * kCount; ++i) {
                const int row = i / kCount;
                const int column = i % kCount;
                point.beam.direction =
                    towards(9.3e-3 * ((column + 0.5) / kCount - 0.5), 9.3e-3 * ((row + 0.5) / kCount - 0.5));
                mean += Grating(point, kGreen).irradiance({x, y, 1.0}, -kZ, 550.0) / (kCount * kCount);
            }
            const double here = wide.irradiance({x, y, 1.0}, -kZ, 550.0);
            peak = std::max(peak, here);
            worst = std::max(worst, std::abs(here - mean));
        }
    }
    // Either sum has a direction or more to each of Fresnel's fringes, and is as good as their height times
    // that over the fringes of an edge.
    EXPECT_LT(worst, 1e-2 * peak);
}

TEST(Grating, IsOneLightAmongOthersInAPicture) {
    scene::Scene scene = emptyScene(5);
    addObject(scene, squareFacingZ(0.0, 10.0), scene::Diffuse{kRed});
    addLight(scene, scene::PointLight{2.0 * kZ, 1.0 * W});
    const std::atomic<bool> never = false;
    std::vector<image::Pixel> without(25);
    ASSERT_TRUE(Reference(scene).render(0, 5, without, 2, never));

    scene::Grating grating = lit(Slits{2, 1.0 * um, 3.0 * um}, BeamProfile::gaussian, 500.0 * mm);
    grating.position = kZ;
    grating.normal = -kZ;
    grating.beam.direction = -kZ;
    grating.beam.power = 1e7 * W;
    addLight(scene, grating);
    std::vector<image::Pixel> with(25);
    ASSERT_TRUE(Reference(scene).render(0, 5, with, 2, never));
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 5; ++x) {
            const dvec3 point(0.8 * (x - 2), 0.8 * (2 - y), 0.0);
            const Xyz expected = irradianceXyz(scene, 1, point, kZ, kRed) / pi;
            const std::size_t i = static_cast<std::size_t>(y) * 5 + static_cast<std::size_t>(x);
            const Xyz added(with[i].x - without[i].x, with[i].y - without[i].y, with[i].z - without[i].z);
            EXPECT_LT(glm::length(added - expected), 1e-5 * (glm::length(expected) + 1.0)) << x << ' ' << y;
        }
    }
}

}  // namespace
}  // namespace fringe::oracle
