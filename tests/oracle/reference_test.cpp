// Whole pictures: the same pixels however they are made, and an end when one is asked for.
#include "oracle/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include "oracle/axes.hpp"
#include "oracle/thesis.hpp"
#include "scenes.hpp"

namespace fringe::oracle {
namespace {

using namespace units;
using image::Pixel;

const std::atomic<bool> kNever = false;

std::vector<Pixel> rendered(const scene::Scene& scene, unsigned threads) {
    std::vector<Pixel> pixels(std::size_t{scene.image.width} * scene.image.height);
    EXPECT_TRUE(Reference(scene).render(0, scene.image.height, pixels, threads, kNever));
    return pixels;
}

bool same(const Pixel& a, const Pixel& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.nonFinite == b.nonFinite;
}

bool same(const std::vector<Pixel>& a, const std::vector<Pixel>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Pixel& p, const Pixel& q) { return same(p, q); });
}

// Something of everything that draws samples: lens, area light, sky, glass.
scene::Scene busyScene() {
    scene::Scene scene = emptyScene(24);
    scene.image.samples = 6;
    scene.camera.projection = scene::Perspective{60.0 * deg, scene::ThinLens{50.0 * mm, 2.0 * m}};
    addObject(scene, scene::Plane{{0.0, -1.0, 0.0}, kY}, grey(0.7));
    addObject(scene, scene::Sphere{{0.4, 0.0, 0.0}, 0.6}, scene::Dielectric{1.5});
    addLight(scene, scene::AreaLight{scene::Sphere{{-0.5, 1.0, 0.0}, 0.3}, 30.0 * W, false});
    addLight(scene, scene::EnvironmentLight{0.2 * W_per_m2_sr});
    addLight(scene, gratingAt({0.0, 0.5, 0.0}, -kY, kZ));
    return scene;
}

TEST(Reference, PixelsDependOnNeitherThreadsNorBands) {
    const scene::Scene scene = busyScene();
    const std::vector<Pixel> whole = rendered(scene, 1);
    EXPECT_TRUE(same(whole, rendered(scene, 3)));

    const Reference reference(scene);
    std::vector<Pixel> bands(whole.size());
    for (std::uint32_t row = 0; row < 24; row += 7) {
        const std::uint32_t count = std::min(7U, 24U - row);
        EXPECT_TRUE(reference.render(row, count, std::span(bands).subspan(row * 24, count * 24), 2, kNever));
    }
    EXPECT_TRUE(same(whole, bands));
}

TEST(Reference, TheSeedChangesTheNoiseAlone) {
    scene::Scene scene = busyScene();
    const std::vector<Pixel> one = rendered(scene, 2);
    scene.image.seed = 1;
    const std::vector<Pixel> two = rendered(scene, 2);
    EXPECT_FALSE(same(one, two));
    double difference = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        difference += one[i].y - two[i].y;
        squares += std::pow(one[i].y - two[i].y, 2);
    }
    // The pixels' differences are independent: 4.5 standard errors of their sum.
    EXPECT_LT(std::abs(difference), 4.5 * std::sqrt(squares));
}

TEST(Reference, GratingOnAWallIsTheFormulaTimesColourAndPower) {
    scene::Scene scene = emptyScene(41);
    addObject(scene, squareFacingZ(0.0, 10.0), grey(0.75));
    scene::ThesisGrating grating = gratingAt(kZ, -kZ, kY);
    grating.power = 3.0 * W;
    addLight(scene, grating, {1.0, 0.5, 0.25});

    const std::vector<Pixel> picture = rendered(scene, 2);
    for (int y = 0; y < 41; ++y) {
        for (int x = 0; x < 41; ++x) {
            const dvec3 point(2.0 * (2.0 * (x + 0.5) / 41.0 - 1.0), 2.0 * (1.0 - 2.0 * (y + 0.5) / 41.0),
                              0.0);
            const Rgb expected = 3.0 * Rgb(1.0, 0.5, 0.25) * gratingValue(grating, point);
            const Pixel& pixel = picture[y * 41 + x];
            // Pixels are single precision, up to 3, and the matrix has elements of up to 3.2.
            EXPECT_LT(glm::length(rgbOf(Xyz(pixel.x, pixel.y, pixel.z)) - expected), 3e-6) << x << ' ' << y;
        }
    }
}

TEST(Reference, OnePixelIsNotANumberAsPrinted) {
    scene::Scene scene = emptyScene(5);
    addObject(scene, squareFacingZ(0.0, 10.0), grey(0.75));
    addLight(scene, gratingAt(kZ, -kZ, kY, scene::Faults::asPrinted));
    addLight(scene, scene::EnvironmentLight{1.0 * W_per_m2_sr});
    const std::vector<Pixel> picture = rendered(scene, 1);
    EXPECT_TRUE(same(picture[2 * 5 + 2], Pixel{0.0F, 0.0F, 0.0F, true}));
    EXPECT_FALSE(picture[2 * 5 + 1].nonFinite);
    EXPECT_GT(picture[2 * 5 + 1].y, 0.0F);
}

// A film of radiance or irradiance counts watts, whatever their colour.
TEST(Reference, FilmsOfWatts) {
    scene::Scene scene = emptyScene(5);
    addObject(scene, squareFacingZ(0.0, 10.0), scene::Diffuse{{{380.0, 0.0}, {780.0, 1.0}}});
    addLight(scene, scene::DirectionalLight{-kZ, 3.0 * W_per_m2});
    scene.lights[0].spectrum = {{}, {{480.0 * nm, 1.0, 0.0 * nm}}};
    const auto middle = [&](image::Quantity quantity) {
        std::vector<Pixel> pixels(25);
        EXPECT_TRUE(Reference(scene, quantity).render(0, 5, pixels, 1, kNever));
        return pixels[12].y;
    };
    EXPECT_NEAR(middle(image::Quantity::radiance), 0.25 * 3.0 / std::numbers::pi, 1e-7);
    EXPECT_NEAR(middle(image::Quantity::irradiance), 3.0, 1e-6);
    EXPECT_NEAR(middle(image::Quantity::color), 0.25 * 3.0 / std::numbers::pi * filmResponse(480.0).y, 1e-7);
}

TEST(Reference, StopsWhenAskedTo) {
    scene::Scene scene = busyScene();
    scene.image.samples = 65536;  // minutes of work
    const Reference reference(scene);
    std::vector<Pixel> pixels(24 * 24);
    std::atomic<bool> cancelled = false;

    std::chrono::steady_clock::time_point asked;
    const std::jthread user([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        asked = std::chrono::steady_clock::now();
        cancelled = true;
    });
    EXPECT_FALSE(reference.render(0, 24, pixels, 2, cancelled));
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::milliseconds(500));
    EXPECT_FALSE(reference.render(0, 24, pixels, 2, cancelled)) << "before it began";
}

}  // namespace
}  // namespace fringe::oracle
