// Apertures of physical gratings: what they become, and openings that cannot be.
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/folder.hpp"
#include "scene/support.hpp"

namespace fringe::scene {
namespace {

using glm::dvec2;
using units::mm, units::um;

// The aperture is on line 9 from column 13.
std::string sceneWithAperture(std::string_view aperture) {
    return sceneWith(
        "",
        fmt::format(
            R"({{"type": "grating", "position": [0, 0, 1], "normal": [0, 0, 1], "slit_direction": [0, 1, 0],
"aperture": {},
"beam": {{"diameter": "1 m"}}}})",
            aperture));
}

template <class Aperture>
Aperture apertureOf(std::string_view aperture, const std::string& fileName = "s") {
    const Scene scene = parseScene(sceneWithAperture(aperture), fileName);
    return std::get<Aperture>(std::get<Grating>(scene.lights.at(0).model).aperture);
}

std::string problemsOfAperture(std::string_view aperture) {
    return problemsOf(sceneWithAperture(aperture));
}

// ---- simple openings -----------------------------------------------------------------------------

TEST(SceneApertures, AMillionSlits) {
    const auto slits =
        apertureOf<Slits>(R"({"type": "slits", "count": 1000000, "width": "0.5 um", "period": "1.5 um"})");
    EXPECT_EQ(slits.count, 1'000'000U);
    EXPECT_EQ(slits.width, 0.5 * um);
    EXPECT_EQ(slits.period, 1.5 * um);
}

TEST(SceneApertures, RectangleCircleAndRing) {
    const auto rectangle = apertureOf<optics::RectangularAperture>(
        R"({"type": "rectangle", "width": "10 um", "height": "20 um"})");
    EXPECT_EQ(rectangle.width, 10.0 * um);
    EXPECT_EQ(rectangle.height, 20.0 * um);
    const auto circle = apertureOf<optics::CircularAperture>(R"({"type": "circle", "diameter": "10 um"})");
    EXPECT_EQ(circle.diameter, 10.0 * um);
    EXPECT_EQ(circle.innerDiameter.si, 0.0);
    const auto ring = apertureOf<optics::CircularAperture>(
        R"({"type": "ring", "diameter": "10 um", "inner_diameter": "5 um"})");
    EXPECT_EQ(ring.innerDiameter, 5.0 * um);
}

TEST(SceneApertures, SlitsDoNotOverlapAndRingsAreOpen) {
    EXPECT_EQ(
        problemsOfAperture(R"({"type": "slits", "count": 2, "width": "3 um", "period": "2 um"})"),
        R"(s:9:52: "width" is "3 um"; write at most the period, which is "2 um", or the slits overlap)");
    EXPECT_EQ(problemsOfAperture(R"({"type": "ring", "diameter": "10 um", "inner_diameter": "10 um"})"),
              R"(s:9:69: "inner_diameter" is "10 um"; write less than the diameter, which is "10 um")");
}

// ---- polygons ------------------------------------------------------------------------------------

std::vector<dvec2> verticesOf(std::string_view aperture) {
    return apertureOf<optics::PolygonalAperture>(aperture).vertices;
}

// A polygon with these vertices; they are on line 9 from column 45.
std::string polygonOf(std::string_view vertices) {
    return fmt::format(R"({{"type": "polygon", "vertices": {}}})", vertices);
}

TEST(SceneApertures, RegularPolygonLiesOnItsCircle) {
    const auto vertices =
        verticesOf(R"({"type": "polygon", "sides": 6, "diameter": "10 um", "rotation": "30 deg"})");
    ASSERT_EQ(vertices.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        const double angle = (30.0 + 60.0 * static_cast<double>(i)) * std::numbers::pi / 180.0;
        EXPECT_NEAR(vertices[i].x, 5e-6 * std::cos(angle), 1e-20) << i;  // rounding of 5e-6
        EXPECT_NEAR(vertices[i].y, 5e-6 * std::sin(angle), 1e-20) << i;
    }
}

TEST(SceneApertures, PolygonIsMovedToItsCentroid) {
    const auto triangle = verticesOf(polygonOf(R"([["0 um", "0 um"], ["3 um", "0 um"], ["0 um", "6 um"]])"));
    ASSERT_EQ(triangle.size(), 3U);  // the centroid of a triangle is the mean of its corners: (1, 2) um
    EXPECT_NEAR(glm::length(triangle[0] - dvec2(-1e-6, -2e-6)), 0.0, 1e-20);
    EXPECT_NEAR(glm::length(triangle[1] - dvec2(2e-6, -2e-6)), 0.0, 1e-20);
    EXPECT_NEAR(glm::length(triangle[2] - dvec2(-1e-6, 4e-6)), 0.0, 1e-20);
    // An L of three unit squares: the mean of their middles, (5/6, 5/6), is its centroid.
    const auto corner = verticesOf(polygonOf(
        R"([["0 m", "0 m"], ["2 mm", "0 m"], ["2 mm", "1 mm"], ["1 mm", "1 mm"], ["1 mm", "2 mm"], ["0 mm", "2 mm"]])"));
    EXPECT_NEAR(glm::length(corner[0] + dvec2(5e-3 / 6)), 0.0, 1e-17);
}

