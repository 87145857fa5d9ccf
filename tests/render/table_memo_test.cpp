// Tables of gratings kept from scene to scene: whatever was compiled before, a scene gets the tables that it
// gets without a memo, and of those that it has in common with the scene before none is made again.
#include "compile/table_memo.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <span>

#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

using compile::TableMemo;

template <class Element>
bool sameBytes(const std::vector<Element>& a, const std::vector<Element>& b) {
    return std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b)));
}

scene::Grating& gratingOf(scene::Scene& scene, std::size_t number) {
    for (scene::Light& light : scene.lights) {
        auto* grating = std::get_if<scene::Grating>(&light.model);
        if (grating != nullptr && number-- == 0) return *grating;
    }
    throw std::logic_error("no such grating");
}

optics::Slits& slitsOf(scene::Scene& scene, std::size_t number) {
    return std::get<optics::Slits>(gratingOf(scene, number).aperture);
}

// Each changes something that the tables may depend on.
std::vector<std::function<void(scene::Scene&)>> changes() {
    using Scene = scene::Scene;
    return {[](Scene& scene) { slitsOf(scene, 0).count = 2; },
            [](Scene& scene) { slitsOf(scene, 1).period = 2.5 * units::um; },
            [](Scene& scene) { slitsOf(scene, 2).width = 0.9 * units::um; },
            [](Scene& scene) { gratingOf(scene, 1).beam.power = 3.0 * units::W; },
            [](Scene& scene) {
                gratingOf(scene, 0).beam.direction = {0.6, 0.0, -0.8};
            },
            [](Scene& scene) {
                gratingOf(scene, 0).beam.direction = {0.0, 0.6, -0.8};
            },
            [](Scene& scene) {
                gratingOf(scene, 1).efficiencies = {{1, optics::constantCurve(0.3)}};
            },
            [](Scene& scene) {
                gratingOf(scene, 1).efficiencies = {{1, optics::constantCurve(0.4)}};
            },
            [](Scene& scene) {
                gratingOf(scene, 1).efficiencies = {{2, optics::constantCurve(0.4)}};
            },
            [](Scene& scene) { scene.lights[1].spectrum.density = optics::constantCurve(1.0 / 400.0); },
            [](Scene& scene) {
                auto& red = std::get<scene::Diffuse>(scene.materials[1].model);
                for (optics::Knot& knot : red.reflectance) knot.value *= 0.5;
            }};
}

// Three gratings and walls of three colours.
scene::Scene fourGratings() {
    scene::Scene scene = sceneFile("scenes/gratings/five-gratings.json");
    scene.lights.resize(4);
    return scene;
}

TEST(TableMemo, ChangesNoTable) {
    TableMemo memo;
    scene::Scene scene = fourGratings();
    for (const auto& change : changes()) {
        for (const compile::Measure measure : {compile::Measure::color, compile::Measure::radiance}) {
            const compile::CompiledScene remembered = compile::compileScene(scene, measure, &memo);
            const compile::CompiledScene afresh = compile::compileScene(scene, measure);
            EXPECT_TRUE(sameBytes(entriesOf(remembered.responses), entriesOf(afresh.responses)));
            EXPECT_TRUE(sameBytes(remembered.slitGratings, afresh.slitGratings));
            EXPECT_TRUE(sameBytes(remembered.tables, afresh.tables));
        }
        change(scene);
    }
}

// The same for openings, with one of each kind.
TEST(TableMemo, ChangesNoOpening) {
    const std::vector<std::function<void(scene::Scene&)>> changes = {
        [](scene::Scene& scene) { gratingOf(scene, 0).beam.power = 3.0 * units::W; },
        [](scene::Scene& scene) {
            std::get<optics::CircularAperture>(gratingOf(scene, 1).aperture).diameter = 35.0 * units::um;
            gratingOf(scene, 1).beam.profile = scene::BeamProfile::gaussian;
        },
        [](scene::Scene& scene) {
            for (std::size_t i = 0; i < 8; ++i)
                gratingOf(scene, i).beam.direction = {0.06, 0.08, -0.99498744};
            gratingOf(scene, 1).beam.width = 40.0 * units::um;
        },
        [](scene::Scene& scene) {
            std::get<optics::MaskAperture>(gratingOf(scene, 7).aperture).transmission[300] = 0.5F;
        },
        [](scene::Scene& scene) {
            std::get<optics::LatticeAperture>(gratingOf(scene, 6).aperture).firstCount = 3;
        }};
    TableMemo memo;
    scene::Scene scene = sceneFile("scenes/apertures/wall.json");
    auto& lattice = std::get<optics::LatticeAperture>(gratingOf(scene, 6).aperture);
    lattice.firstCount = lattice.secondCount = 2;  // whose tables are made in an instant
    for (const auto& change : changes) {
        const compile::CompiledScene remembered =
            compile::compileScene(scene, compile::Measure::color, &memo);
        const compile::CompiledScene afresh = compile::compileScene(scene, compile::Measure::color);
        EXPECT_TRUE(sameBytes(remembered.openingGratings, afresh.openingGratings));
        EXPECT_TRUE(sameBytes(remembered.tables, afresh.tables));
        change(scene);
    }
}

// What the second grating sends into directions up to u.
glm::dvec3 lightUpTo(double u, const compile::CompiledScene& scene) {
    const device::SlitGrating& grating = scene.slitGratings[1];
    const auto part =
        std::find_if(scene.responses.parts().begin(), scene.responses.parts().end(),
                     [&](const auto& candidate) { return candidate.first == grating.response; });
    const double place = std::clamp(grating.zeroEntry + u * grating.perU, 0.0, grating.entries - 1.0);
    const auto i = std::min(static_cast<device::uint>(place), grating.entries - 2);
    const auto at = [&](device::uint entry) { return glm::dvec3((*part->table)[entry].integral); };
    return double{grating.integralUnit} / grating.perU *
           glm::mix(at(i), at(i + 1), place - static_cast<double>(i));
}

