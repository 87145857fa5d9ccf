// Irradiance from every kind of light against closed forms.
#include "oracle/lighting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "oracle/axes.hpp"
#include "oracle/emitters.hpp"
#include "scenes.hpp"

namespace fringe::oracle {
namespace {

using namespace units;
using std::numbers::pi;

constexpr Receiver kOriginFacingZ{{0.0, 0.0, 0.0}, kZ};

World with(const std::vector<scene::Light>& lights) {
    scene::Scene scene;
    scene.lights = lights;
    return makeWorld(scene);
}

template <class Model>
scene::Light light(const Model& model) {
    return {"", Rgb(1.0), d65(), model};
}

// W/m^2 of D65, which is its Y.
double irradiance(const World& world, const Receiver& receiver, const Sampler& sampler) {
    return fromLights(world, receiver, {}, sampler, 0).y;
}

// Of lights that need no samples.
double exactly(const World& world, const Receiver& receiver) {
    return irradiance(world, receiver, Sampler(0, 0, 0, 1));
}

// Mean over 400 pixels of 64 samples each, and the standard error that the scatter of the pixels shows.
struct Estimate {
    double mean;
    double error;
};

Estimate estimated(const World& world, const Receiver& receiver) {
    constexpr int kPixels = 400;
    constexpr std::uint32_t kSamples = 64;
    double sum = 0.0;
    double squares = 0.0;
    for (int pixel = 0; pixel < kPixels; ++pixel) {
        double mean = 0.0;
        for (std::uint32_t i = 0; i < kSamples; ++i) {
            mean += irradiance(world, receiver, Sampler(1, pixel, i, kSamples)) / kSamples;
        }
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / kPixels;
    return {mean, std::sqrt(std::max(0.0, squares / kPixels - mean * mean) / kPixels)};
}

// A z-test: 4.5 standard errors are exceeded by chance once in 150000. The scatter must be small enough for
// it to mean something, half a percent. Rounding is allowed for where there is no scatter at all.
void expectIrradiance(const World& world, const Receiver& receiver, double expected) {
    const Estimate estimate = estimated(world, receiver);
    EXPECT_LT(estimate.error, 5e-3 * expected);
    EXPECT_NEAR(estimate.mean, expected, 4.5 * estimate.error + kRounding * expected);
}

TEST(PointLight, FollowsInverseSquareAndCosine) {
    const World world = with({light(scene::PointLight{{3.0, 0.0, 4.0}, 100.0 * W})});
    const double expected = 100.0 / (4.0 * pi * 25.0) * 0.8;
    EXPECT_NEAR(exactly(world, kOriginFacingZ), expected, kRounding);
    EXPECT_EQ(exactly(world, {{0.0, 0.0, 0.0}, -kZ}), 0.0) << "the other side";
    EXPECT_EQ(exactly(world, {{3.0, 0.0, 4.0}, kZ}), 0.0) << "the lamp itself";
}

TEST(SpotLight, SendsOutItsPower) {
    for (const double inner : {10.0, 25.0, 40.0}) {
        const World world = with({light(scene::SpotLight{dvec3(0.0), kX, 40.0 * deg, inner * deg, 7.0 * W})});
        // Flux through a sphere of 2 m about the lamp, by the midpoint rule in the cosine.
        double power = 0.0;
        constexpr int kSteps = 20'000;
        for (int i = 0; i < kSteps; ++i) {
            const double cosine = (i + 0.5) / kSteps;
            const dvec3 out(cosine, std::sqrt(1.0 - cosine * cosine), 0.0);
            power += exactly(world, {2.0 * out, -out}) * 2.0 * pi * 4.0 / kSteps;
        }
        // The sharp edge falls within one step of a cone that is 4700 steps wide.
        EXPECT_NEAR(power, 7.0, 7.0 / 4000.0);
    }
}

TEST(SpotLight, IsFullInsideAndDarkOutside) {
    const World world =
        with({light(scene::SpotLight{{0.0, 0.0, 1.0}, -kZ, 60.0 * deg, 30.0 * deg, 1.0 * W})});
    const double axial = 1.0 / (2.0 * pi * (1.0 - 0.5 * (std::cos(60.0 * deg.si) + std::cos(30.0 * deg.si))));
    const auto at = [&](double angle) {
        const double radians = angle * deg.si;
        return exactly(world, {{std::tan(radians), 0.0, 0.0}, kZ}) / std::pow(std::cos(radians), 3);
    };
    EXPECT_NEAR(at(0.0), axial, kRounding);
    EXPECT_NEAR(at(29.9), axial, kRounding);
    EXPECT_NEAR(at(std::acos(0.5 * (std::cos(60.0 * deg.si) + std::cos(30.0 * deg.si))) / deg.si),
                0.5 * axial, kRounding);
    EXPECT_EQ(at(60.1), 0.0);
}

TEST(DirectionalLight, FollowsTheCosine) {
    const World world = with({light(scene::DirectionalLight{{0.6, 0.0, -0.8}, 1000.0 * W_per_m2})});
    EXPECT_NEAR(exactly(world, kOriginFacingZ), 800.0, 1000.0 * kRounding);
    EXPECT_EQ(exactly(world, {{0.0, 0.0, 0.0}, -kZ}), 0.0);
}

// Howell, "A catalog of radiation configuration factors", B-3: an element under a corner of a parallel
// rectangle.
TEST(AreaLight, RectangleOnItsAxis) {
    const double a = 0.7 / 0.9;
    const double b = 0.4 / 0.9;
    const double p = std::sqrt(1.0 + a * a);
    const double q = std::sqrt(1.0 + b * b);
    const double corner = (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2.0 * pi);
    const scene::Rectangle shape{{0.0, 0.0, 0.9}, {0.7, 0.0, 0.0}, {0.0, -0.4, 0.0}};  // shines down
    const double radiance = 5.0 / (pi * 4.0 * 0.7 * 0.4);
    expectIrradiance(with({light(scene::AreaLight{shape, 5.0 * W, false})}), kOriginFacingZ,
                     pi * radiance * 4.0 * corner);
}

TEST(AreaLight, DiscAndRingOnTheirAxis) {
    for (const double hole : {0.0, 0.6}) {
        const scene::Disc shape{{0.0, 0.0, 0.5}, -kZ, 0.8, hole};
        const double radiance = 3.0 / (pi * pi * (0.64 - hole * hole));
        const double seen = 0.64 / (0.64 + 0.25) - hole * hole / (hole * hole + 0.25);
        expectIrradiance(with({light(scene::AreaLight{shape, 3.0 * W, false})}), kOriginFacingZ,
                         pi * radiance * seen);
    }
}

TEST(AreaLight, SphereAboveTheHorizon) {
    const scene::Sphere shape{{0.0, 1.2, 1.6}, 0.9};  // 2 m away, 37 degrees from the normal
    const double radiance = 4.0 / (pi * 4.0 * pi * 0.81);
    const World world = with({light(scene::AreaLight{shape, 4.0 * W, false})});
    expectIrradiance(world, kOriginFacingZ, pi * radiance * 0.8 * 0.81 / 4.0);
    EXPECT_NEAR(exactly(world, kOriginFacingZ), pi * radiance * 0.8 * 0.81 / 4.0, kRounding)
        << "the middle of a sphere stands exactly for all of it";
}

// Half of the cone of half angle A lies above the horizon: A - sin A cos A, by Stokes' theorem over its edge.
TEST(AreaLight, SphereOnTheHorizon) {
    const scene::Sphere shape{{2.0, 0.0, 0.0}, 1.5};
    const double angle = std::asin(0.75);
    const double radiance = 4.0 / (pi * 4.0 * pi * 2.25);
    expectIrradiance(with({light(scene::AreaLight{shape, 4.0 * W, false})}), kOriginFacingZ,
                     radiance * (angle - std::sin(angle) * std::cos(angle)));
}

TEST(AreaLight, SidesThatShine) {
    const scene::Sphere around{{0.1, 0.2, 0.3}, 2.0};
    const double radiance = 1.0 / (pi * 16.0 * pi);
    expectIrradiance(with({light(scene::AreaLight{around, 1.0 * W, true})}), kOriginFacingZ, pi * radiance);
    EXPECT_EQ(exactly(with({light(scene::AreaLight{around, 1.0 * W, false})}), kOriginFacingZ), 0.0);

    const scene::Rectangle facingUp = squareFacingZ(0.5, 0.1);
    EXPECT_EQ(exactly(with({light(scene::AreaLight{facingUp, 1.0 * W, false})}), kOriginFacingZ), 0.0);
    EXPECT_GT(exactly(with({light(scene::AreaLight{facingUp, 1.0 * W, true})}), kOriginFacingZ), 0.0);
}

TEST(AreaLight, EmissiveObjectsShineAlike) {
    const scene::Disc shape{{0.0, 0.0, 0.5}, -kZ, 0.8, 0.0};
    scene::Scene scene;
    addObject(scene, shape, glowing(2.0));
    expectIrradiance(makeWorld(scene), kOriginFacingZ, pi * 2.0 * 0.64 / (0.64 + 0.25));

    scene::Scene box;
    addObject(box, scene::Box{{0.0, 0.0, 2.0}, kX, kY, kZ}, glowing(2.0));
    EXPECT_EQ(exactly(makeWorld(box), kOriginFacingZ), 0.0) << "other shapes only glow";
}

TEST(Environment, FillsTheHemisphere) {
    World world = with({light(scene::EnvironmentLight{1.0 * W_per_m2_sr})});
    expectIrradiance(world, kOriginFacingZ, pi);
    // A plane through the point's vertical hides half of the sky.
    world.surfaces.push_back({scene::Plane{{-1e-6, 0.0, 0.0}, kX}, Mirror{scene::Metal::gold}});
    expectIrradiance(world, kOriginFacingZ, 0.5 * pi);
}

TEST(Shadows, AreCastByEverythingButTheLightItself) {
    const scene::AreaLight lamp{scene::Disc{{0.0, 0.0, 2.0}, -kZ, 0.2, 0.0}, 1.0 * W, false};
    const double open = exactly(with({light(lamp)}), kOriginFacingZ);
    EXPECT_GT(open, 0.0);

    scene::Scene glass;
    addLight(glass, lamp);
    addObject(glass, scene::Sphere{{0.0, 0.0, 1.0}, 0.2}, scene::Dielectric{1.5});
    EXPECT_EQ(exactly(makeWorld(glass), kOriginFacingZ), 0.0) << "glass";

    scene::Scene ceiling;  // that the lamp is let into
    addLight(ceiling, lamp);
    addObject(ceiling, scene::Plane{{0.0, 0.0, 2.0}, -kZ}, grey(0.5));
    EXPECT_DOUBLE_EQ(exactly(makeWorld(ceiling), kOriginFacingZ), open);

    const scene::PointLight bulb{{0.0, 0.0, 3.0}, 1.0 * W};
    EXPECT_DOUBLE_EQ(exactly(with({light(lamp), light(bulb)}), kOriginFacingZ), open)
        << "the lamp's shape hides the bulb";
}

// The distance to a slanted wall and to the lamp on it agree but for rounding, which falls either way.
TEST(Shadows, LampsMayLieOnWalls) {
    const dvec3 normal = glm::normalize(dvec3(0.3, -0.2, -1.0));
    const dvec3 lamp(0.1, 0.7, 2.3);
    World world;
    world.surfaces.push_back({scene::Plane{lamp, normal}, Mirror{scene::Metal::gold}});
    for (double x = -1.0; x < 1.0; x += 0.013) EXPECT_TRUE(sees(world, {x, 0.3 * x, 0.0}, kZ, lamp)) << x;
}

// Towards a sphere's rim the nearest point of it is known to half the digits only.
TEST(Shadows, LampsDoNotHideTheirOwnRim) {
    World world;
    world.surfaces.push_back(
        {scene::Sphere{{0.3, 0.4, 2.0}, 0.7}, Emitter{1.0, world.palette.addSpectrum(d65()), false}});
    const Surface& lamp = world.surfaces.front();
    for (double y = 0.0; y < 1.0; y += 0.013) {
        const auto point = pointOn(lamp.shape, false, dvec3(0.0), {1.0, y});
        ASSERT_TRUE(point);
        EXPECT_TRUE(sees(world, dvec3(0.0), kZ, point->position, &lamp)) << y;
    }
}

TEST(ThesisGratingLight, ReachesBothSidesAndIsShadowed) {
    scene::Scene scene;
    addLight(scene, gratingAt({0.0, 0.0, 2.0}, -kZ, kY), {1.0, 0.5, 0.0});
    World world = makeWorld(scene);
    const Rgb full(1.0, 0.5, 0.0);
    const auto valueAt = [&](const Receiver& receiver) {
        return rgbOf(fromThesisGratings(world, receiver, {}).xyz);
    };
    EXPECT_LT(glm::length(valueAt(kOriginFacingZ) - full), kRounding);
    EXPECT_LT(glm::length(valueAt({{0.0, 0.0, 0.0}, -kZ}) - full), kRounding)
        << "the listing has no receiver's cosine";

    // The wall that carries the grating is no obstacle, whatever is in between is.
    world.surfaces.push_back({scene::Plane{{0.0, 0.0, 2.0}, -kZ}, Mirror{scene::Metal::gold}});
    EXPECT_LT(glm::length(valueAt(kOriginFacingZ) - full), kRounding);
    world.surfaces.push_back({scene::Sphere{{0.0, 0.0, 1.0}, 0.1}, scene::Dielectric{1.5}});
    EXPECT_EQ(valueAt(kOriginFacingZ), Rgb(0.0));
}

}  // namespace
}  // namespace fringe::oracle
