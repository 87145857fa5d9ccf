// The power that openings let through, and the far field of some against their waves propagated without it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>
#include <sstream>

#include "optics/energy.hpp"
#include "render/opening_scenes.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

struct Point {
    glm::dvec2 place;
    double irradiance;
};

// Of angular_spectrum.csv.
std::vector<Point> propagated(const std::string& opening) {
    std::ifstream file(FRINGE_SOURCE_DIR "/tests/render/angular_spectrum.csv");
    std::vector<Point> points;
    for (std::string line; std::getline(file, line);) {
        Point point{};
        std::istringstream values(line.substr(std::min(opening.size(), line.size())));
        char comma = 0;
        if (line.rfind(opening + ",", 0) == 0 &&
            values >> comma >> point.place.x >> comma >> point.place.y >> comma >> point.irradiance)
            points.push_back(point);
    }
    return points;
}

// Against the wave itself, propagated without any far field over 20 mm by the script beside
// (angular_spectrum.py): what the opening holds back as evanescent is missing there. 1 % of the peak: the
// Fresnel number of the small openings is 0.01, and the script's obliquity is another one, 0.5 % at a sine of
// 0.1. The picture's pixels are `pixel` metres wide.
void expectAsPropagated(const optics::Aperture& aperture, const char* name, double pixel, double limit) {
    scene::Scene scene = parsed({"", kCircle, R"("profile": "rectangle", "width": "1 mm", "height": "1 mm",
        "spectrum": { "type": "laser", "wavelength": "532 nm" })"});
    gratingOf(scene).aperture = aperture;
    gratingOf(scene).position = {0, 0, 0};
    gratingOf(scene).slitDirection = {0, 1, 0};
    gratingOf(scene).beam.power = 1e-6 * units::W;  // 1 W/m^2
    scene.objects[0].shape = scene::Plane{{0, 0, -0.02}, {0, 0, 1}};
    scene.camera.position = {0, 0, -0.01};
    constexpr std::uint32_t kFiner = 5;  // so that a pixel shows its middle
    scene.image.width = scene.image.height = 33 * kFiner;
    scene.camera.projection = scene::Orthographic{33 * pixel};
    const image::Image device = renderOnDevice(scene, {.measure = compile::Measure::irradiance});
    const double share = optics::propagatingShare(aperture, 532.0 * units::nm, 0.0, 0.0);

    const std::vector<Point> points = propagated(name);
    ASSERT_EQ(points.size(), 33U * 17U);
    double peak = 0.0, worst = 0.0;
    for (const auto& [place, irradiance] : points) {
        // The aperture's x is the cross product of its y and the normal: the world's -x.
        const auto column = static_cast<std::uint32_t>(std::lround(16.0 - place.x / pixel));
        const auto row = static_cast<std::uint32_t>(std::lround(16.0 - place.y / pixel));
        peak = std::max(peak, irradiance);
        worst = std::max(
            worst,
            std::abs(double{device.at(kFiner * column + kFiner / 2, kFiner * row + kFiner / 2).y} * share -
                     irradiance));
    }
    EXPECT_LE(worst / peak, limit);
    EXPECT_GT(peak, 0.0);
}

optics::PolygonalAperture hexagonOf(double radius) {
    optics::PolygonalAperture hexagon;
    for (int i = 0; i < 6; ++i)
        hexagon.vertices.push_back(
            radius * glm::dvec2(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3)));
    return hexagon;
}

TEST(OpeningsOnDevice, HexagonIsAsItsWavePropagates) {
    expectAsPropagated(hexagonOf(10e-6), "hexagon", 64e-6, 1e-2);
}

TEST(OpeningsOnDevice, MaskIsAsItsWavePropagates) {
    expectAsPropagated(letter(1.0 * units::um), "letter", 64e-6, 1e-2);
}

// Fresnel numbers of 3.8 and 2.4.
TEST(OpeningsOnDevice, HexagonInItsNearFieldIsAsItsWavePropagates) {
    expectAsPropagated(hexagonOf(200e-6), "near_hexagon", 16e-6, 1e-2);
}

TEST(OpeningsOnDevice, MaskInItsNearFieldIsAsItsWavePropagates) {
    expectAsPropagated(letter(20.0 * units::um), "near_letter", 16e-6, 1e-2);
}

