// What is compiled into a pipeline: features that a scene lacks, and its values, change how fast it is and
// nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "compile/compiled_scene.hpp"
#include "gpu/constant_block.hpp"
#include "render/rendering.hpp"
#include "shaders/render.comp.h"

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

// Rounding alone may differ, where compilers arrange the same sums otherwise: a few units in the last place
// of values about 1, except at silhouettes, where one such unit decides what a pixel shows.
TEST_P(Pipelines, TheGeneralOneGivesTheSamePicture) {
    constexpr double kRounding = 4e-6;
    constexpr double kSilhouettes = 1e-3;  // of the pixels, as against the reference renderer
    scene::Scene scene = sceneFile(GetParam());
    scene.image.width = scene.image.height = 200;
    const image::Image special = renderOnDevice(scene);
    const image::Image general = renderOnDevice(scene, generalise);
    std::size_t different = 0;
    for (std::size_t i = 0; i < special.pixels.size(); ++i) {
        EXPECT_EQ(special.pixels[i].nonFinite, general.pixels[i].nonFinite);
        if (distance(special.pixels[i], general.pixels[i]) > kRounding) ++different;
    }
    EXPECT_LE(static_cast<double>(different), kSilhouettes * static_cast<double>(special.pixels.size()));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Pipelines,
                         ::testing::Values("scenes/thesis/figure-24.json", "scenes/thesis/figure-25.json"));

// ---- the block as constants ---------------------------------------------------------------------

// The first words of instructions and what follows them, after the module's header of five words.
template <class Visit>
void forEachInstruction(const std::vector<std::uint32_t>& module, Visit visit) {
    for (std::size_t at = 5; at < module.size(); at += module[at] >> 16) visit(&module[at]);
}

constexpr std::uint32_t kOpConstant = 43, kOpVariable = 59, kUniform = 2;

std::vector<std::uint32_t> withBlock(const device::SceneBlock& block) {
    return gpu::withConstantBlock(render_comp, std::as_bytes(std::span(&block, 1)));
}

bool hasConstant(const std::vector<std::uint32_t>& module, float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    bool found = false;
    forEachInstruction(module, [&](const std::uint32_t* words) {
        if ((words[0] & 0xffffU) == kOpConstant && words[0] >> 16 == 4) found = found || words[3] == bits;
    });
    return found;
}

TEST(ConstantBlock, LeavesNoUniformVariable) {
    forEachInstruction(withBlock({}), [](const std::uint32_t* words) {
        if ((words[0] & 0xffffU) == kOpVariable) {
            EXPECT_NE(words[3], kUniform);
        }
    });
}

TEST(ConstantBlock, HoldsTheValuesOfTheBlock) {
    device::SceneBlock block{};
    block.spheres[2].radius = 0.12345F;
    block.frame.camera.up.z = -7.625F;
    const std::vector<std::uint32_t> module = withBlock(block);
    EXPECT_TRUE(hasConstant(module, 0.12345F));
    EXPECT_TRUE(hasConstant(module, -7.625F));
    EXPECT_FALSE(hasConstant(withBlock({}), 0.12345F));
}

TEST(ConstantBlock, EndsArraysWithTheirLastElementInUse) {
    device::SceneBlock few{}, many{};
    few.spheres[0].radius = 1.0F;
    for (device::Sphere& sphere : many.spheres) sphere.radius = 1.0F;
    EXPECT_LT(withBlock(few).size() + device::FEW, withBlock(many).size());
}

}  // namespace
}  // namespace fringe::testing
