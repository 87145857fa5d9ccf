// Power: what a grating sends through the walls of a box around it is what its beam puts in.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "optics/color.hpp"
#include "optics/sources.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

using glm::dvec3;
using units::mm, units::nm, units::um, units::W;

// A wall of the box, and how an orthographic camera inside it is turned to see just that wall.
struct Wall {
    dvec3 center;
    dvec3 up;
    double width;
    double height;
};

// Watts on the wall: the sum of irradiance times area over the pixels.
double powerOn(const Wall& wall, const optics::Slits& slits, units::Length wavelength, dvec3 beam) {
    // Along two metres. The orders of many slits are narrow: their images have to be resolved where they are
    // not narrower than a pixel by far.
    const double pixels = slits.count < 100 ? 512 : 2048;
    scene::Scene scene{};
    scene.image.width = static_cast<std::uint32_t>(pixels * wall.width / 2.0);
    scene.image.height = static_cast<std::uint32_t>(pixels * wall.height / 2.0);
    scene.image.samples = 1;
    const dvec3 outwards = glm::normalize(wall.center - dvec3(0, 0, wall.center.z == -1.0 ? 0.0 : -0.5));
    scene.camera.position = wall.center - 0.1 * outwards;
    scene.camera.target = wall.center;
    scene.camera.up = wall.up;
    scene.camera.projection = scene::Orthographic{wall.height};
    scene.materials.push_back({"wall", scene::Diffuse{optics::constantCurve(1.0)}});
    for (const Wall& side : std::initializer_list<Wall>{{{0, 0, -1}, {0, 1, 0}, 2, 2},
                                                        {{-1, 0, -0.5}, {0, 1, 0}, 1, 2},
                                                        {{1, 0, -0.5}, {0, 1, 0}, 1, 2}}) {
        const dvec3 v = 0.5 * side.height * side.up;
        const dvec3 u = side.center.z == -1.0 ? dvec3(1, 0, 0) : dvec3(0, 0, 0.5);
        scene.objects.push_back({"", scene::Rectangle{side.center, u, v}, 0});
    }
    scene::Grating grating{.position = {0, 0, 0},
                           .normal = {0, 0, -1},
                           .slitDirection = {0, 1, 0},
                           .aperture = slits,
                           .beam = {.profile = scene::BeamProfile::rectangle,
                                    .width = 1.0 * mm,
                                    .height = 400.0 * mm,
                                    .direction = glm::normalize(beam),
                                    .power = 3.0 * W,
                                    .angularSize = {},
                                    .focus = {}},
                           .efficiency = 0.5,
                           .efficiencies = {}};
    scene.lights.push_back({"", {1, 1, 1}, optics::laser(wavelength, {}), grating});
    const image::Image picture = renderOnDevice(scene, {.measure = compile::Measure::irradiance});
    double sum = 0.0;
    for (const image::Pixel& pixel : picture.pixels) sum += pixel.y;
    const double edge = 2.0 / pixels;
    return sum * edge * edge;
}

double powerOnBox(const optics::Slits& slits, units::Length wavelength, dvec3 beam) {
    double sum = 0.0;
    for (const Wall& wall : std::initializer_list<Wall>{{{0, 0, -1}, {0, 1, 0}, 2, 2},
                                                        {{-1, 0, -0.5}, {0, 1, 0}, 1, 2},
                                                        {{1, 0, -0.5}, {0, 1, 0}, 1, 2}})
        sum += powerOn(wall, slits, wavelength, beam);
    return sum;
}

struct Emitter {
    std::uint32_t count;
    double width_um;
    double period_um;
    dvec3 beam;
};

class PowerOnDevice : public ::testing::TestWithParam<Emitter> {};

// 1e-3 of what leaves, 1.5 W. No light reaches the two walls that the slits point at: along them it stays the
// beam.
TEST_P(PowerOnDevice, ThatGoesThroughABoxIsWhatTheBeamPutsIn) {
    const auto [count, width_um, period_um, beam] = GetParam();
    for (const double wavelength_nm : {450.0, 550.0, 650.0}) {
        EXPECT_NEAR(powerOnBox({count, width_um * um, period_um * um}, wavelength_nm * nm, beam), 1.5, 1.5e-3)
            << count << " slits, " << wavelength_nm << " nm";
    }
}

INSTANTIATE_TEST_SUITE_P(Slits, PowerOnDevice,
                         ::testing::Values(Emitter{1, 0.6, 0.6, {0, 0, -1}}, Emitter{1, 4, 4, {0, 0, -1}},
                                           Emitter{5, 1, 2, {0, 0, -1}}, Emitter{20, 0.5, 1.6, {0, 0, -1}},
                                           Emitter{5, 1, 2, {0.4, 0, -1}}, Emitter{400, 1, 2, {0, 0, -1}}));

}  // namespace
}  // namespace fringe::testing
