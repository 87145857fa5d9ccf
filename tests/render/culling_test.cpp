// Scenes of many gratings: what is left out for a part of space, or of the picture, never changes a bit of
// it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "compile/grating_grid.hpp"
#include "compile/grating_reach.hpp"
#include "compile/lit_tiles.hpp"
#include "render/pieces.hpp"
#include "render/random.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

using compile::CompiledScene;
using compile::LitTiles;
using compile::Region;
using glm::dvec3;
using namespace units;

enum class Kind { thesis, slits, lines, opening };

// Anywhere in a room, in any direction, in beams of every kind.
scene::Light randomGrating(Kind kind, Random& random) {
    scene::Light light{};
    light.color = dvec3(1.0);
    const dvec3 normal = random.direction();
    const dvec3 along = glm::normalize(glm::cross(normal, random.direction()));
    const dvec3 position = dvec3(0.0, 1.0, 0.0) + random.point(1.5);
    if (kind == Kind::thesis) {
        light.model = scene::ThesisGrating{position,
                                           normal,
                                           along,
                                           {3, 1.0 * um, 2.0 * um},
                                           random.between(0.002, 0.1) * m,
                                           0.2 * W,
                                           random.oneIn(2),
                                           scene::Faults::limit};
        return light;
    }
    light.spectrum = kind == Kind::lines ? optics::Spectrum{{}, {{589.0 * nm, 1.0, 0.0 * nm}}}
                                         : optics::Spectrum{{{380.0, 1.0 / 400.0}, {780.0, 1.0 / 400.0}}, {}};
    scene::Grating grating{};
    grating.position = position;
    grating.normal = normal;
    grating.slitDirection = along;
    const auto count = static_cast<std::uint32_t>(random.between(2.0, 5.0));
    grating.aperture = optics::Slits{count, 1.0 * um, 2.0 * um};
    if (kind == Kind::opening) grating.aperture = optics::RectangularAperture{20.0 * um, 30.0 * um};
    if (kind == Kind::lines) {
        grating.aperture = optics::Slits{500, 1.0 * um, 2.0 * um};
        grating.efficiencies = {{0, {{380.0, 0.2}, {780.0, 0.2}}}, {1, {{380.0, 0.3}, {780.0, 0.3}}}};
    }
    const auto profile =
        std::array{scene::BeamProfile::flat, scene::BeamProfile::gaussian, scene::BeamProfile::rectangle};
    // The slits of lines are as high as the beam of a laser; tables are shared by those in straight light.
    const dvec3 across = glm::cross(along, normal);
    const bool isOblique = random.oneIn(3) && kind == Kind::lines;
    const double a = isOblique ? random.between(-0.5, 0.5) : 0.0,
                 b = isOblique ? random.between(-0.5, 0.5) : 0.0;
    grating.beam = {kind == Kind::lines ? scene::BeamProfile::rectangle
                                        : profile.at(static_cast<std::size_t>(random.between(0.0, 2.99))),
                    random.between(0.001, 0.02) * m,
                    random.between(0.001, 0.1) * m,
                    a * across + b * along + std::sqrt(1.0 - a * a - b * b) * normal,
                    0.02 * W,
                    random.oneIn(2) ? random.between(0.0, 0.02) * rad : 0.0 * rad,
                    {}};
    if (grating.beam.profile != scene::BeamProfile::rectangle) grating.beam.height = grating.beam.width;
    if (random.oneIn(3)) grating.beam.focus = random.between(0.5, 3.0) * m;
    light.model = grating;
    return light;
}

// Every primitive, matt and of glass, and a floor without end, in the light of so many gratings.
scene::Scene roomWith(int thesis, int slits, int lines, int openings) {
    scene::Scene scene = sceneFile("tests/render/primitives.json");
    for (scene::Material& material : scene.materials) {
        // Metals would have every path carry bands.
        if (std::holds_alternative<scene::Conductor>(material.model)) material.model = scene::Dielectric{1.4};
    }
    Random random(11);
    const std::array counts{thesis, slits, lines, openings};
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        for (int i = 0; i < counts[kind]; ++i)
            scene.lights.push_back(randomGrating(static_cast<Kind>(kind), random));
    }
    return scene;
}

