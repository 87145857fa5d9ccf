// Physical gratings as lights: their beam, the side where light leaves, and how much.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "optics/sources.hpp"
#include "scene/support.hpp"

namespace fringe::scene {
namespace {

using units::deg, units::m, units::mm, units::nm, units::um, units::W;

constexpr std::string_view kSlits = R"("type": "slits", "count": 5, "width": "1 um", "period": "2 um")";
constexpr std::string_view kCircle = R"("type": "circle", "diameter": "1 mm")";

// The beam is on line 9 from column 9, the aperture on line 10 from column 13, further keys on line 11.
std::string sceneWithGrating(std::string_view beam, std::string_view aperture = kSlits,
                             std::string_view keys = "\"model\": \"physical\"") {
    return sceneWith(
        "",
        fmt::format(
            R"({{"type": "grating", "position": [0, 0, 1], "normal": [0, 0, -2], "slit_direction": [0, 3, 1],
"beam": {{{}}},
"aperture": {{{}}},
{}}})",
            beam, aperture, keys));
}

Grating gratingOf(std::string_view beam, std::string_view aperture = kSlits,
                  std::string_view keys = "\"model\": \"physical\"") {
    return std::get<Grating>(parseScene(sceneWithGrating(beam, aperture, keys), "s").lights.at(0).model);
}

std::string problemsOfGrating(std::string_view beam, std::string_view aperture = kSlits,
                              std::string_view keys = "\"model\": \"physical\"") {
    return problemsOf(sceneWithGrating(beam, aperture, keys));
}

// What the visible part of a line is known to.
constexpr double kNearlyExact = 1e-9;

// ---- values --------------------------------------------------------------------------------------

TEST(SceneGratings, FrameAndDefaults) {
    const Grating grating = gratingOf(R"("diameter": "2 mm")");
    EXPECT_EQ(grating.position, dvec3(0, 0, 1));
    EXPECT_EQ(grating.normal, dvec3(0, 0, -1));
    EXPECT_EQ(grating.slitDirection, dvec3(0, 1, 0));
    const auto& slits = std::get<Slits>(grating.aperture);
    EXPECT_EQ(slits.count, 5U);
    EXPECT_EQ(slits.width, 1.0 * um);
    EXPECT_EQ(slits.period, 2.0 * um);
    EXPECT_EQ(grating.beam.profile, BeamProfile::flat);
    EXPECT_EQ(grating.beam.width, 2.0 * mm);
    EXPECT_EQ(grating.beam.height, 2.0 * mm);
    EXPECT_EQ(grating.beam.direction, grating.normal);
    EXPECT_EQ(grating.beam.power, 1.0 * W);
    EXPECT_EQ(grating.beam.angularSize.si, 0.0);
    EXPECT_FALSE(grating.beam.focus);
    EXPECT_FALSE(grating.efficiency);
    EXPECT_TRUE(grating.efficiencies.empty());
}

TEST(SceneGratings, ModelIsPhysicalUnlessItSaysOtherwise) {
    const Scene scene = parseScene(sceneWithGrating(R"("diameter": "2 mm")", kSlits, "\"name\": \"g\""), "s");
    EXPECT_TRUE(std::holds_alternative<Grating>(scene.lights.at(0).model));
    EXPECT_EQ(scene.lights.at(0).name, "g");
}