TEST(SceneApertures, ClockwisePolygonsAreTurned) {
    const auto vertices = verticesOf(polygonOf(R"([["0 um", "0 um"], ["0 um", "6 um"], ["3 um", "0 um"]])"));
    const dvec2 a = vertices[1] - vertices[0];
    const dvec2 b = vertices[2] - vertices[0];
    EXPECT_NEAR(a.x * b.y - a.y * b.x, 18e-12, 1e-26);  // twice the area, positive
}

TEST(SceneApertures, PolygonsThatAreNone) {
    EXPECT_EQ(
        problemsOfAperture(
            polygonOf(R"([["0 um", "0 um"], ["1 um", "1 um"], ["1 um", "0 um"], ["0 um", "1 um"]])")),
        "s:9:45: the side from [0] to [1] meets that from [2] to [3]; write the corners in their order round "
        "the opening, each once");
    EXPECT_EQ(
        problemsOfAperture(
            polygonOf(R"([["0 um", "0 um"], ["0 um", "0 um"], ["1 um", "0 um"], ["0 um", "1 um"]])")),
        "s:9:45: the side from [0] to [1] meets that from [1] to [2]; write the corners in their order round "
        "the opening, each once");
    // The corner at (1, 0) touches the side below it.
    EXPECT_EQ(
        problemsOfAperture(polygonOf(
            R"([["0 um", "0 um"], ["2 um", "0 um"], ["2 um", "1 um"], ["1 um", "0 um"], ["0 um", "1 um"]])")),
        "s:9:45: the side from [0] to [1] meets that from [2] to [3]; write the corners in their order round "
        "the opening, each once");
    EXPECT_EQ(problemsOfAperture(polygonOf(R"([["0 um", "0 um"], ["1 um", "0 um"], ["2 um", "1e-3 nm"]])")),
              "s:9:45: the vertices lie on one line; write three or more that span an area");
}

TEST(SceneApertures, PolygonIsRegularOrHasVertices) {
    EXPECT_EQ(problemsOfAperture(R"({"type": "polygon"})"),
              R"(s:9:13: missing key "sides"; a polygon has "sides" and "diameter", or "vertices")");
    EXPECT_EQ(problemsOfAperture(R"({"type": "polygon", "sides": 5})"),
              R"(s:9:13: missing key "diameter"; a polygon has "sides" and "diameter", or "vertices")");
    EXPECT_EQ(
        problemsOfAperture(
            R"({"type": "polygon", "sides": 3, "vertices": [["0 um", "0 um"], ["1 um", "0 um"], ["0 um", "1 um"]]})"),
        R"(s:9:42: "sides" stands beside "vertices"; keep the vertices, or the keys of a regular polygon)");
}

// ---- lattices ------------------------------------------------------------------------------------

std::string latticeOf(std::string_view cell, std::string_view first, std::string_view second,
                      int firstCount = 3, int secondCount = 2) {
    return fmt::format(
        R"({{"type": "lattice", "cell": {}, "first": {}, "second": {}, "first_count": {}, "second_count": {}}})",
        cell, first, second, firstCount, secondCount);
}

constexpr std::string_view kSquare = R"({"type": "rectangle", "width": "10 um", "height": "10 um"})";
constexpr std::string_view kDisc = R"({"type": "circle", "diameter": "10 um"})";
constexpr std::string_view kHexagon = R"({"type": "polygon", "sides": 6, "diameter": "10 um"})";

TEST(SceneApertures, Lattice) {
    const auto lattice = apertureOf<optics::LatticeAperture>(
        latticeOf(kSquare, R"(["20 um", "0 um"])", R"(["-10 um", "0.03 mm"])"));
    EXPECT_EQ(std::get<optics::RectangularAperture>(lattice.cell).width, 10.0 * um);
    EXPECT_NEAR(glm::length(lattice.first - dvec2(20e-6, 0)), 0.0, 1e-20);
    EXPECT_NEAR(glm::length(lattice.second - dvec2(-10e-6, 30e-6)), 0.0, 1e-20);
    EXPECT_EQ(lattice.firstCount, 3U);
    EXPECT_EQ(lattice.secondCount, 2U);
}

