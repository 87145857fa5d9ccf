// The scenes and sums of benchmarks, without a clock.
#include <gtest/gtest.h>

#include <algorithm>

#include "compile/compiled_scene.hpp"
#include "qualify/bench_frame.hpp"
#include "qualify/skip_features.hpp"
#include "scene/parse.hpp"

namespace fringe::qualify {
namespace {

device::Specialisation constantsOf(const SceneParts& parts) {
    const scene::Scene scene = scene::parseScene(parts.text(), "benchmark");
    return compile::specialise(compile::compileScene(scene), scene.camera);
}

// Or a comparison would compare a pipeline with itself.
TEST(SkipFeatures, EachMakesAnotherPipelineThanTheSceneWithoutIt) {
    const auto& features = skipFeatures();
    for (const SkipFeature& feature : features) {
        SceneParts without = roomScene();
        if (feature.without != kRoom) {
            const auto other = std::find_if(features.begin(), features.end(),
                                            [&](const SkipFeature& f) { return f.name == feature.without; });
            ASSERT_NE(other, features.end()) << feature.name;
            add(*other, without);
        }
        SceneParts with = without;
        add(feature, with);
        EXPECT_FALSE(constantsOf(with) == constantsOf(without)) << feature.name;
    }
}

TEST(BenchScenes, AreScenes) {
    EXPECT_EQ(constantsOf(emptyScene()).RECTANGLE_COUNT, 0U);
    EXPECT_EQ(constantsOf(fiveGratingsScene(GratingModel::thesis)).GRATING_COUNT, 5U);
    EXPECT_EQ(constantsOf(fiveGratingsScene(GratingModel::physical)).SLIT_GRATING_COUNT, 5U);
    EXPECT_EQ(constantsOf(manyGratingsScene(7, true)).SLIT_GRATING_COUNT, 7U);
    EXPECT_EQ(constantsOf(spheresScene(10)).SPHERE_COUNT, 10U);
    EXPECT_EQ(constantsOf(softScene()).HAS_LENS, 1U);
}

TEST(Spreads, AreTheMedianAndHalfTheDistanceOfTheQuartiles) {
    EXPECT_EQ(spreadOf({3.0}).median, 3.0);
    EXPECT_EQ(spreadOf({3.0}).half, 0.0);
    const Spread spread = spreadOf({9.0, 1.0, 3.0, 5.0, 7.0});
    EXPECT_EQ(spread.median, 5.0);
    EXPECT_EQ(spread.half, 2.0);
    EXPECT_EQ(spreadOf({1.0, 2.0}).median, 1.5);
}

TEST(PictureErrors, AreRelativeToTheReferencesPeak) {
    image::Image reference{2, 2, {4, {1.9F, 2.0F, 2.2F}}};
    image::Image picture = reference;
    EXPECT_EQ(pictureError(picture, reference).largest, 0.0);
    EXPECT_EQ(pictureError(picture, reference).deltaE, 0.0);
    picture.pixels[3].y = 1.0F;
    const PictureError error = pictureError(picture, reference);
    EXPECT_EQ(error.largest, 0.5);
    EXPECT_EQ(error.rms, 0.25);
    EXPECT_EQ(error.wrong, 0.25);
    EXPECT_GT(error.deltaE, 1.0);
}

}  // namespace
}  // namespace fringe::qualify