TEST(SceneGratings, BeamWithEveryKey) {
    const std::string text = sceneWithGrating(R"("profile": "gaussian", "diameter": "3 mm", "power": "5 mW",
        "direction": [0.6, 0, -0.8], "spectrum": {"type": "lines", "lines": [{"wavelength": "500 nm"}]},
        "linewidth": "0.25 nm", "angular_size": "0.5 deg", "focus": "2 m")");
    const Light light = parseScene(text, "s").lights.at(0);
    const Beam& beam = std::get<Grating>(light.model).beam;
    EXPECT_EQ(beam.profile, BeamProfile::gaussian);
    EXPECT_EQ(beam.width, 3.0 * mm);
    EXPECT_EQ(beam.power, 5.0 * (1e-3 * W));
    EXPECT_NEAR(glm::length(beam.direction - dvec3(0.6, 0, -0.8)), 0.0, 1e-15);
    EXPECT_EQ(beam.angularSize, 0.5 * deg);
    EXPECT_EQ(beam.focus, 2.0 * m);
    ASSERT_EQ(light.spectrum.lines.size(), 1U);
    EXPECT_EQ(light.spectrum.lines[0].width, 0.25 * nm);
    EXPECT_NEAR(light.spectrum.lines[0].power, 1.0, kNearlyExact);
}

TEST(SceneGratings, LinewidthLeavesLinesThatHaveTheirOwn) {
    const std::string text = sceneWithGrating(
        R"("diameter": "3 mm", "linewidth": "0.25 nm", "spectrum": {"type": "laser", "wavelength": "500 nm", "linewidth": "1 nm"})");
    EXPECT_EQ(parseScene(text, "s").lights.at(0).spectrum.lines.at(0).width, 1.0 * nm);
}

TEST(SceneGratings, LinewidthKeepsTheWattOfALineAtTheEnd) {
    const std::string text = sceneWithGrating(
        R"("diameter": "3 mm", "linewidth": "1 nm", "spectrum": {"type": "laser", "wavelength": "380 nm"})");
    const optics::Spectrum spectrum = parseScene(text, "s").lights.at(0).spectrum;
    EXPECT_NEAR(spectrum.lines.at(0).power, 2.0, kNearlyExact);  // half of it is invisible
    EXPECT_NEAR(optics::visiblePower(spectrum), 1.0, kNearlyExact);
}

TEST(SceneGratings, RectangularBeam) {
    const Beam beam = gratingOf(R"("profile": "rectangle", "width": "3 mm", "height": "1 mm")").beam;
    EXPECT_EQ(beam.profile, BeamProfile::rectangle);
    EXPECT_EQ(beam.width, 3.0 * mm);
    EXPECT_EQ(beam.height, 1.0 * mm);
}

TEST(SceneGratings, BeamOfAReflectionComesFromTheFront) {
    const std::string reflection = R"("side": "reflection")";
    EXPECT_EQ(gratingOf(R"("diameter": "2 mm")", kSlits, reflection).beam.direction, dvec3(0, 0, 1));
    const dvec3 oblique =
        gratingOf(R"("diameter": "2 mm", "direction": [3, 0, 4])", kSlits, reflection).beam.direction;
    EXPECT_NEAR(glm::length(oblique - dvec3(0.6, 0, 0.8)), 0.0, 1e-15);
}

TEST(SceneGratings, EfficienciesOfSlits) {
    const Grating orders =
        gratingOf(R"("diameter": "2 mm")", kSlits, R"("efficiencies": {"0": 0.5, "1": 0.25})");
    EXPECT_EQ(orders.efficiencies.size(), 2U);
    EXPECT_EQ(gratingOf(R"("diameter": "2 mm")", kSlits, R"("efficiency": 0.25)").efficiency, 0.25);
}

// ---- problems ------------------------------------------------------------------------------------

TEST(SceneGratings, BeamOnTheWrongSide) {
    EXPECT_EQ(
        problemsOfGrating(R"("diameter": "2 mm", "direction": [0.6, 0, 0.8])"),
        R"(s:9:43: the beam goes against "normal", but in transmission it goes along it; write [0.6, 0, -0.8], or "side": "reflection")");
    EXPECT_EQ(
        problemsOfGrating(R"("diameter": "2 mm", "direction": [0, 0, -1])", kSlits,
                          R"("side": "reflection")"),
        R"(s:9:43: the beam goes along "normal", but in reflection it goes against it; write [0, 0, 1], or "side": "transmission")");
    EXPECT_EQ(
        problemsOfGrating(R"("diameter": "2 mm", "direction": [1, 0, 0])"),
        "s:9:43: the beam goes along the grating and never meets it; write a direction such as [0, 0, -1]");
}

