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

constexpr const char* kGreen =
    R"("diameter": "40 mm", "spectrum": { "type": "laser", "wavelength": "532 nm" })";

scene::Scene nearScene(const OpeningScene& given) {
    scene::Scene scene = parsed(given);
    // So that the beam lands in the middle of the picture.
    const glm::dvec3 way = gratingOf(scene).beam.direction;
    gratingOf(scene).position = {way.x / way.z, way.y / way.z, 0};
    scene.image.width = scene.image.height = 640;
    return scene;
}

// The point of the wall that a pixel's middle shows.
glm::dvec3 shownBy(const scene::Scene& scene, std::uint32_t x, std::uint32_t y) {
    const double height = std::get<scene::Orthographic>(scene.camera.projection).height;
    const auto& plane = std::get<scene::Plane>(scene.objects.front().shape);
    const double pixel = height / scene.image.height;
    const glm::dvec3 on((x + 0.5 - 0.5 * scene.image.width) * pixel,
                        (0.5 * scene.image.height - y - 0.5) * pixel, 0.0);
    return {on.x, on.y, glm::dot(plane.point - on, plane.normal) / plane.normal.z};
}

glm::dvec3 expectedAt(const scene::Scene& scene, std::uint32_t x, std::uint32_t y) {
    const auto& plane = std::get<scene::Plane>(scene.objects.front().shape);
    return oracle::irradianceXyz(scene, 0, shownBy(scene, x, y), plane.normal, {{380.0, 0.8}, {780.0, 0.8}},
                                 100) /
           std::numbers::pi;
}

// The largest difference over a diagonal and the row in the middle, relative to the brightest pixel.
double largestError(const scene::Scene& scene, std::uint32_t step) {
    const image::Image device = renderOnDevice(scene);
    double peak = 0.0, worst = 0.0;
    for (const image::Pixel& pixel : device.pixels) peak = std::max(peak, largest(pixel));
    EXPECT_GT(peak, 0.0);
    for (std::uint32_t i = 1; i < scene.image.width; i += step) {
        for (const std::uint32_t y : {i % scene.image.height, scene.image.height / 2}) {
            const glm::dvec3 expected = expectedAt(scene, i, y);
            const image::Pixel& is = device.at(i, y);
            const double error = std::max(
                {std::abs(is.x - expected.x), std::abs(is.y - expected.y), std::abs(is.z - expected.z)});
            worst = std::max(worst, error / peak);
        }
    }
    return worst;
}

class NearOpeningOnDevice : public ::testing::TestWithParam<OpeningScene> {};

// What is left is Fresnel's quadratic phase, which the oracle does not have, the mean over the finite pixel,
// and 128 or fewer wavelengths: 4e-4, and 1.2e-3 on the slanting wall.
TEST_P(NearOpeningOnDevice, IsAsTheSumOfWavesHasIt) {
    EXPECT_LE(largestError(nearScene(GetParam()), 91), 2e-3);
}

constexpr const char* kObliqueWall = "[0.3, 0.2, 1]";
INSTANTIATE_TEST_SUITE_P(
    Kinds, NearOpeningOnDevice,
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
            kWhite, 0.006, "", kObliqueWall},
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

constexpr const char* kEvenDaylight = R"("diameter": "40 mm")";
constexpr const char* kGaussianGreen =
    R"("profile": "gaussian", "diameter": "2 mm", "spectrum": { "type": "laser", "wavelength": "532 nm" })";
constexpr const char* kGaussianDaylight = R"("profile": "gaussian", "diameter": "2 mm")";

// Near fields that are looked up, from a Fresnel number of 0.3 to 30.
class NearLayersOnDevice : public ::testing::TestWithParam<OpeningScene> {};

TEST_P(NearLayersOnDevice, AreAsTheSumOfWavesHasThem) {
    scene::Scene scene = nearScene(GetParam());
    if (GetParam().beam == kEvenDaylight ||
        GetParam().beam == kGaussianDaylight) {  // a band across, for time's sake
        constexpr std::uint32_t kRows = 32;
        scene.camera.projection = scene::Orthographic{GetParam().height * kRows / scene.image.height};
        scene.image.height = kRows;
    }
    const double error = largestError(scene, 91);
    RecordProperty("error", fmt::format("{:.1e}", error));
    EXPECT_LE(error, 1e-2);
}

