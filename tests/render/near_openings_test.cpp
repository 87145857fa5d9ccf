// Rectangles, circles and rings from their near field to the far one, on the device against the sum of the
// waves from every point of the opening, each as long as its way is (Kirchhoff's integral, no approximation
// of the ways).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "oracle/grating.hpp"
#include "render/opening_scenes.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

constexpr std::uint32_t kSize = 640;
constexpr const char* kGreen =
    R"("diameter": "40 mm", "spectrum": { "type": "laser", "wavelength": "532 nm" })";

scene::Scene nearScene(const OpeningScene& given) {
    scene::Scene scene = parsed(given);
    gratingOf(scene).position = {0, 0, 0};
    scene.image.width = scene.image.height = kSize;
    return scene;
}

// The point of the wall that a pixel's middle shows.
glm::dvec3 shownBy(const scene::Scene& scene, std::uint32_t x, std::uint32_t y) {
    const double height = std::get<scene::Orthographic>(scene.camera.projection).height;
    const auto& plane = std::get<scene::Plane>(scene.objects.front().shape);
    const glm::dvec3 on(((x + 0.5) / kSize - 0.5) * height, (0.5 - (y + 0.5) / kSize) * height, 0.0);
    return {on.x, on.y, glm::dot(plane.point - on, plane.normal) / plane.normal.z};
}

glm::dvec3 expectedAt(const scene::Scene& scene, std::uint32_t x, std::uint32_t y) {
    const auto& plane = std::get<scene::Plane>(scene.objects.front().shape);
    return oracle::irradianceXyz(scene, 0, shownBy(scene, x, y), plane.normal, {{380.0, 0.8}, {780.0, 0.8}},
                                 100) /
           std::numbers::pi;
}

// The largest difference over a diagonal and a row, relative to the brightest pixel.
double deviation(const scene::Scene& scene, std::uint32_t step) {
    const image::Image device = renderOnDevice(scene);
    double peak = 0.0, worst = 0.0;
    for (const image::Pixel& pixel : device.pixels) peak = std::max(peak, largest(pixel));
    EXPECT_GT(peak, 0.0);
    for (std::uint32_t i = 1; i < kSize; i += step) {
        for (const std::uint32_t y : {i, kSize / 2}) {
            const glm::dvec3 expected = expectedAt(scene, i, y);
            const image::Pixel& is = device.at(i, y);
            const double error = std::max(
                {std::abs(is.x - expected.x), std::abs(is.y - expected.y), std::abs(is.z - expected.z)});
            worst = std::max(worst, error / peak);
        }
    }
    return worst;
}

class NearOpenings : public ::testing::TestWithParam<OpeningScene> {};

// What is left is Fresnel's quadratic phase, which the oracle does not have, the mean over the finite pixel,
// and 128 or fewer wavelengths.
TEST_P(NearOpenings, AreAsTheSumOfWavesHasThem) {
    EXPECT_LE(deviation(nearScene(GetParam()), 91), 2e-3);
}

constexpr const char* kObliqueWall = "[0.3, 0.2, 1]";
INSTANTIATE_TEST_SUITE_P(
    Kinds, NearOpenings,
    ::testing::Values(
        OpeningScene{"rectangle", R"({ "type": "rectangle", "width": "1 mm", "height": "3 mm" })", kGreen,
                     kWhite, 0.006},
        OpeningScene{"circle", R"({ "type": "circle", "diameter": "2 mm" })", kGreen, kWhite, 0.004},
        OpeningScene{"wideCircle", R"({ "type": "circle", "diameter": "6 mm" })", kGreen, kWhite, 0.008},
        OpeningScene{"ring", R"({ "type": "ring", "diameter": "3 mm", "inner_diameter": "1.2 mm" })", kGreen,
                     kWhite, 0.005},
        OpeningScene{
            "obliqueCircle", R"({ "type": "circle", "diameter": "3 mm" })",
            R"("diameter": "40 mm", "direction": [0.3, 0, -1], "spectrum": { "type": "laser", "wavelength": "532 nm" })",
            kWhite, 0.8, "", kObliqueWall},
        OpeningScene{"circleInDaylight", R"({ "type": "circle", "diameter": "2 mm" })",
                     R"("diameter": "40 mm")", kWhite, 0.004},
        OpeningScene{"rectangleInDaylight", R"({ "type": "rectangle", "width": "2 mm", "height": "1 mm" })",
                     R"("diameter": "40 mm")", kWhite, 0.004},
        OpeningScene{
            "inFocus", R"({ "type": "circle", "diameter": "8 mm" })",
            R"("diameter": "40 mm", "focus": "1 m", "spectrum": { "type": "laser", "wavelength": "532 nm" })",
            kWhite, 0.0004},
        OpeningScene{
            "outOfFocus", R"({ "type": "rectangle", "width": "4 mm", "height": "3 mm" })",
            R"("diameter": "40 mm", "focus": "1.25 m", "spectrum": { "type": "laser", "wavelength": "532 nm" })",
            kWhite, 0.002}),
    [](const auto& info) { return std::string(info.param.name); });