// A scene with drafts, and with whole tables once none are wanted: these as if there were no memo. Both have
// the same pipeline.
struct DraftAndWhole {
    compile::CompiledScene draft;
    compile::CompiledScene whole;
};
DraftAndWhole draftAndWhole(const scene::Scene& scene, TableMemo& memo) {
    DraftAndWhole out;
    out.draft = compile::compileScene(scene, compile::Measure::color, &memo);
    EXPECT_TRUE(memo.hasDrafts());
    memo.wantDrafts(false);
    out.whole = compile::compileScene(scene, compile::Measure::color, &memo);
    EXPECT_FALSE(memo.hasDrafts());
    const compile::CompiledScene afresh = compile::compileScene(scene, compile::Measure::color);
    EXPECT_TRUE(sameBytes(entriesOf(out.whole.responses), entriesOf(afresh.responses)));
    EXPECT_TRUE(sameBytes(out.whole.openingGratings, afresh.openingGratings));
    EXPECT_TRUE(sameBytes(out.whole.tables, afresh.tables));
    EXPECT_EQ(compile::specialise(out.draft, scene.camera), compile::specialise(out.whole, scene.camera));
    return out;
}

// A draft of a table that is there is never made, and none stays where no drafts are wanted.
TEST(TableMemo, MakesDraftsForAMovingSceneAlone) {
    for (const std::uint32_t count : {2U, 40U, 3000U}) {
        TableMemo memo;
        scene::Scene scene = fourGratings();
        const compile::CompiledScene before = compile::compileScene(scene, compile::Measure::color, &memo);
        memo.wantDrafts(true);
        const compile::CompiledScene same = compile::compileScene(scene, compile::Measure::color, &memo);
        EXPECT_TRUE(sameBytes(entriesOf(same.responses), entriesOf(before.responses)));
        EXPECT_FALSE(memo.hasDrafts());
        slitsOf(scene, 1).count = count;
        slitsOf(scene, 1).period = 2.2 * units::um;
        const auto [draft, whole] = draftAndWhole(scene, memo);
        // A shorter table, of not much else.
        EXPECT_LT(draft.slitGratings[1].entries, whole.slitGratings[1].entries / 6);
        const device::SlitGrating& fine = whole.slitGratings[1];
        double worst = 0.0;  // of the light up to an entry, as a share of all
        const glm::dvec3 all = lightUpTo(2.0, whole);
        for (device::uint i = 0; i < fine.entries; ++i) {
            const double u = (1.0 * i - fine.zeroEntry) / fine.perU;
            const glm::dvec3 off = glm::abs(lightUpTo(u, draft) - lightUpTo(u, whole)) / all;
            worst = std::max({worst, off.x, off.y, off.z});
        }
        EXPECT_LT(worst, 0.01) << count;  // of many slits, whose orders are drawn in steps of some nanometres
    }
}

TEST(TableMemo, MakesDraftsOfOpeningsForAMovingSceneAlone) {
    TableMemo memo;
    scene::Scene scene = sceneFile("scenes/apertures/wall.json");
    auto& lattice = std::get<optics::LatticeAperture>(gratingOf(scene, 6).aperture);
    lattice.firstCount = lattice.secondCount = 2;  // whose tables are made in an instant
    compile::compileScene(scene, compile::Measure::color, &memo);
    memo.wantDrafts(true);
    compile::compileScene(scene, compile::Measure::color, &memo);
    EXPECT_FALSE(memo.hasDrafts());
    lattice.secondCount = 3;
    gratingOf(scene, 1).beam.profile = scene::BeamProfile::gaussian;
    gratingOf(scene, 1).beam.width = 40.0 * units::um;
    std::get<optics::MaskAperture>(gratingOf(scene, 7).aperture).pixel = 1.1 * units::um;
    const auto [draft, whole] = draftAndWhole(scene, memo);
    for (const std::size_t i : {1U, 7U})
        EXPECT_EQ(2.0F * draft.openingGratings[i].size_um, whole.openingGratings[i].size_um) << i;
}

// A table that tells how often one was made.
class Maker {
public:
    int madeFor(TableMemo& memo, double number) {
        return *memo.table(TableMemo::Key().add(number), [this] { return ++made_; });
    }

private:
    int made_ = 0;
};

TEST(TableMemo, MakesATableOnceWhileScenesWantIt) {
    TableMemo memo;
    Maker maker;
    EXPECT_EQ(maker.madeFor(memo, 1.0), 1);
    EXPECT_EQ(maker.madeFor(memo, 2.0), 2);
    EXPECT_EQ(maker.madeFor(memo, 1.0), 1);
    memo.beginScene();
    EXPECT_EQ(maker.madeFor(memo, 1.0), 1);
    memo.beginScene();
    EXPECT_EQ(maker.madeFor(memo, 1.0), 1);
    EXPECT_EQ(maker.madeFor(memo, 2.0), 3);  // the scene before had no use for it
}

TEST(TableMemo, TellsSequencesApart) {
    const optics::Curve first{{500.0, 1.0}, {600.0, 2.0}}, none;
    EXPECT_FALSE(TableMemo::Key().add(first).add(none) == TableMemo::Key().add(none).add(first));
    EXPECT_FALSE(TableMemo::Key().add(none) == TableMemo::Key());
    EXPECT_TRUE(TableMemo::Key().add(first) == TableMemo::Key().add(first));
}

}  // namespace
}  // namespace fringe::testing
