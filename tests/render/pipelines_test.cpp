// What is compiled into a pipeline: features that a scene lacks, and its values, change how fast it is and
// nothing else.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

// Every feature that does not itself change what is seen.
void generalise(device::Specialisation& constants) {
    constants.HAS_DIFFUSE = constants.HAS_CONDUCTORS = constants.HAS_DIELECTRICS = constants.HAS_EMITTERS = 1;
    constants.HAS_THESIS_DISCS = constants.HAS_PRINTED_FAULTS = 1;
    constants.HAS_POINT_LIGHTS = constants.HAS_SPOT_LIGHTS = constants.HAS_DIRECTIONAL_LIGHTS = 1;
    constants.HAS_RECTANGLE_LIGHTS = constants.HAS_DISC_LIGHTS = constants.HAS_SPHERE_LIGHTS = 1;
    constants.HAS_ENVIRONMENT = 1;
    constants.MAX_DEPTH = std::max(constants.MAX_DEPTH, 4U);
}

class Pipelines : public ::testing::TestWithParam<const char*> {};

// All but a few pixels: at silhouettes a unit in the last place decides what a pixel shows.
void expectSamePicture(const image::Image& a, const image::Image& b, double tolerance) {
    constexpr double kSilhouettes = 1e-3;  // of the pixels, as against the reference renderer
    ASSERT_EQ(a.pixels.size(), b.pixels.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        EXPECT_EQ(a.pixels[i].nonFinite, b.pixels[i].nonFinite);
        if (distance(a.pixels[i], b.pixels[i]) > tolerance) ++different;
    }
    EXPECT_LE(static_cast<double>(different), kSilhouettes * static_cast<double>(a.pixels.size()));
}

scene::Scene smallScene(const char* path) {
    scene::Scene scene = sceneFile(path);
    scene.image.width = scene.image.height = 200;
    return scene;
}

// The same sums: 4e-6 is a few units in the last place of values about 1, should a compiler arrange them
// otherwise.
TEST_P(Pipelines, TheGeneralOneGivesTheSamePicture) {
    const scene::Scene scene = smallScene(GetParam());
    expectSamePicture(renderOnDevice(scene), renderOnDevice(scene, {.change = generalise}), 4e-6);
}

// What the compiler folds it rounds as the processor does, not as the driver's own square roots and quotients
// do; a pattern multiplies such differences by its phase, up to 1e-4 (reference_test.cpp derives it for the
// gratings).
TEST_P(Pipelines, ValuesInUniformsGiveTheSamePicture) {
    const scene::Scene scene = smallScene(GetParam());
    expectSamePicture(renderOnDevice(scene), renderOnDevice(scene, {.values = render::Values::inUniforms}),
                      1e-4);
}

// Response tables in an image, as on devices whose texel buffers are too small: the same words.
TEST(TexelsOnDevice, InImagesGiveTheSamePictureBitForBit) {
    const scene::Scene scene = smallScene("scenes/gratings/five-gratings.json");
    const image::Image picture = renderOnDevice(scene);
    EXPECT_TRUE(std::any_of(picture.pixels.begin(), picture.pixels.end(),
                            [](const image::Pixel& pixel) { return pixel.y > 0.0F; }));
    expectSamePicture(picture, renderOnDevice(scene, {.change = texelsInImages}), 0.0);
}

// Gratings; a printed disc; a lens, area light, sky, glass and mirrors; every shape and material.
INSTANTIATE_TEST_SUITE_P(OnDevice, Pipelines,
                         ::testing::Values("scenes/thesis/figure-24.json", "scenes/thesis/figure-25.json",
                                           "tests/cli/room.json", "tests/render/primitives.json"));

}  // namespace
}  // namespace fringe::testing
