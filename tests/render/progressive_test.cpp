// Progressive: the same pictures as Renderer, whatever was shown before, and no pipeline without need.
#include "render/progressive.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/rendering.hpp"
#include "wanted_device.hpp"

namespace fringe::testing {
namespace {

class ProgressiveOnDevice : public ::testing::Test {
protected:
    void TearDown() override {
        for (const std::string& message : device_.validationMessages()) ADD_FAILURE() << message;
    }

    void show(const scene::Scene& scene) {
        const compile::CompiledScene compiled =
            compile::compileScene(scene, compile::Measure::color, nullptr, compile::Viewpoint::moving);
        progressive_.show(compiled, compile::specialise(compiled, scene.camera));
    }

    std::vector<image::Pixel> take(std::uint32_t samples) {
        while (progressive_.samples() < samples) progressive_.advance(samples);
        std::vector<image::Pixel> pixels;
        progressive_.read(pixels);
        return pixels;
    }

    gpu::Device device_{{.selector = wantedDevice(), .validation = true}};
    render::Progressive progressive_{device_};
};

scene::Scene sceneOf(const std::string& path, std::uint32_t samples) {
    scene::Scene scene = sceneFile(path);
    scene.image.width = 101;
    scene.image.height = 90;
    scene.image.samples = samples;
    return scene;
}

void expectSameBits(const std::vector<image::Pixel>& pixels, const scene::Scene& scene) {
    const image::Image expected = renderOnDevice(scene, {.values = render::Values::inUniforms});
    ASSERT_EQ(pixels.size(), expected.pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) ASSERT_EQ(distance(pixels[i], expected.pixels[i]), 0.0);
}

TEST_F(ProgressiveOnDevice, EndsWithTheBitsOfARender) {
    const scene::Scene scene = sceneOf("scenes/thesis/figure-24.json", 5);
    show(scene);
    EXPECT_EQ(progressive_.samples(), 0U);
    expectSameBits(take(5), scene);
}

TEST_F(ProgressiveOnDevice, ChangedValuesNeedNoPipeline) {
    scene::Scene scene = sceneOf("scenes/thesis/figure-24.json", 2);
    show(scene);
    take(1);
    auto& grating = std::get<scene::ThesisGrating>(scene.lights[3].model);
    grating.slits.period = 1.5 * grating.slits.period;
    scene.camera.position.x += 0.2;
    show(scene);
    expectSameBits(take(2), scene);
    EXPECT_EQ(progressive_.compilations(), 1U);
}

TEST_F(ProgressiveOnDevice, AnotherStructureNeedsOneAndTheFirstIsKept) {
    const scene::Scene first = sceneOf("scenes/thesis/figure-24.json", 2);
    const scene::Scene second = sceneOf("scenes/gratings/few-slits.json", 2);
    show(first);
    take(1);
    show(second);
    expectSameBits(take(2), second);
    show(first);
    expectSameBits(take(2), first);
    EXPECT_EQ(progressive_.compilations(), 2U);
}

TEST_F(ProgressiveOnDevice, LooksOtherwiseAtTheSameScene) {
    scene::Scene scene = sceneOf("scenes/thesis/figure-24.json", 2);
    const compile::CompiledScene compiled = compile::compileScene(scene);
    show(scene);
    take(1);
    scene.image.width = 34;  // a coarse picture, from elsewhere
    scene.image.height = 30;
    scene.camera.position.y += 0.1;
    device::Frame frame = compiled.frame;
    compile::setView(scene.camera, scene.image, frame);
    progressive_.look(frame);
    expectSameBits(take(2), scene);
}

// From afar a pixel hides the ripple of a beam's edge, and a render needs no tables for it.
TEST_F(ProgressiveOnDevice, ComesCloseToAnEdge) {
    scene::Scene scene = sceneOf("scenes/gratings/five-gratings.json", 2);
    ASSERT_FALSE(compile::compileScene(scene).bandResponses);
    const compile::CompiledScene compiled =
        compile::compileScene(scene, compile::Measure::color, nullptr, compile::Viewpoint::moving);
    show(scene);
    take(1);
    scene.camera.target = {0.35, 0.09, -1.0};  // an upper edge on the wall
    scene.camera.position = {0.35, 0.09, -0.95};
    ASSERT_TRUE(compile::compileScene(scene).bandResponses);
    device::Frame frame = compiled.frame;
    compile::setView(scene.camera, scene.image, frame);
    progressive_.look(frame);
    expectSameBits(take(2), scene);
}

}  // namespace
}  // namespace fringe::testing
