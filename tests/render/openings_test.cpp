// Openings in two dimensions on the device against the reference renderer, which adds up waves from their
// area at every wavelength.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "oracle/grating.hpp"
#include "oracle/reference.hpp"
#include "render/opening_scenes.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

class Openings : public ::testing::TestWithParam<OpeningScene> {};

// The largest difference from the reference, relative to the picture's peak, over rows through the pattern's
// middle, next to it, and far from it.
double deviation(const scene::Scene& scene) {
    const image::Image device = renderOnDevice(scene);
    double peak = 0.0;
    for (const image::Pixel& pixel : device.pixels) peak = std::max(peak, largest(pixel));
    EXPECT_GT(peak, 0.0);

    const oracle::Reference reference(scene);
    const std::atomic<bool> never{false};
    double worst = 0.0, brightest = 0.0;
    for (const std::uint32_t row : {3U, 91U, 140U, 149U, 150U, 201U}) {
        std::vector<image::Pixel> expected(scene.image.width);
        EXPECT_TRUE(reference.render(row, 1, expected, 2, never));
        for (std::uint32_t x = 0; x < scene.image.width; ++x) {
            worst = std::max(worst, distance(device.at(x, row), expected[x]));
            brightest = std::max(brightest, largest(expected[x]));
        }
    }
    EXPECT_GT(brightest, 0.05 * peak) << "the rows miss the pattern";
    ::testing::Test::RecordProperty("error", fmt::format("{:.1e}", worst / peak));
    return worst / peak;
}

// Sixteen wavelengths leave 1e-4, and the reference's own share of what propagates is good to 1e-3 where an
// opening is wide. The phase across 60 um carries the 1.2e-7 of a float32 direction cosine as 2e-5 of a turn.
TEST_P(Openings, OnDeviceAreAsTheReferenceHasThem) {
    EXPECT_LE(deviation(parsed(GetParam())), 1e-3);
}

constexpr const char* kRed = R"({ "type": "diffuse", "reflectance": [0.7, 0.05, 0.04] })";
constexpr const char* kLaser =
    R"("diameter": "200 um", "spectrum": { "type": "laser", "wavelength": "532 nm" })";

constexpr const char* kNarrow =
    R"("profile": "gaussian", "diameter": "26 um", "spectrum": { "type": "laser", "wavelength": "532 nm" })";

INSTANTIATE_TEST_SUITE_P(
    Kinds, Openings,
    ::testing::Values(
        OpeningScene{"rectangle", R"({ "type": "rectangle", "width": "12 um", "height": "24 um" })"},
        OpeningScene{"wideRectangle", R"({ "type": "rectangle", "width": "80 um", "height": "30 um" })"},
        OpeningScene{"circle", R"({ "type": "circle", "diameter": "20 um" })"},
        OpeningScene{"obliqueCircle", R"({ "type": "circle", "diameter": "12 um" })",
                     R"("diameter": "200 um", "direction": [0.1, 0.01, -1])", kRed, 0.8, "", "[0.5, 0.3, 1]"},
        OpeningScene{"ringInLaserLight",
                     R"({ "type": "ring", "diameter": "20 um", "inner_diameter": "14 um" })", kLaser},
        OpeningScene{"hexagon", kHexagon},
        OpeningScene{"hexagonOnRed", kHexagon, R"("diameter": "200 um")", kRed},
        OpeningScene{"hexagonInReflection", kHexagon,
                     R"("diameter": "200 um", "spectrum": "sodium", "direction": [0.1, 0, 1])",
                     R"({ "type": "diffuse", "reflectance": 0.8 })", 0.6,
                     R"(, "side": "reflection", "efficiency": 0.25)"},
        OpeningScene{"hexagonInAGaussianBeam", kHexagon, R"("profile": "gaussian", "diameter": "30 um")"},
        OpeningScene{"rectangleInANarrowGaussianBeam",
                     R"({ "type": "rectangle", "width": "60 um", "height": "20 um" })",
                     R"("profile": "gaussian", "diameter": "25 um", "direction": [0.1, 0.01, -1])"},
        OpeningScene{"ringInAGaussianBeam",
                     R"({ "type": "ring", "diameter": "20 um", "inner_diameter": "8 um" })",
                     R"("profile": "gaussian", "diameter": "24 um")", kRed},
        OpeningScene{
            "ell", R"({ "type": "polygon", "vertices": [["0 um", "0 um"], ["8 um", "0 um"], ["8 um", "2 um"],
             ["2 um", "2 um"], ["2 um", "8 um"], ["0 um", "8 um"]] })"},
        OpeningScene{"lattice", R"({ "type": "lattice", "cell": { "type": "circle", "diameter": "4 um" },
             "first": ["8 um", "0 um"], "second": ["3 um", "7 um"], "first_count": 5, "second_count": 4 })"},
        OpeningScene{"latticeInLaserLight",
                     R"({ "type": "lattice", "cell": { "type": "rectangle", "width": "0.8 um",
             "height": "1 um" }, "first": ["1.5 um", "0 um"], "second": ["0.2 um", "1.6 um"], "first_count": 3,
             "second_count": 3 })",
                     kLaser, kWhite, 1.5},
        OpeningScene{"latticeWiderThanAGaussianBeam",
                     R"({ "type": "lattice", "cell": { "type": "rectangle", "width": "2 um",
             "height": "1 um" }, "first": ["6 um", "0 um"], "second": ["1 um", "5 um"], "first_count": 20,
             "second_count": 21 })",
                     kNarrow, kWhite, 0.4}),
    [](const auto& info) { return std::string(info.param.name); });