void keepMatt(scene::Scene& scene) {
    std::erase_if(scene.objects, [&](const scene::Object& object) {
        return !std::holds_alternative<scene::Diffuse>(scene.materials[object.material].model) ||
               std::holds_alternative<scene::Plane>(object.shape);
    });
}

// ---- what a region may get -----------------------------------------------------------------------

// The shader's own tests of a point, in double: an independent rendering of the definitions in
// docs/theory.md.
bool isInBand(const scene::ThesisGrating& g, dvec3 point) {
    return glm::dot(point - g.position, g.normal) > 0.0 &&
           std::abs(glm::dot(point - g.position, g.slitDirection)) <= 0.5 * (g.beamDiameter / m);
}

// Light of a slit leaves with the beam's direction cosine along the slits. Where it came from lies within the
// beam as large as it is at that distance, or twenty of Fresnel's units beside it.
bool isInBeam(const scene::Grating& g, dvec3 point) {
    const dvec3 offset = point - g.position;
    const double forwards = glm::dot(offset, g.normal);
    if (forwards <= 0.0) return false;
    const double beta = glm::dot(g.beam.direction, g.slitDirection),
                 height = glm::dot(offset, g.slitDirection);
    const double away = std::sqrt(glm::dot(offset, offset) - height * height) / std::sqrt(1.0 - beta * beta);
    const double focused = g.beam.focus ? std::abs(1.0 - away / (*g.beam.focus / m)) : 1.0;
    const double half =
        0.5 * (g.beam.height / m) * (g.beam.profile == scene::BeamProfile::gaussian ? 2.2 : 1.0);
    const double edge = half * focused + 0.5 * away * (g.beam.angularSize / rad);
    const double fresnel = std::sqrt(0.5 * 780e-9 * away) / std::sqrt(1.0 - beta * beta);
    return std::abs(height - away * beta) <= edge + 20.0 * fresnel;
}

