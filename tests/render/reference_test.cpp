// The device against the reference renderer, which is other code in double precision.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

// How much the reference varies between a pixel and its neighbours: an edge, or a steep part of the pattern.
double localRange(const image::Image& picture, std::uint32_t x, std::uint32_t y) {
    double range = 0.0;
    for (std::uint32_t j = y > 0 ? y - 1 : 0; j <= std::min(y + 1, picture.height - 1); ++j) {
        for (std::uint32_t i = x > 0 ? x - 1 : 0; i <= std::min(x + 1, picture.width - 1); ++i) {
            range = std::max(range, distance(picture.at(i, j), picture.at(x, y)));
        }
    }
    return range;
}

struct Deviation {
    double beyond = 0.0;       // share of the pixels beyond the tolerance
    double unexplained = 0.0;  // largest difference beyond the tolerance and beyond the local range
    double worstOverSlope =
        0.0;  // 99.9 % of the differences are below this share of the local range, plus the floor
};

Deviation deviation(const scene::Scene& scene, double tolerance, double floor) {
    const image::Image device = renderOnDevice(scene);
    const image::Image reference = renderReference(scene);
    Deviation result;
    std::vector<double> overSlope;
    std::size_t beyond = 0;
    for (std::uint32_t y = 0; y < reference.height; ++y) {
        for (std::uint32_t x = 0; x < reference.width; ++x) {
            const double difference = distance(device.at(x, y), reference.at(x, y));
            const double range = localRange(reference, x, y);
            if (difference > tolerance) ++beyond;
            // On a silhouette the device shows what a neighbour shows: no more off than the neighbours are.
            if (difference > tolerance && difference > 1.01 * range) {
                result.unexplained = std::max(result.unexplained, difference);
            }
            overSlope.push_back(std::max(0.0, difference - floor) / std::max(range, 1e-9));
        }
    }
    result.beyond = static_cast<double>(beyond) / static_cast<double>(reference.pixels.size());
    const auto most =
        overSlope.begin() + static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(overSlope.size()));
    std::nth_element(overSlope.begin(), most, overSlope.end());
    result.worstOverSlope = *most;
    return result;
}

class GratingFigure : public ::testing::TestWithParam<const char*> {};

// 1e-4 of full scale: the phase of the 5-slit pattern reaches 5 x 4.4 turns, its steepest unclamped slope is
// 24 per radian of b sin(theta)/lambda, and sin(theta) carries the 2e-7 of a float32 position over its
// distance.
TEST_P(GratingFigure, AgreesWithTheReference) {
    const scene::Scene scene = sceneFile(std::string("scenes/thesis/") + GetParam());
    const Deviation d = deviation(scene, 1e-4, 0.0);
    EXPECT_LE(d.beyond, 1e-3);
    EXPECT_EQ(d.unexplained, 0.0) << "a pixel beyond the tolerance that is on no edge";
}

INSTANTIATE_TEST_SUITE_P(OnDevice, GratingFigure,
                         ::testing::Values("figure-15.json", "figure-16.json", "figure-17.json",
                                           "figure-18.json", "figure-20.json", "figure-21.json",
                                           "figure-22.json", "figure-23.json", "figure-24.json"));

class DiscFigure : public ::testing::TestWithParam<const char*> {};

// 2e-3 of full scale, and the difference is the pattern's slope times the error of the place: a float32 ray
// hits the disc within 2.4e-7 x 0.25 m (its length), 2.4e-4 of a pixel of 0.25 mm; a local range is at least
// the change over one pixel except at an extremum, where a tenth of it covers the curvature.
TEST_P(DiscFigure, DiffersByNoMoreThanSlopeTimesPositionError) {
    const scene::Scene scene = sceneFile(std::string("scenes/thesis/") + GetParam());
    const Deviation d = deviation(scene, 2e-3, 2e-5);
    EXPECT_LE(d.beyond, 1e-3);
    EXPECT_EQ(d.unexplained, 0.0) << "a pixel beyond the tolerance that is neither edge nor steep";
    EXPECT_LE(d.worstOverSlope, 2.4e-3);
}

INSTANTIATE_TEST_SUITE_P(OnDevice, DiscFigure,
                         ::testing::Values("figure-25.json", "figure-25-stated-pitch.json", "figure-26.json",
                                           "figure-26-stated-pitch.json", "figure-27.json",
                                           "figure-27-stated-pitch.json"));

// Every primitive and every material under lights without extent. What is seen through glass and in curved
// metal has edges of its own, and the branch that falls below 1/4096 may be another one: hence 1 % and 1e-3.
TEST(OnDevice, EveryPrimitiveAndMaterialAgreesWithTheReference) {
    const Deviation d = deviation(sceneFile("tests/render/primitives.json"), 1e-3, 0.0);
    EXPECT_LE(d.beyond, 1e-2);
}

// More than FEW of a kind go through storage buffers and loops instead of the uniform block.
TEST(OnDevice, ManyOfAKindAgreeWithTheReference) {
    scene::Scene scene = sceneFile("scenes/thesis/figure-24.json");
    scene.image.width = scene.image.height = 200;
    const scene::Light model = scene.lights.back();
    for (int i = 0; i < 40; ++i) {
        const double x = -0.9 + 0.045 * i;
        scene.objects.push_back({"", scene::Sphere{{x, -0.9, -0.5 + 0.02 * i}, 0.03}, 0});
        scene.objects.push_back({"", scene::Rectangle{{x, 0.8, -0.9}, {0.01, 0, 0}, {0, 0.05, 0}}, 0});
        scene::Light grating = model;
        std::get<scene::ThesisGrating>(grating.model).position = {x, -0.3 + 0.01 * i, 0.5};
        std::get<scene::ThesisGrating>(grating.model).power = 0.05 * units::W;
        scene.lights.push_back(grating);
        scene.lights.push_back(
            {"", {1, 1, 1}, model.spectrum, scene::PointLight{{x, 0.5, 0.5}, 0.1 * units::W}});
    }
    const Deviation d = deviation(scene, 1e-3, 0.0);
    EXPECT_LE(d.beyond, 2e-3);  // silhouettes of 80 small shapes and their shadows in 200 x 200 pixels
}

}  // namespace
}  // namespace fringe::testing