scene::Scene sceneOf(const char* aperture, const char* beam = OpeningScene{}.beam) {
    return parsed({"", aperture, beam});
}

// Spots that the wave's curvature widens by a third and more, and cells' patterns that go with them: as many
// columns of the picture as hold an order or two.
TEST(OpeningsOnDevice, NearAGaussianBeamThatPassesWholeAreAsTheReferenceHasThem) {
    for (const auto& [aperture, diameter] :
         {std::pair{R"({ "type": "lattice", "cell": { "type": "rectangle", "width": "60 um",
             "height": "30 um" }, "first": ["150 um", "0 um"], "second": ["30 um", "150 um"], "first_count": 21,
             "second_count": 20 })",
                    "0.7 mm"},
          {R"({ "type": "polygon", "sides": 5, "diameter": "5.6 mm" })", "1.2 mm"}}) {
        const std::string beam = fmt::format(R"("profile": "gaussian", "diameter": "{}",
            "spectrum": {{ "type": "laser", "wavelength": "532 nm" }})",
                                             diameter);
        scene::Scene scene = parsed({"", aperture, beam.c_str(), kWhite, 0.02});
        gratingOf(scene).position = {0.0, 0.0005, 0.0};
        scene.image.width = 30;
        EXPECT_LE(deviation(scene), 2e-3) << aperture;
    }
}

// Cells' patterns go with the orders to the first order in a cell's size over the beam's: of the second, the
// square of 1 um over 13 um, 6e-3, a third remains.
TEST(OpeningsOnDevice, LatticeThatCutsAGaussianBeamIsNearlyAsTheReferenceHasIt) {
    EXPECT_LE(deviation(parsed({"", R"({ "type": "lattice", "cell": { "type": "circle", "diameter": "2 um" },
             "first": ["6 um", "0 um"], "second": ["2 um", "7 um"], "first_count": 9, "second_count": 8 })",
                                kNarrow, kWhite, 0.4, R"(, "efficiency": 0.5)"})),
              2.5e-3);
}

// The wall in a mirror of gold, whose colour belongs into the sum over wavelengths.
TEST(OpeningsOnDevice, SeenInAMirrorOfGoldAreAsTheReferenceHasThem) {
    scene::Scene scene = sceneOf(kHexagon);
    scene.materials.push_back({"gold", scene::Conductor{scene::Metal::gold}});
    scene.objects.push_back({"", scene::Plane{{0, 0, 1}, {0, 0, -1}}, 1});
    scene.camera.position = {0, 0, 0.25};
    scene.camera.target = {0, 0, 1};
    EXPECT_LE(deviation(scene), 1e-3);
}

// How one sample in the middle of each pixel does where fringes are finer than that.
struct FineFringes {
    double total;      // one sample's, over that of 1,024
    double deviation;  // root of the mean square, relative to the brightest pixel next to each
};

FineFringes fineFringes(scene::Scene scene) {
    constexpr std::uint32_t kSide = 21;
    scene.image.width = scene.image.height = kSide;
    const image::Image one = renderOnDevice(scene);
    scene.image.samples = 1024;
    const image::Image many = renderOnDevice(scene);
    double sumOne = 0.0, sumMany = 0.0, square = 0.0;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            sumOne += double{one.at(x, y).y};
            sumMany += double{many.at(x, y).y};
            float brightest = 0.0F;
            for (std::uint32_t j = std::max(y, 1U) - 1; j <= std::min(y + 1, kSide - 1); ++j)
                for (std::uint32_t i = std::max(x, 1U) - 1; i <= std::min(x + 1, kSide - 1); ++i)
                    brightest = std::max(brightest, many.at(i, j).y);
            square += std::pow((one.at(x, y).y - many.at(x, y).y) / double{brightest}, 2);
        }
    }
    return {sumOne / sumMany, std::sqrt(square / (kSide * kSide))};
}