// Five walls around an opening in the floor of a box of 2 m x 2 m x 1 m get all the light that passes it.
double powerIntoBox(const scene::Scene& scene) {
    double power = 0.0;
    for (int wall = 0; wall < 5; ++wall) {
        scene::Scene one = scene;
        const glm::dvec3 out = wall == 0   ? glm::dvec3(0, 0, -1)
                               : wall == 1 ? glm::dvec3(1, 0, 0)
                               : wall == 2 ? glm::dvec3(-1, 0, 0)
                               : wall == 3 ? glm::dvec3(0, 1, 0)
                                           : glm::dvec3(0, -1, 0);
        const bool isSide = wall != 0;
        const glm::dvec3 center = isSide ? out - glm::dvec3(0, 0, 0.5) : out;
        const glm::dvec3 up = isSide ? glm::dvec3(0, 0, 0.5) : glm::dvec3(0, 1, 0);
        one.objects[0].shape = scene::Rectangle{center, glm::cross(glm::normalize(up), out), up};
        one.camera.position = center - 0.25 * out;
        one.camera.target = center;
        one.camera.up = up;
        one.camera.projection = scene::Orthographic{isSide ? 1.0 : 2.0};
        one.image.width = 300;
        one.image.height = isSide ? 150 : 300;
        const image::Image picture = renderOnDevice(one, {.measure = compile::Measure::irradiance});
        double sum = 0.0;
        for (const image::Pixel& pixel : picture.pixels) sum += pixel.y;
        power += sum * (2.0 / 300) * (2.0 / 300);
    }
    return power;
}

class OpeningsPower : public ::testing::TestWithParam<OpeningScene> {};

// 1e-3, as the project promises; fringes of 0.1 rad and more are fine enough for sums over pixels of 7 mm.
TEST_P(OpeningsPower, OnDeviceIsTheBeamsInto) {
    for (const char* spectrum : {R"("D65")", R"({ "type": "laser", "wavelength": "400 nm" })",
                                 R"({ "type": "laser", "wavelength": "700 nm" })"}) {
        const std::string beam = fmt::format(
            R"("profile": "rectangle", "width": "10 um", "height": "10 um", "spectrum": {})", spectrum);
        scene::Scene scene = parsed({"", GetParam().aperture, beam.c_str(), kWhite, 1.0, GetParam().more});
        gratingOf(scene).position = {0, 0, 0};
        const double area = GetParam().height;
        EXPECT_NEAR(powerIntoBox(scene) / (area / 100.0), 1.0, 1e-3) << spectrum;
    }
}

// All that a hexagon 1 m away lets through lies within 16 of its radii, but for what goes from its rim
// beyond, perimeter / (2 pi^2 f area) of it, by directions of a circle as large as the picture.
TEST(OpeningsOnDevice, PowerInANearFieldIsTheBeams) {
    constexpr double kRadius = 2e-3, kPicture = 32 * kRadius / 2;
    const double area = 1.5 * std::sqrt(3.0) * kRadius * kRadius;
    for (const auto& [spectrum, wavelength] :
         {std::pair(R"("D65")", 560e-9),
          std::pair(R"({ "type": "laser", "wavelength": "633 nm" })", 633e-9)}) {
        const std::string beam = fmt::format(R"("diameter": "10 mm", "spectrum": {})", spectrum);
        scene::Scene scene = parsed({"", kHexagon, beam.c_str(), kWhite, kPicture, R"(, "efficiency": 1)"});
        gratingOf(scene).aperture = hexagonOf(kRadius);
        gratingOf(scene).position = {0, 0, 0};
        const image::Image picture = renderOnDevice(scene, {.measure = compile::Measure::irradiance});
        double sum = 0.0;
        for (const image::Pixel& pixel : picture.pixels) sum += double{pixel.y};
        const double reach = kPicture / std::sqrt(std::numbers::pi) / wavelength;
        const double beyond = 6.0 * kRadius / (2.0 * std::numbers::pi * std::numbers::pi * reach * area);
        EXPECT_NEAR(sum * std::pow(kPicture / picture.width, 2), 1.0 - beyond, 1e-3) << spectrum;
    }
}

// A circle lets 1 - exp(-2) of a Gaussian beam pass whose 1/e^2 diameter it has; in D65 as above.
TEST(OpeningsOnDevice, PowerInAGaussianBeamIsTheBeamsInto) {
    for (const char* spectrum : {R"("D65")", R"({ "type": "laser", "wavelength": "400 nm" })"}) {
        const std::string beam =
            fmt::format(R"("profile": "gaussian", "diameter": "3 um", "spectrum": {})", spectrum);
        scene::Scene scene =
            parsed({"", R"({ "type": "circle", "diameter": "3 um" })", beam.c_str(), kWhite, 1.0});
        gratingOf(scene).position = {0, 0, 0};
        EXPECT_NEAR(powerIntoBox(scene) / (1.0 - std::exp(-2.0)), 1.0, 1e-3) << spectrum;
    }
}