TEST(GratingReach, TakesInEveryPointThatAGratingMayLight) {
    const scene::Scene scene = roomWith(20, 40, 20, 20);
    const CompiledScene compiled = compile::compileScene(scene);
    const compile::GratingReach reach(compiled);
    ASSERT_EQ(reach.count(), 100U);
    // In the order of the shader.
    std::vector<const scene::Light*> lights;
    for (const auto& light : scene.lights) {
        const auto* grating = std::get_if<scene::Grating>(&light.model);
        if (std::holds_alternative<scene::ThesisGrating>(light.model) || grating != nullptr)
            lights.push_back(&light);
    }
    Random random(11);
    std::size_t lit = 0, leftOut = 0;
    for (int i = 0; i < 3000; ++i) {
        const double size = std::exp2(random.between(-10.0, 0.0));
        Region region{dvec3(0.0, 1.0, 0.0) + random.point(2.0), {}};
        region.high = region.low +
                      dvec3(random.between(0.0, size), random.between(0.0, size), random.between(0.0, size));
        const bool isOpen = random.oneIn(10);
        std::array<dvec3, 20> points;
        for (dvec3& point : points) {
            const dvec3 share(random.between(0, 1), random.between(0, 1), random.between(0, 1));
            point = region.low + share * (region.high - region.low) * (isOpen ? 100.0 : 1.0);
        }
        if (isOpen) region.high = dvec3(std::numeric_limits<double>::infinity());
        for (device::uint g = 0; g < reach.count(); ++g) {
            const bool mayReach = reach.mayReach(g, region);
            leftOut += mayReach ? 0 : 1;
            for (const dvec3& point : points) {
                bool isLit = false;
                if (const auto* thesis = std::get_if<scene::ThesisGrating>(&lights[g]->model)) {
                    isLit = isInBand(*thesis, point);
                } else {
                    const auto& grating = std::get<scene::Grating>(lights[g]->model);
                    isLit = g >= 80  ? glm::dot(point - grating.position, grating.normal) > 0.0
                            : g < 60 ? isInBeam(grating, point)
                                     : false;
                }
                lit += isLit ? 1 : 0;
                ASSERT_TRUE(mayReach || !isLit) << "grating " << g << ", region " << i;
            }
        }
    }
    EXPECT_GT(lit, 100'000U);
    EXPECT_GT(leftOut, 100'000U);  // most regions are small, and most gratings light little
}

// ---- pictures ------------------------------------------------------------------------------------

// One list of all gratings for all of space.
void listAll(CompiledScene& compiled) {
    device::GratingGrid& grid = compiled.frame.gratingGrid;
    const compile::GratingReach reach(compiled);
    grid.last = device::vec3(0.0F);
    grid.places = static_cast<device::uint>(compiled.tables.size());
    grid.lists = grid.places + 1;
    compiled.tables.push_back(0.0F);
    compiled.tables.push_back(static_cast<float>(reach.count()));
    for (device::uint i = 0; i < reach.count(); ++i) compiled.tables.push_back(static_cast<float>(i));
}

void expectSameBits(const image::Image& a, const image::Image& b) {
    ASSERT_EQ(a.pixels.size(), b.pixels.size());
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const auto& [p, q] = std::tie(a.pixels[i], b.pixels[i]);
        ASSERT_TRUE(p.x == q.x && p.y == q.y && p.z == q.z) << "pixel " << i;
    }
}

TEST(GratingGridOnDevice, GivesThePictureOfAllGratingsAtEveryPointBitForBit) {
    const scene::Scene scene = roomWith(18, 24, 3, 3);
    const CompiledScene compiled = compile::compileScene(scene);
    ASSERT_TRUE(compile::hasManyGratings(compiled));
    ASSERT_GT(compiled.frame.gratingGrid.last.x, 8.0F);
    const image::Image culled = renderOnDevice(scene);
    expectSameBits(culled, renderOnDevice(scene, {.changeScene = listAll}));
    scene::Scene dark = scene;
    std::erase_if(dark.lights, [](const scene::Light& light) {
        return std::holds_alternative<scene::Grating>(light.model) ||
               std::holds_alternative<scene::ThesisGrating>(light.model);
    });
    const image::Image lamps = renderOnDevice(dark);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < lamps.pixels.size(); ++i)
        changed += distance(lamps.pixels[i], culled.pixels[i]) > 1e-3 ? 1 : 0;
    EXPECT_GT(changed, lamps.pixels.size() / 20);  // the gratings are to be seen
}

TEST(GratingGridOnDevice, AgreesWithTheReference) {
    scene::Scene scene = roomWith(30, 0, 0, 0);
    keepMatt(scene);
    const image::Image device = renderOnDevice(scene), reference = renderReference(scene);
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < device.pixels.size(); ++i)
        beyond += distance(device.pixels[i], reference.pixels[i]) > 2e-3 ? 1 : 0;
    EXPECT_LT(beyond, device.pixels.size() / 100);  // silhouettes
}

// A picture of so many samples that a second pipeline pays.
scene::Scene longPicture(int thesis) {
    scene::Scene scene = roomWith(thesis, 2, 0, 0);
    keepMatt(scene);
    scene.image.width = 200;
    scene.image.height = 160;
    scene.image.samples = 128;
    return scene;
}

void expectSamePictures(const scene::Scene& scene, const char* what,
                        std::initializer_list<std::uint32_t> tileEdges) {
    const CompiledScene compiled = compile::compileScene(scene);
    const LitTiles tiles = compile::litTiles(scene, compiled);
    const auto lit = std::count(tiles.lit.begin(), tiles.lit.end(), true);
    EXPECT_GT(lit, 3) << what;
    EXPECT_LT(lit + 3, static_cast<std::ptrdiff_t>(tiles.lit.size())) << what;
    const image::Image whole = renderOnDevice(scene);
    for (const std::uint32_t tile : tileEdges) {
        SCOPED_TRACE(what + std::string(", tile ") + std::to_string(tile));
        expectSameBits(whole, renderOnDevice(scene, {.knowsLitTiles = true, .tile = tile}));
    }
}

