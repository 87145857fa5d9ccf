// Where the Fresnel ripple of a beam's edges is left out.
#include "compile/ripples.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

// Samples of 2.7 mm and more on walls, whose ripples at 2.7 m are 1.5 mm wide.
scene::Scene fiveGratings() {
    scene::Scene scene = sceneFile("scenes/gratings/five-gratings.json");
    scene.image.width = scene.image.height = 560;
    scene.image.samples = 1;
    return scene;
}

bool ripplesShow(const scene::Scene& scene) {
    const compile::CompiledScene compiled = compile::compileScene(scene);
    return compile::specialise(compiled, scene.camera).HAS_RIPPLES != 0;
}

scene::Grating& firstGrating(scene::Scene& scene) {
    for (scene::Light& light : scene.lights) {
        if (auto* grating = std::get_if<scene::Grating>(&light.model)) return *grating;
    }
    throw std::logic_error("no grating");
}

TEST(Ripples, AverageOutOverCoarseSamples) {
    EXPECT_FALSE(ripplesShow(fiveGratings()));
}

TEST(Ripples, ShowInFineSamples) {
    scene::Scene scene = fiveGratings();
    scene.image.samples = 16;
    EXPECT_TRUE(ripplesShow(scene));
}

TEST(Ripples, ShowOnASurfaceAlongTheBeam) {
    scene::Scene scene = fiveGratings();
    firstGrating(scene).position.y =
        1.0;  // half of the beam meets the ceiling, whose points lie at one height
    EXPECT_TRUE(ripplesShow(scene));
}

TEST(Ripples, ShowOnACurvedSurface) {
    scene::Scene scene = fiveGratings();
    scene.objects.push_back({"", scene::Sphere{{0, 0.68, -0.5}, 0.1}, 0});
    EXPECT_TRUE(ripplesShow(scene));
    // Behind the grating, and between two beams, it changes nothing.
    std::get<scene::Sphere>(scene.objects.back().shape).center.z = 0.8;
    EXPECT_FALSE(ripplesShow(scene));
    std::get<scene::Sphere>(scene.objects.back().shape) = {{0, 0.5, -0.5}, 0.02};
    EXPECT_FALSE(ripplesShow(scene));
}

TEST(Ripples, AverageOutUnderAWideSource) {
    scene::Scene scene = fiveGratings();
    scene.image.samples = 16;
    scene.objects.erase(scene.objects.begin() + 1, scene.objects.end());  // the back wall, 1.25 m away
    EXPECT_TRUE(ripplesShow(scene));
    for (scene::Light& light : scene.lights) {
        if (auto* grating = std::get_if<scene::Grating>(&light.model)) {
            grating->beam.angularSize = 0.01 * units::rad;  // 12 mm there
        }
    }
    EXPECT_FALSE(ripplesShow(scene));
}

// With and without the Fresnel integrals, everywhere: what a ripple hidden by two of its widths leaves is
// nothing (hiding() is 1 from there on), and rounding moves the rest by a few units in the last place of the
// peak.
TEST(RipplesOnDevice, AreLeftOutWithoutATrace) {
    const scene::Scene scene = fiveGratings();
    const image::Image without = renderOnDevice(scene);
    const image::Image with = renderOnDevice(
        scene, {.change = [](device::Specialisation& constants) { constants.HAS_RIPPLES = 1; }});
    double peak = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) {
        peak = std::max<double>(peak, with.pixels[i].y);
        largest = std::max(largest, distance(with.pixels[i], without.pixels[i]));
    }
    EXPECT_GT(peak, 0.0);
    EXPECT_LE(largest, 4e-6 * peak);
}

}  // namespace
}  // namespace fringe::testing