// The last number is the open area in um^2.
INSTANTIATE_TEST_SUITE_P(
    Kinds, OpeningsPower,
    ::testing::Values(
        OpeningScene{"rectangle", R"({ "type": "rectangle", "width": "1 um", "height": "3 um" })", "", "",
                     3.0},
        OpeningScene{"circle", kCircle, "", "", std::numbers::pi},
        OpeningScene{"ring", R"({ "type": "ring", "diameter": "3 um", "inner_diameter": "1 um" })", "", "",
                     2.0 * std::numbers::pi},
        OpeningScene{"hexagon", R"({ "type": "polygon", "sides": 6, "diameter": "3 um" })", "", "",
                     1.5 * std::sqrt(3.0) * 2.25},
        OpeningScene{
            "lattice",
            R"({ "type": "lattice", "cell": { "type": "circle", "diameter": "1 um" }, "first": ["2 um", "0 um"],
             "second": ["0.5 um", "1.5 um"], "first_count": 3, "second_count": 2 })",
            "", "", 1.5 * std::numbers::pi}),
    [](const auto& info) { return std::string(info.param.name); });

// Orders narrower than pixels, and orders that are images of the lattice, together have the power of a single
// cell: its pattern is their envelope. 5 %: orders of two pixels are sampled once a pixel, in rows that are
// turned to them.
TEST(OpeningsOnDevice, LatticesOfManyCellsKeepTheirPower) {
    const auto powerOf = [](const std::string& aperture, const std::string& beam) {
        scene::Scene scene =
            parsed({"", aperture.c_str(), beam.c_str(), kWhite, 1.6, R"(, "efficiency": 1)"});
        const image::Image picture = renderOnDevice(scene, {.measure = compile::Measure::irradiance});
        double sum = 0.0;
        for (const image::Pixel& pixel : picture.pixels) sum += double{pixel.y};
        return sum * std::pow(1.6 / picture.width, 2);
    };
    const std::string laser = R"(, "spectrum": { "type": "laser", "wavelength": "532 nm" })";
    const std::string even = R"("diameter": "20 mm")" + laser;
    const double cell = powerOf(R"({ "type": "circle", "diameter": "4 um" })", even);
    EXPECT_NEAR(cell, 1.0, 0.02);  // most of it is on the wall
    constexpr const char* kOblique = R"(["5 um", "8.66 um"])";
    const auto latticeOf = [](const char* row, int count) {
        return fmt::format(R"({{ "type": "lattice", "cell": {{ "type": "circle", "diameter": "4 um" }},
                    "first": ["10 um", "0 um"], "second": {}, "first_count": {}, "second_count": {} }})",
                           row, count, count / 2);
    };
    for (const char* row : {R"(["0 um", "9 um"])", kOblique}) {
        for (const int count : {40, 300, 1000})  // narrow orders; images of 3 mm; images of 10 mm
            EXPECT_NEAR(powerOf(latticeOf(row, count), even) / cell, 1.0, 0.05) << row << ' ' << count;
    }
    // Gaussian beams: wholly on the lattice; cut along one row; cut along both.
    for (const char* diameter : {"0.1 mm", "0.6 mm", "3 mm"}) {
        const std::string beam = fmt::format(R"("profile": "gaussian", "diameter": "{}")", diameter) + laser;
        EXPECT_NEAR(powerOf(latticeOf(kOblique, 300), beam) / cell, 1.0, 0.05) << diameter;
    }
}

TEST(OpeningsOnDevice, MaskLetsItsSharePass) {
    scene::Scene scene =
        parsed({"", kCircle, R"("profile": "rectangle", "width": "10 um", "height": "10 um")"});
    gratingOf(scene).aperture = letter(0.3 * units::um);
    gratingOf(scene).position = {0, 0, 0};
    double open = 0.0;
    for (const float value : letter(1.0 * units::um).transmission) open += double{value} * value;
    EXPECT_NEAR(powerIntoBox(scene) / (0.09 * open / 100.0), 1.0, 1e-3);
}

}  // namespace
}  // namespace fringe::testing