// The letter of opening_scenes.hpp in finer pixels, for which alone the claim is made: what a camera's pixel
// sees is a small part of what a mask's pixel spreads over.
optics::MaskAperture fineLetter(units::Length size) {
    const optics::MaskAperture coarse = letter(size / 16.0);
    optics::MaskAperture fine{8 * coarse.columns, 8 * coarse.rows, size / 128.0, {}};
    for (std::uint32_t y = 0; y < fine.rows; ++y)
        for (std::uint32_t x = 0; x < fine.columns; ++x)
            fine.transmission.push_back(coarse.transmission[(y / 8) * coarse.columns + x / 8]);
    return fine;
}

// 1,024 samples have a noise of 1 %. What of the rest shows is that fringes about as wide as a pixel fade
// before their mean is exact, between the rims of the ring most (6 % of its total, which falls to nothing
// where pixels are twice as wide), and that a mask's pixels are soft: they hand a spoke that is narrower than
// they are in part to their neighbours. The table of the
// circle in a Gaussian beam errs by 1e-5 of the brightest pixel, next to the axes; pixels twice as wide have
// but as much there.
TEST(OpeningsOnDevice, FringesFinerThanAPixelGiveTheirMean) {
    std::vector<scene::Scene> scenes;
    for (const char* aperture : {R"({ "type": "rectangle", "width": "100 um", "height": "100 um" })",
                                 R"({ "type": "circle", "diameter": "100 um" })",
                                 R"({ "type": "ring", "diameter": "100 um", "inner_diameter": "60 um" })",
                                 R"({ "type": "polygon", "sides": 6, "diameter": "100 um" })",
                                 R"({ "type": "polygon", "sides": 5, "diameter": "100 um" })"})
        scenes.push_back(sceneOf(aperture, kLaser));
    scenes.push_back(sceneOf(R"({ "type": "circle", "diameter": "100 um" })",
                             R"("profile": "gaussian", "diameter": "200 um",
                                "spectrum": { "type": "laser", "wavelength": "532 nm" })"));
    scenes.push_back(sceneOf(kCircle, kLaser));
    gratingOf(scenes.back()).aperture = fineLetter(150.0 * units::um);
    for (const double height : {0.3, 0.6}) {
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            if (i == 5 && height > 0.3) continue;  // see above
            gratingOf(scenes[i]).position = {0.3 * height / 21, 0.2 * height / 21, 0.0};
            std::get<scene::Orthographic>(scenes[i].camera.projection).height = height;
            const auto [total, deviation] = fineFringes(scenes[i]);
            EXPECT_NEAR(total, 1.0, i == 2 ? 0.08 : 0.05) << "opening " << i << ", " << height;
            EXPECT_LE(deviation, 0.15) << "opening " << i << ", " << height;
        }
    }
}

// Pixels of a quarter of the finest fringe, whose mean the splines' bends are for. Without them the peak
// is 1.5e-2 too high.
TEST(OpeningsOnDevice, LatticeThatCutsAGaussianBeamGivesItsMeanOverPixels) {
    scene::Scene scene = sceneOf(R"({ "type": "lattice", "cell": { "type": "circle", "diameter": "4 um" },
        "first": ["10 um", "0 um"], "second": ["5 um", "8.66 um"], "first_count": 12, "second_count": 12 })",
                                 R"("profile": "gaussian", "diameter": "150 um",
                                    "spectrum": { "type": "laser", "wavelength": "532 nm" })");
    scene.image.width = scene.image.height = 24;
    std::get<scene::Orthographic>(scene.camera.projection).height = 0.02;
    const image::Image one = renderOnDevice(scene);
    scene.image.samples = 256;
    const image::Image many = renderOnDevice(scene);
    double peak = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < many.pixels.size(); ++i) {
        peak = std::max(peak, largest(many.pixels[i]));
        worst = std::max(worst, distance(one.pixels[i], many.pixels[i]));
    }
    EXPECT_LE(worst, 3e-3 * peak);
}

TEST(OpeningsOnDevice, MaskIsAsTheReferenceHasIt) {
    scene::Scene scene = sceneOf(kCircle);
    gratingOf(scene).aperture = letter(1.5 * units::um);
    EXPECT_LE(deviation(scene), 1e-3);
}

// Half of the light falls within 6 um of the middle; at the letter's corners a hundredth is left.
TEST(OpeningsOnDevice, MaskInANarrowGaussianBeamIsAsTheReferenceHasIt) {
    scene::Scene scene = sceneOf(kCircle, R"("profile": "gaussian", "diameter": "20 um")");
    gratingOf(scene).aperture = letter(1.5 * units::um);
    EXPECT_LE(deviation(scene), 1e-3);
}

