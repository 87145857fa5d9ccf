// Optical discs: the figures of each medium, and what may take their place.
#include <gtest/gtest.h>

#include "scene/support.hpp"

namespace fringe::scene {
namespace {

using units::um;

OpticalDisc discOf(std::string_view keys) {
    const Scene scene =
        parseScene(sceneWithMaterial(fmt::format(R"({{"type": "optical-disc", {}}})", keys)), "s");
    return std::get<OpticalDisc>(scene.materials.at(0).model);
}

ThesisDisc thesisDiscOf(std::string_view moreKeys) {
    const Scene scene = parseScene(
        sceneWithMaterial(fmt::format(R"({{"type": "optical-disc", "model": "thesis"{}}})", moreKeys)), "s");
    return std::get<ThesisDisc>(scene.materials.at(0).model);
}

// The keys are on line 3 from column 45.
std::string problemsOfDisc(std::string_view keys) {
    return problemsOf(sceneWithMaterial(fmt::format(R"({{"type": "optical-disc", {}}})", keys)));
}

TEST(SceneDiscs, CompactDisc) {
    const OpticalDisc disc = discOf(R"("medium": "cd")");
    EXPECT_EQ(disc.pitch, 1.6 * um);
    EXPECT_NEAR(disc.pitWidth / um, 0.5, 1e-15);  // written in nm
    EXPECT_NEAR(disc.pitDepth / um, 0.12, 1e-15);
    EXPECT_EQ(disc.pitShare, 0.5);
    EXPECT_EQ(disc.coverIndex, 1.55);
    EXPECT_EQ(disc.metal, Metal::aluminium);
    EXPECT_DOUBLE_EQ(disc.dataInnerRadius, 0.025);
    EXPECT_DOUBLE_EQ(disc.dataOuterRadius, 0.058);
    EXPECT_LT(disc.metalInnerRadius, disc.dataInnerRadius);
    EXPECT_TRUE(disc.efficiencies.empty());
}

// Scalar theory needs a pit between two walls, and the data lie on the metal of a disc that has it.
TEST(SceneDiscs, EveryMediumIsSound) {
    for (const std::string medium : {"cd", "dvd", "blu-ray", "vinyl"}) {
        const OpticalDisc disc = discOf("\"medium\": \"" + medium + "\"");
        EXPECT_LT(disc.pitWidth, disc.pitch) << medium;
        EXPECT_GT(disc.pitDepth.si, 0.0) << medium;
        EXPECT_LE(disc.metalInnerRadius, disc.dataInnerRadius) << medium;
        EXPECT_LT(disc.dataInnerRadius, disc.dataOuterRadius) << medium;
        EXPECT_LT(disc.dataOuterRadius, medium == "vinyl" ? 0.151 : 0.060) << medium;  // of the disc itself
        EXPECT_EQ(disc.metal.has_value(), medium != "vinyl") << medium;
    }
}

TEST(SceneDiscs, KeysTakeTheMediumsPlace) {
    const OpticalDisc disc =
        discOf(R"("medium": "dvd", "pitch": "2 um", "pit_width": "1 um", "pit_depth": "0.2 um",
        "pit_share": 0.25, "cover_index": 1.5, "metal": "gold", "hub_radius": "1 cm", "data_inner_radius": "2 cm",
        "data_outer_radius": "3 cm", "label_reflectance": 0.125, "efficiencies": {"0": 1})");
    EXPECT_EQ(disc.pitch, 2.0 * um);
    EXPECT_EQ(disc.pitWidth, 1.0 * um);
    EXPECT_EQ(disc.pitDepth, 0.2 * um);
    EXPECT_EQ(disc.pitShare, 0.25);
    EXPECT_EQ(disc.coverIndex, 1.5);
    EXPECT_EQ(disc.metal, Metal::gold);
    EXPECT_EQ(disc.metalInnerRadius, 0.01);
    EXPECT_EQ(disc.dataInnerRadius, 0.02);
    EXPECT_EQ(disc.dataOuterRadius, 0.03);
    EXPECT_EQ(disc.labelReflectance, optics::constantCurve(0.125));
    EXPECT_EQ(disc.efficiencies.size(), 1U);
    EXPECT_FALSE(discOf(R"("medium": "cd", "metal": "none")").metal);
    EXPECT_EQ(discOf(R"("medium": "vinyl", "metal": "copper")").metal, Metal::copper);
}

TEST(SceneDiscs, CustomNeedsItsTrack) {
    EXPECT_EQ(
        problemsOfDisc(R"("medium": "custom", "pit_depth": "0.1 um")"),
        "s:3:56: missing key \"pitch\", which a custom medium needs; add a length such as \"0.5 um\"\n"
        "s:3:56: missing key \"pit_width\", which a custom medium needs; add a length such as \"0.5 um\"");
    EXPECT_EQ(
        problemsOfDisc(R"("medium": "custom", "pitch": "2 um", "pit_width": "1 um", "pit_depth": "0.1 um")"),
        "no problem");
}

TEST(SceneDiscs, WhatDoesNotFitIsRefused) {
    EXPECT_EQ(problemsOfDisc(R"("medium": "cd", "pit_width": "1.6 um")"),
              R"(s:3:75: "pit_width" is 1.6 um; write less than "pitch", which is 1.6 um)");
    EXPECT_EQ(problemsOfDisc(R"("medium": "cd", "pitch": "0.4 um")"),
              R"(s:3:71: "pit_width" is 0.5 um; write less than "pitch", which is 0.4 um)");
    EXPECT_EQ(problemsOfDisc(R"("medium": "cd", "hub_radius": "26 mm")"),
              R"(s:3:76: "hub_radius" is 26 mm; write at most "data_inner_radius", which is 25 mm)");
    EXPECT_EQ(problemsOfDisc(R"("medium": "cd", "data_outer_radius": "25 mm")"),
              R"(s:3:83: "data_inner_radius" is 25 mm; write less than "data_outer_radius", which is 25 mm)");
}

TEST(SceneDiscs, OverrideOfTheMediumIsToBlame) {
    EXPECT_EQ(
        problemsOf(sceneWithMaterial(R"({"type": "optical-disc", "medium": "cd", "pit_width": "0.5 um"})"),
                   {{"materials.it.medium", "blu-ray"}}),
        R"(--set materials.it.medium=blu-ray: "pit_width" is 0.5 um; write less than "pitch", which is 0.32 um)");
}

TEST(SceneDiscs, BelongOnDiscs) {
    EXPECT_EQ(problemsOf(R"({"fringe": 1, "camera": {"position": [0, 0, 3], "target": [0, 0, 0]},
"materials": {"cd": {"type": "optical-disc", "medium": "cd"}},
"objects": [{"type": "sphere", "material": "cd", "center": [0, 0, 0], "radius": 1}]})"),
              R"(s:3:44: "cd" is an optical disc; give it only to objects of type "disc")");
}

TEST(SceneDiscs, OfTheThesis) {
    const auto plain = thesisDiscOf("");
    EXPECT_EQ(plain.slits.count, 4U);
    EXPECT_EQ(plain.slits.width, 6.0 * um);
    EXPECT_EQ(plain.slits.period, 8.3 * um);
    EXPECT_EQ(plain.mirrorReflectance, 0.6);
    EXPECT_EQ(plain.faults, Faults::limit);
    const auto full = thesisDiscOf(
        R"(, "slits": {"count": 5, "width": "0.6 um"}, "mirror_reflectance": 0.5, "faults": "as-printed")");
    EXPECT_EQ(full.slits.count, 5U);
    EXPECT_EQ(full.slits.width, 0.6 * um);
    EXPECT_EQ(full.slits.period, 8.3 * um);
    EXPECT_EQ(full.mirrorReflectance, 0.5);
    EXPECT_EQ(full.faults, Faults::asPrinted);
}

}  // namespace
}  // namespace fringe::scene