TEST(SceneGratings, BeamHasTheSizesOfItsProfile) {
    EXPECT_EQ(
        problemsOfGrating(R"("width": "2 mm", "height": "1 mm")"),
        "s:9:9: missing key \"diameter\"; add a length such as \"2 mm\"\n"
        "s:9:10: unknown key \"width\"; a flat beam may have \"profile\", \"diameter\", \"direction\", "
        "\"power\", \"spectrum\", \"linewidth\", \"angular_size\" or \"focus\"\n"
        "s:9:27: unknown key \"height\"; a flat beam may have \"profile\", \"diameter\", \"direction\", "
        "\"power\", \"spectrum\", \"linewidth\", \"angular_size\" or \"focus\"");
    EXPECT_EQ(problemsOfGrating(R"("profile": "gauss", "diameter": "2 mm")"),
              R"(s:9:21: "profile" is "gauss"; write "flat", "gaussian" or "rectangle")");
}

TEST(SceneGratings, UnknownModelListsBoth) {
    EXPECT_EQ(problemsOfGrating(R"("diameter": "2 mm")", kSlits, R"("model": "magic")"),
              R"(s:11:10: "model" is "magic"; write "physical" or "thesis")");
}

TEST(SceneGratings, OpeningsLieInTheBeam) {
    // Of equal size is inside, whatever the units.
    EXPECT_EQ(problemsOfGrating(R"("diameter": "1000 um")", kCircle), "no problem");
    EXPECT_EQ(
        problemsOfGrating(R"("diameter": "0.5 mm")", kCircle),
        R"(s:9:9: the aperture reaches out of the beam, to 2 times its size; write a "diameter" of 1 mm at least, a smaller aperture, or the profile "gaussian", which has no edge)");
    EXPECT_EQ(problemsOfGrating(R"("profile": "gaussian", "diameter": "0.5 mm")", kCircle), "no problem");
    EXPECT_EQ(
        problemsOfGrating(R"("profile": "rectangle", "width": "2 mm", "height": "0.5 mm")", kCircle),
        R"(s:9:9: the aperture reaches out of the beam, to 2 times its size; write a "width" of 4 mm and a "height" of 1 mm at least, a smaller aperture, or the profile "gaussian", which has no edge)");
    // The diagonal of the rectangle counts, 5 mm; slits are longer than any beam.
    const std::string_view rectangle = R"("type": "rectangle", "width": "3 mm", "height": "4 mm")";
    EXPECT_EQ(problemsOfGrating(R"("diameter": "5 mm")", rectangle), "no problem");
    EXPECT_NE(problemsOfGrating(R"("diameter": "4.99 mm")", rectangle), "no problem");
    EXPECT_EQ(problemsOfGrating(R"("diameter": "2 um")"), "no problem");
}

// At 60 degrees a beam covers twice its diameter across the plane of incidence's trace.
TEST(SceneGratings, ObliqueBeamsCoverMore) {
    const std::string_view wide = R"("type": "rectangle", "width": "1.99 mm", "height": "1 um")";
    const std::string_view high = R"("type": "rectangle", "width": "1 um", "height": "1.99 mm")";
    const std::string_view beam = R"("diameter": "1 mm", "direction": [0.8660254037844386, 0, -0.5])";
    EXPECT_EQ(problemsOfGrating(beam, wide), "no problem");
    EXPECT_NE(problemsOfGrating(beam, high), "no problem");
    EXPECT_NE(problemsOfGrating(R"("diameter": "1 mm")", wide), "no problem");
}

