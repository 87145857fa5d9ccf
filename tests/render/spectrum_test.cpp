// Measure::spectrum: the bands of a picture are what its lights send in each, and add up to the irradiance.
#include <gtest/gtest.h>

#include <algorithm>

#include "compile/spectral.hpp"
#include "optics/color.hpp"
#include "optics/sources.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

using units::mm, units::nm, units::um, units::W;

constexpr std::uint32_t kWidth = 200;

// A line across the patterns of few slits in white light and of many in sodium's, under a lamp.
scene::Scene bench() {
    scene::Scene scene{};
    scene.image.width = kWidth;
    scene.image.height = 1;
    scene.camera = {{0, 0, -0.9}, {0, 0, -1}, {0, 1, 0}, scene::Orthographic{1.0 / kWidth}, {}};
    scene.materials.push_back({"red", scene::Diffuse{optics::reflectanceCurve({0.8, 0.1, 0.1})}});
    scene.objects.push_back({"", scene::Rectangle{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, 0});
    scene::Grating grating{.position = {0, 0, 0},
                           .normal = {0, 0, -1},
                           .slitDirection = {0, 1, 0},
                           .aperture = optics::Slits{5, 1.0 * um, 2.0 * um},
                           .beam = {.profile = scene::BeamProfile::rectangle,
                                    .width = 2.0 * mm,
                                    .height = 100.0 * mm,
                                    .direction = {0, 0, -1},
                                    .power = 2.0 * W,
                                    .angularSize = {},
                                    .focus = {}},
                           .efficiency = 0.5,
                           .efficiencies = {}};
    scene.lights.push_back({"", {1, 1, 1}, *optics::namedSpectrum("D65"), grating});
    grating.aperture = optics::Slits{1000, 1.0 * um, 2.0 * um};
    scene.lights.push_back({"", {1, 1, 1}, *optics::namedSpectrum("sodium"), grating});
    scene.lights.push_back(
        {"", {1, 1, 1}, *optics::namedSpectrum("A"), scene::PointLight{{0.2, 0.3, 0}, 0.5 * W}});
    return scene;
}

// What is left of every light in one band: its hat.
scene::Scene inBand(scene::Scene scene, device::uint band) {
    const double middle = compile::bandMiddle_nm(band);
    const optics::Curve hat{
        {compile::bandMiddle_nm(band - 1), 0.0}, {middle, 1.0}, {compile::bandMiddle_nm(band + 1), 0.0}};
    for (scene::Light& light : scene.lights) {
        light.spectrum = optics::filtered(light.spectrum, hat);
        std::erase_if(light.spectrum.lines, [](const optics::Line& line) { return line.power <= 0.0; });
    }
    return scene;
}

double largest(const image::Image& picture) {
    double value = 0.0;
    for (const image::Pixel& pixel : picture.pixels) value = std::max(value, double{pixel.y});
    return value;
}

TEST(SpectrumOnDevice, BandsAddUpToTheIrradiance) {
    const image::Image bands = renderOnDevice(bench(), {.measure = compile::Measure::spectrum});
    const image::Image all = renderOnDevice(bench(), {.measure = compile::Measure::irradiance});
    ASSERT_EQ(bands.pixels.size(), std::size_t{kWidth} * device::SPECTRAL_BANDS);
    ASSERT_EQ(all.pixels.size(), std::size_t{kWidth});
    for (std::uint32_t i = 0; i < kWidth; ++i) {
        double sum = 0.0;
        for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band)
            sum += double{bands.pixels[std::size_t{band} * kWidth + i].y};
        // Between the entries of a table a slope counts, which is kept to 1/510 of the largest of three
        // channels'; over a step of one it makes an eighth of a hundredth of the peak. And the floats' own
        // sums.
        EXPECT_NEAR(sum, double{all.pixels[i].y}, 3e-4 * sum) << i;
    }
}

// The lines' light is split exactly. Densities are integrated over wavelength in nodes that differ between
// the whole spectrum and the hat: two Gauss nodes a nanometre miss a corner of the hat by up to 0.039 nm
// times the change of slope, 0.4 per nm: 1.6e-2 nm, of 5 nm and more by at most 1e-3 in the mean of its three
// corners.
TEST(SpectrumOnDevice, EachBandIsTheLightOfItsWavelengths) {
    const image::Image bands = renderOnDevice(bench(), {.measure = compile::Measure::spectrum});
    for (const device::uint band : {4U, 20U, 30U, 36U}) {
        const image::Image alone =
            renderOnDevice(inBand(bench(), band), {.measure = compile::Measure::irradiance});
        const double peak = largest(alone);
        ASSERT_GT(peak, 0.0);
        for (std::uint32_t i = 0; i < kWidth; ++i) {
            EXPECT_NEAR(double{bands.pixels[std::size_t{band} * kWidth + i].y}, double{alone.pixels[i].y},
                        1e-3 * double{alone.pixels[i].y} + 1e-5 * peak)
                << "band " << band << ", sample " << i;
        }
    }
}

}  // namespace
}  // namespace fringe::testing