// The mean over the source's square of the pattern that each of its points makes, by the midpoint rule: 24
// points for a fringe leave (pi / 24)^2 / 24 of it along either side.
TEST(OpeningsOnDevice, SourceOfSomeSizeBlursThePattern) {
    constexpr int kPoints = 24;
    scene::Scene scene = sceneOf(R"({ "type": "circle", "diameter": "40 um" })",
                                 R"("diameter": "200 um", "angular_size": "0.5 deg")");
    const image::Image device = renderOnDevice(scene);
    double peak = 0.0;
    for (const image::Pixel& pixel : device.pixels) peak = std::max(peak, largest(pixel));
    const double size = gratingOf(scene).beam.angularSize / units::rad;
    gratingOf(scene).beam.angularSize = {};
    const glm::dvec3 along = gratingOf(scene).slitDirection;
    const glm::dvec3 across = glm::cross(along, gratingOf(scene).normal);
    for (const std::uint32_t x : {160U, 175U, 190U}) {
        constexpr std::uint32_t kRow = 145;
        const glm::dvec3 position(((x + 0.5) / 300 - 0.5) * 0.3, (0.5 - (kRow + 0.5) / 300) * 0.3, -1.0);
        oracle::Xyz sum(0.0);
        for (int i = 0; i < kPoints; ++i) {
            for (int j = 0; j < kPoints; ++j) {
                const double alpha = size * ((i + 0.5) / kPoints - 0.5);
                const double beta = size * ((j + 0.5) / kPoints - 0.5);
                const double gamma = std::sqrt(1.0 - alpha * alpha - beta * beta);
                gratingOf(scene).beam.direction =
                    alpha * across + beta * along + gamma * gratingOf(scene).normal;
                sum += oracle::irradianceXyz(scene, 0, position, {0, 0, 1}, {{380.0, 0.8}, {780.0, 0.8}});
            }
        }
        const glm::dvec3 expected = sum / (kPoints * kPoints * std::numbers::pi);
        const image::Pixel& is = device.at(x, kRow);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR((c == 0 ? is.x : c == 1 ? is.y : is.z) / peak, expected[c] / peak, 1e-3) << x;
        }
    }
}

void expectSame(const image::Image& a, const image::Image& b) {
    double peak = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        peak = std::max(peak, largest(a.pixels[i]));
        worst = std::max(worst, distance(a.pixels[i], b.pixels[i]));
    }
    EXPECT_LE(worst, 1e-5 * peak);  // roundings of sums in another order
}

// One of each kind, in one scene and alone: other kinds' code must not touch them, nor must the spectrum's
// place in memory matter.
TEST(OpeningsOnDevice, OfAllKindsAddUp) {
    const std::array apertures{kHexagon,
                               R"({ "type": "rectangle", "width": "12 um", "height": "24 um" })",
                               R"({ "type": "circle", "diameter": "20 um" })",
                               R"({ "type": "ring", "diameter": "20 um", "inner_diameter": "14 um" })",
                               R"({ "type": "polygon", "sides": 5, "diameter": "20 um" })",
                               R"({ "type": "polygon", "sides": 31, "diameter": "20 um" })",
                               R"({ "type": "lattice", "cell": { "type": "circle", "diameter": "4 um" },
             "first": ["8 um", "0 um"], "second": ["3 um", "7 um"], "first_count": 3, "second_count": 2 })"};
    scene::Scene all = sceneOf(kCircle);
    all.lights.clear();
    image::Image sum;
    const auto add = [&](const scene::Scene& one) {
        const image::Image picture = renderOnDevice(one);
        if (sum.pixels.empty()) sum = image::Image{picture.width, picture.height, {}};
        sum.pixels.resize(picture.pixels.size());
        for (std::size_t i = 0; i < sum.pixels.size(); ++i) {
            sum.pixels[i].x += picture.pixels[i].x;
            sum.pixels[i].y += picture.pixels[i].y;
            sum.pixels[i].z += picture.pixels[i].z;
        }
        all.lights.push_back(one.lights.front());
    };
    for (const char* aperture : apertures) add(sceneOf(aperture));
    scene::Scene mask = sceneOf(kCircle);
    gratingOf(mask).aperture = letter(1.5 * units::um);
    add(mask);
    expectSame(renderOnDevice(all), sum);
}

// More than the uniform block takes.
TEST(OpeningsOnDevice, InGreatNumberAddUp) {
    scene::Scene scene = sceneOf(kHexagon);
    const image::Image one = renderOnDevice(scene);
    gratingOf(scene).beam.power = 1.0 / 40.0 * units::W;
    for (int i = 1; i < 40; ++i) scene.lights.push_back(scene.lights.front());
    expectSame(one, renderOnDevice(scene));
}

TEST(OpeningsOnDevice, AreTheSameWithTheirValuesInUniforms) {
    const scene::Scene scene = sceneOf(kHexagon);
    expectSame(renderOnDevice(scene), renderOnDevice(scene, {.values = render::Values::inUniforms}));
}

}  // namespace
}  // namespace fringe::testing