TEST(SceneGratings, LatticeReachesToItsOuterCells) {
    const std::string_view lattice = R"("type": "lattice", "cell": {"type": "circle", "diameter": "1 mm"},
        "first": ["2 mm", "0 mm"], "second": ["0 mm", "2 mm"], "first_count": 4, "second_count": 1)";
    EXPECT_EQ(problemsOfGrating(R"("diameter": "7 mm")", lattice), "no problem");
    EXPECT_NE(problemsOfGrating(R"("diameter": "6.99 mm")", lattice), "no problem");
}

TEST(SceneGratings, EfficienciesBelongToSlitsAndStandAlone) {
    EXPECT_EQ(problemsOfGrating(R"("diameter": "2 mm")", kCircle, R"("efficiencies": {"0": 0.5})"),
              R"(s:11:17: only slits have orders of their own; write "efficiency" for other apertures)");
    EXPECT_EQ(
        problemsOfGrating(R"("diameter": "2 mm")", kSlits,
                          R"("efficiency": 0.5, "efficiencies": {"0": 0.5})"),
        R"(s:11:15: "efficiency" stands beside "efficiencies", which say the same in detail; keep one of them)");
}

TEST(SceneGratings, AllProblemsOfOneGratingComeTogether) {
    const std::string problems =
        problemsOfGrating(R"("diameter": "2 mm", "direction": [0, 0, 1])",
                          R"("type": "ring", "diameter": "5 mm", "inner_diameter": "6 mm")",
                          R"("efficiencies": {"0": 2, "x": 1})");
    EXPECT_EQ(problems,
              "s:11:23: \"0\" is 2; write a number from 0 to 1\n"
              "s:11:26: \"x\" is not an order such as \"-1\"");  // what is unsound is not looked into
    const std::string sound =
        problemsOfGrating(R"("diameter": "2 mm", "direction": [0, 0, 1])",
                          R"("type": "ring", "diameter": "5 mm", "inner_diameter": "6 mm")",
                          R"("efficiencies": {"0": 0.5, "1": 0.75})");
    EXPECT_EQ(std::count(sound.begin(), sound.end(), '\n'), 4) << sound;  // ring, beam twice, orders twice
}

// ---- evaluators ----------------------------------------------------------------------------------

TEST(SceneGratings, AnEvaluatorIsChosenUnlessTheSceneNamesOne) {
    EXPECT_EQ(gratingOf(R"("diameter": "2 mm")").evaluator, Evaluator::automatic);
    EXPECT_FALSE(gratingOf(R"("diameter": "2 mm")").wavelengths);
    const Grating grating =
        gratingOf(R"("diameter": "2 mm")", kSlits, R"("evaluator": "direct", "wavelengths": 81)");
    EXPECT_EQ(grating.evaluator, Evaluator::direct);
    EXPECT_EQ(grating.wavelengths, 81U);
}

TEST(SceneGratings, EvaluatorsAreForSlits) {
    EXPECT_EQ(problemsOfGrating(R"("diameter": "2 mm")", kCircle, R"("evaluator": "table")"),
              R"(s:11:14: "table" is a way to the colour of slits; other apertures are always a sum over )"
              R"(wavelengths, so leave it out)");
}

TEST(SceneGratings, GivenOrdersNeedATable) {
    EXPECT_EQ(problemsOfGrating(R"("diameter": "2 mm")", kSlits,
                                R"("evaluator": "orders", "efficiencies": {"0": 0.5})"),
              R"(s:11:14: "orders" knows the orders of slits in an opaque screen alone; with "efficiencies" )"
              R"(write "table" or "auto")");
}

TEST(SceneGratings, WavelengthsAreForSums) {
    EXPECT_EQ(
        problemsOfGrating(R"("diameter": "2 mm")", kSlits, R"("evaluator": "table", "wavelengths": 81)"),
        R"(s:11:38: "wavelengths" is for the evaluators "direct", "small-angle" and "naive", but this one )"
        R"(is "table"; leave it out, or choose one of them)");
}

}  // namespace
}  // namespace fringe::scene