TEST(LitTilesOnDevice, ChangeNoBitOfThePicture) {
    expectSamePictures(longPicture(3), "perspective", {0, 24, 88});
}

TEST(LitTilesOnDevice, ChangeNoBitThroughALens) {
    scene::Scene scene = longPicture(3);
    std::get<scene::Perspective>(scene.camera.projection).lens = scene::ThinLens{0.1 * m, 3.0 * m};
    expectSamePictures(scene, "lens", {0});
}

TEST(LitTilesOnDevice, ChangeNoBitOfAParallelView) {
    scene::Scene scene = longPicture(3);
    scene.camera.projection = scene::Orthographic{3.0};
    expectSamePictures(scene, "orthographic", {0});
}

TEST(LitTiles, AreAllOfThemWhereAMirrorFillsThePicture) {
    scene::Scene scene = longPicture(3);
    for (scene::Material& material : scene.materials) material.model = scene::Conductor{scene::Metal::gold};
    scene.materials.push_back({"white", scene::Diffuse{{{380.0, 0.5}, {780.0, 0.5}}}});
    scene.objects.push_back(
        {"", scene::Sphere{{0, 1, 0}, 0.5}, static_cast<std::uint32_t>(scene.materials.size() - 1)});
    scene.objects.push_back({"", scene::Plane{{0, 0, 0}, {0, 1, 0}}, 0});
    const LitTiles tiles = compile::litTiles(scene, compile::compileScene(scene));
    EXPECT_EQ(std::count(tiles.lit.begin(), tiles.lit.end(), true),
              static_cast<std::ptrdiff_t>(tiles.lit.size()));
}

// Beams that light nothing: the camera's own room is dark, and the picture that of the lamps.
TEST(LitTilesOnDevice, LeaveOutGratingsThatLightNothing) {
    scene::Scene scene = longPicture(0);
    scene.image.samples = 1;
    for (scene::Light& light : scene.lights) {
        if (auto* grating = std::get_if<scene::Grating>(&light.model)) {
            grating->position = {0.0, 5.0, 0.0};
            grating->normal = {0.0, 1.0, 0.0};
            grating->slitDirection = {1.0, 0.0, 0.0};
            grating->beam.direction = {0.0, 1.0, 0.0};
        }
    }
    const LitTiles tiles = compile::litTiles(scene, compile::compileScene(scene));
    ASSERT_TRUE(tiles.isKnown());
    EXPECT_EQ(std::count(tiles.lit.begin(), tiles.lit.end(), true), 0);
    expectSameBits(renderOnDevice(scene), renderOnDevice(scene, {.knowsLitTiles = true}));
}

TEST(Pieces, CoverEachPixelOnceAsItsTileSays) {
    Random random(11);
    LitTiles tiles{7, 5, {}};
    for (int i = 0; i < 35; ++i) tiles.lit.push_back(random.oneIn(3));
    const render::Piece whole{40, 24, 184, 136, true};
    std::vector<int> seen(224 * 160, 0);
    for (const render::Piece& piece : render::piecesOf(whole, tiles)) {
        for (std::uint32_t y = piece.y; y < piece.y + piece.height; ++y) {
            for (std::uint32_t x = piece.x; x < piece.x + piece.width; ++x) {
                ++seen.at(y * 224 + x);
                ASSERT_EQ(piece.isLit, tiles.at(x / LitTiles::kEdge, y / LitTiles::kEdge));
            }
        }
    }
    for (std::uint32_t y = 0; y < 160; ++y) {
        for (std::uint32_t x = 0; x < 224; ++x)
            ASSERT_EQ(seen[y * 224 + x], x >= 40 && y >= 24 ? 1 : 0) << x << ", " << y;
    }
}

}  // namespace
}  // namespace fringe::testing