// From the far field to the near one: no step where one formula takes over from another.
TEST(NearOpeningsOnDevice, WalkThroughTheTransitionsWithoutASeam) {
    for (const char* shape : {R"({{ "type": "circle", "diameter": "{0} um" }})",
                              R"({{ "type": "ring", "diameter": "{0} um", "inner_diameter": "{1} um" }})",
                              R"({{ "type": "rectangle", "width": "{0} um", "height": "{1} um" }})"}) {
        for (double size_um = 80.0; size_um < 900.0; size_um *= 1.5) {
            const std::string aperture = fmt::format(fmt::runtime(shape), size_um, 0.4 * size_um);
            const double lobes = 4.0 * 0.532 / size_um;
            EXPECT_LE(deviation(nearScene({"", aperture.c_str(), kGreen, kWhite, lobes}), 191), 1e-3)
                << aperture;
        }
    }
}

// The mean over a block of pixels.
std::vector<double> blockMeans(const image::Image& picture, std::uint32_t blocks) {
    std::vector<double> means(std::size_t{blocks} * blocks, 0.0);
    const std::uint32_t edge = picture.width / blocks;
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x)
            means[y / edge * blocks + x / edge] += double{picture.at(x, y).y} / (edge * edge);
    }
    return means;
}

// One sample in the middle of each pixel against 256 pixels in its place, for pixels finer and coarser than
// fringes. An edge of the image is softened by a pixel in place of what it covers of this one.
TEST(NearOpeningsOnDevice, OneSampleIsTheMeanOverThePixel) {
    constexpr std::uint32_t kPixels = 20;
    for (const char* aperture : {R"({ "type": "circle", "diameter": "4 mm" })",
                                 R"({ "type": "ring", "diameter": "4 mm", "inner_diameter": "2 mm" })",
                                 R"({ "type": "rectangle", "width": "4 mm", "height": "3 mm" })"}) {
        for (const double height : {0.002, 0.006, 0.03}) {
            scene::Scene scene = nearScene({"", aperture, kGreen, kWhite, height});
            scene.image.width = scene.image.height = 16 * kPixels;
            const std::vector<double> exact = blockMeans(renderOnDevice(scene), kPixels);
            scene.image.width = scene.image.height = kPixels;
            const std::vector<double> is = blockMeans(renderOnDevice(scene), kPixels);
            const double peak = *std::max_element(exact.begin(), exact.end());
            double sum = 0.0, sumExact = 0.0, worst = 0.0;
            for (std::size_t i = 0; i < is.size(); ++i) {
                sum += is[i];
                sumExact += exact[i];
                worst = std::max(worst, std::abs(is[i] - exact[i]) / peak);
            }
            std::printf("%s %g: worst %g, power %g\n", aperture, height, worst, sum / sumExact - 1.0);
        }
    }
}

// A source of some size blurs by what it fills at the distance of the wall: as many pictures of points of it.
TEST(NearOpeningsOnDevice, SourceOfSomeSizeBlurs) {
    constexpr int kPoints = 6;
    for (const double size : {3e-4}) {
        for (const char* aperture : {R"({ "type": "circle", "diameter": "3 mm" })",
                                     R"({ "type": "rectangle", "width": "3 mm", "height": "2 mm" })"}) {
            scene::Scene scene = nearScene({"", aperture, kGreen, kWhite, 0.005});
            scene.image.width = scene.image.height = 80;
            image::Image sum = renderOnDevice(scene);
            for (image::Pixel& pixel : sum.pixels) pixel.y = 0.0F;
            for (int i = 0; i < kPoints; ++i) {
                for (int j = 0; j < kPoints; ++j) {
                    const glm::dvec2 tilt =
                        size * glm::dvec2((i + 0.5) / kPoints - 0.5, (j + 0.5) / kPoints - 0.5);
                    gratingOf(scene).beam.direction = glm::normalize(glm::dvec3(tilt, -1.0));
                    const image::Image one = renderOnDevice(scene, {.values = render::Values::inUniforms});
                    for (std::size_t k = 0; k < one.pixels.size(); ++k)
                        sum.pixels[k].y += one.pixels[k].y / (kPoints * kPoints);
                }
            }
            gratingOf(scene).beam.direction = {0, 0, -1};
            gratingOf(scene).beam.angularSize = size * units::rad;
            const image::Image is = renderOnDevice(scene);
            double peak = 0.0, worst = 0.0;
            for (std::size_t k = 0; k < is.pixels.size(); ++k) {
                peak = std::max(peak, double{sum.pixels[k].y});
                worst = std::max(worst, std::abs(double{is.pixels[k].y} - double{sum.pixels[k].y}));
            }
            std::printf("%s %g: worst %g\n", aperture, size, worst / peak);
        }
    }
}

}  // namespace
}  // namespace fringe::testing