constexpr const char* kSmall = R"({ "type": "polygon", "sides": 6, "diameter": "0.8 mm" })";
constexpr const char* kSecond = R"({ "type": "polygon", "sides": 6, "diameter": "1.46 mm" })";
constexpr const char* kMiddle = R"({ "type": "polygon", "sides": 6, "diameter": "2.5 mm" })";
constexpr const char* kLarge = R"({ "type": "polygon", "sides": 6, "diameter": "4.6 mm" })";
constexpr const char* kLargest = R"({ "type": "polygon", "sides": 6, "diameter": "8 mm" })";
INSTANTIATE_TEST_SUITE_P(
    Kinds, NearLayersOnDevice,
    ::testing::Values(
        OpeningScene{"hexagon03InLaserLight", kSmall, kGreen, kWhite, 0.004},
        OpeningScene{"hexagon1InLaserLight", kSecond, kGreen, kWhite, 0.004},
        OpeningScene{"hexagon3InLaserLight", kMiddle, kGreen, kWhite, 0.004},
        OpeningScene{"hexagon10InLaserLight", kLarge, kGreen, kWhite, 0.006},
        OpeningScene{"hexagon30InLaserLight", kLargest, kGreen, kWhite, 0.01},
        OpeningScene{"hexagon03", kSmall, kEvenDaylight, kWhite, 0.004},
        OpeningScene{"hexagon1", kSecond, kEvenDaylight, kWhite, 0.004},
        OpeningScene{"hexagon3", kMiddle, kEvenDaylight, kWhite, 0.004},
        OpeningScene{"hexagon10", kLarge, kEvenDaylight, kWhite, 0.006},
        OpeningScene{"hexagon30", kLargest, kEvenDaylight, kWhite, 0.01},
        OpeningScene{"triangle", R"({ "type": "polygon", "sides": 3, "diameter": "2 mm" })", kGreen, kWhite,
                     0.004},
        OpeningScene{
            "oblique", kMiddle,
            R"("diameter": "40 mm", "direction": [0.3, 0, -1], "spectrum": { "type": "laser", "wavelength": "532 nm" })",
            kWhite, 0.004},
        OpeningScene{
            "behindTheFocus", R"({ "type": "polygon", "sides": 3, "diameter": "5 mm" })",
            R"("diameter": "40 mm", "focus": "0.8 m", "spectrum": { "type": "laser", "wavelength": "532 nm" })",
            kWhite, 0.003},
        OpeningScene{"cutCircle", R"({ "type": "circle", "diameter": "2 mm" })", kGaussianGreen, kWhite,
                     0.004},
        OpeningScene{"cutCircleInDaylight", R"({ "type": "circle", "diameter": "2 mm" })", kGaussianDaylight,
                     kWhite, 0.004},
        OpeningScene{"cutRectangle", R"({ "type": "rectangle", "width": "1 mm", "height": "2 mm" })",
                     kGaussianGreen, kWhite, 0.004},
        OpeningScene{"cutRing", R"({ "type": "ring", "diameter": "3 mm", "inner_diameter": "1.2 mm" })",
                     kGaussianDaylight, kWhite, 0.005},
        OpeningScene{"cutHexagon", kMiddle, kGaussianDaylight, kWhite, 0.004}),
    [](const auto& info) { return std::string(info.param.name); });

// From the far field to the near one: no step where one formula takes over from another.
TEST(NearOpeningsOnDevice, WalkThroughTheTransitionsWithoutASeam) {
    for (const char* shape : {R"({{ "type": "circle", "diameter": "{0} um" }})",
                              R"({{ "type": "ring", "diameter": "{0} um", "inner_diameter": "{1} um" }})",
                              R"({{ "type": "rectangle", "width": "{0} um", "height": "{1} um" }})"}) {
        for (const double size_um : {80.0, 115.0, 300.0}) {
            const std::string aperture = fmt::format(fmt::runtime(shape), size_um, 0.4 * size_um);
            constexpr std::uint32_t kRows = 4;
            scene::Scene scene =
                nearScene({"", aperture.c_str(), kGreen, kWhite, kRows / 640.0 * 4.0 * 0.532 / size_um});
            scene.image.height = kRows;
            EXPECT_LE(largestError(scene, 91), 1e-4) << aperture;  // as LEAST_FRESNEL_NUMBER has it
        }
    }
}

// The same where tables take over, with the bound of kLeastLayer, and where these have more points for more
// ripples.
TEST(NearFieldsOnDevice, WalkThroughTheTransitionsWithoutASeam) {
    for (const double size_um : {180.0, 250.0, 262.0, 600.0, 2900.0, 2940.0, 5000.0, 5100.0}) {
        const std::string aperture =
            fmt::format(R"({{ "type": "polygon", "sides": 6, "diameter": "{} um" }})", size_um);
        constexpr std::uint32_t kRows = 4;
        const double height = 4.0 * 0.532 / size_um + 1.5e-6 * size_um;
        scene::Scene scene = nearScene({"", aperture.c_str(), kGreen, kWhite, kRows / 640.0 * height});
        scene.image.height = kRows;
        EXPECT_LE(largestError(scene, 91), 1e-3) << aperture;
    }
}

// A screen that is nearly along the beam, from 0.5 m to 1.5 m away.
TEST(NearFieldsOnDevice, FollowALongScreen) {
    scene::Scene scene = nearScene({"", kMiddle, kGreen, kWhite, 0.004, "", "[100, 0, 0.4]"});
    const double error = largestError(scene, 91);
    RecordProperty("error", fmt::format("{:.1e}", error));
    EXPECT_LE(error, 1e-2);
}

// A band across a letter, in even light and in a Gaussian beam.
TEST(NearFieldsOnDevice, MasksAreAsTheSumOfWavesHasThem) {
    for (const char* beam : {kGreen, kEvenDaylight, kGaussianGreen}) {
        scene::Scene scene = nearScene({"", kMiddle, beam, kWhite, 0.0003});
        scene.image.height = 32;
        gratingOf(scene).aperture = letter(0.2 * units::mm);
        const double error = largestError(scene, 91);
        RecordProperty(beam == kGreen           ? "error"
                       : beam == kGaussianGreen ? "gaussian_error"
                                                : "daylight_error",
                       fmt::format("{:.1e}", error));
        EXPECT_LE(error, 1e-2) << beam;
    }
}

}  // namespace
}  // namespace fringe::testing