TEST(SceneApertures, CopiesMayTouchButNotOverlap) {
    const auto overlap = [](std::string_view cell, std::string_view first, std::string_view second,
                            int firstCount = 3, int secondCount = 2) {
        const std::string problems =
            problemsOfAperture(latticeOf(cell, first, second, firstCount, secondCount));
        EXPECT_TRUE(problems == "no problem" ||
                    problems == "s:9:41: the openings overlap; write a smaller cell, or longer vectors")
            << problems;
        return problems != "no problem";
    };
    EXPECT_FALSE(overlap(kSquare, R"(["0.01 mm", "0 um"])", R"(["0 um", "10000 nm"])"));
    EXPECT_TRUE(overlap(kSquare, R"(["9.99 um", "0 um"])", R"(["0 um", "10 um"])"));
    EXPECT_TRUE(overlap(kSquare, R"(["10 um", "0 um"])", R"(["0 um", "9.99 um"])"));
    EXPECT_FALSE(overlap(kSquare, R"(["1 um", "0 um"])", R"(["0 um", "10 um"])", 1));
    // Discs at 60 degrees touch six others; a square lattice's diagonal neighbours do not matter.
    EXPECT_FALSE(overlap(kDisc, R"(["10 um", "0 um"])", R"(["5 um", "8.6602541 um"])"));
    EXPECT_TRUE(overlap(kDisc, R"(["10 um", "0 um"])", R"(["5 um", "8.65 um"])"));
    // Hexagons with a vertex on x tile the plane: sqrt(3)/2 of the diameter apart across their sides.
    EXPECT_FALSE(overlap(kHexagon, R"(["7.5 um", "4.3301271 um"])", R"(["0 um", "8.6602541 um"])"));
    EXPECT_TRUE(overlap(kHexagon, R"(["7.5 um", "4.3301271 um"])", R"(["0 um", "8.65 um"])"));
    // Far down a slanted lattice the copy three rows on lies 1 um beside the first.
    EXPECT_TRUE(overlap(kSquare, R"(["100 um", "0 um"])", R"(["33 um", "3 um"])", 3, 4));
    EXPECT_FALSE(overlap(kSquare, R"(["100 um", "0 um"])", R"(["33 um", "3 um"])", 1, 4));
}

TEST(SceneApertures, LatticeVectorsSpanAnArea) {
    EXPECT_EQ(
        problemsOfAperture(latticeOf(kSquare, R"(["20 um", "0 um"])", R"(["-40 um", "0 um"])")),
        R"(s:9:139: "second" is along "first", or one of them is 0; write two vectors that span an area)");
}

// ---- masks ---------------------------------------------------------------------------------------

void writeGreyPng(const std::string& path, std::uint32_t width, std::uint32_t height,
                  const std::vector<std::uint8_t>& codes) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = width;
    png.height = height;
    png.format = PNG_FORMAT_GRAY;
    ASSERT_NE(png_image_write_to_file(&png, path.c_str(), 0, codes.data(), 0, nullptr), 0) << png.message;
}

TEST(SceneApertures, MaskPassesTheRootOfItsLuminance) {
    const Folder folder;
    writeGreyPng(folder / "mask.png", 3, 2, {0, 255, 188, 255, 0, 0});
    const auto mask = apertureOf<optics::MaskAperture>(
        R"({"type": "mask", "file": "mask.png", "pixel": "5 um"})", folder / "scene.json");
    EXPECT_EQ(mask.columns, 3U);
    EXPECT_EQ(mask.rows, 2U);
    EXPECT_EQ(mask.pixel, 5.0 * um);
    ASSERT_EQ(mask.transmission.size(), 6U);
    EXPECT_EQ(mask.transmission[0], 0.0F);
    EXPECT_EQ(mask.transmission[1], 1.0F);
    // sRGB, IEC 61966-2-1: code 188 is 0.5029 of the light. The root in single precision.
    const double luminance = std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(mask.transmission[2], std::sqrt(luminance), 1e-7);
    EXPECT_EQ(mask.transmission[3], 1.0F);
}

TEST(SceneApertures, MasksThatCannotBeUsed) {
    const Folder folder;
    writeGreyPng(folder / "black.png", 2, 1, {0, 0});
    folder.write("text.png", "no picture");
    const auto problem = [&](std::string_view file) -> std::string {
        const std::string scene =
            sceneWithAperture(fmt::format(R"({{"type": "mask", "file": "{}", "pixel": "5 um"}})", file));
        try {
            parseScene(scene, folder / "scene.json");
            return "no problem";
        } catch (const SceneError& error) {
            EXPECT_EQ(error.problems().at(0).place, folder / "scene.json" + ":9:38");
            return error.problems().at(0).message;
        }
    };
    EXPECT_EQ(problem("none.png"), folder / "none.png" + ": cannot be read: No such file or directory");
    EXPECT_EQ(problem("black.png"), "the picture is black and passes no light; write one with some white");
    EXPECT_EQ(problem("text.png").find(folder / "text.png" + ": is no PNG file"), 0U);
}

}  // namespace
}  // namespace fringe::scene
