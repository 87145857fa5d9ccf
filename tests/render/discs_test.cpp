// Optical discs on the device: against the reference renderer, which follows every wavelength of every order
// back to where it comes from, and against the grating equation and the balance of power, worked out here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "optics/color.hpp"
#include "optics/sources.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

using namespace units;
using glm::dot;
using glm::dvec2;
using glm::dvec3;
using std::numbers::pi;

scene::OpticalDisc& discOf(scene::Scene& scene) {
    return std::get<scene::OpticalDisc>(scene.materials.at(0).model);
}

// A compact disc in the plane y = 0 about the origin, seen in a picture of 24 x 24 pixels, without lights.
scene::Scene discScene() {
    scene::Scene scene = sceneFile("scenes/discs/cd.json");
    scene.image.samples = 1;
    scene.image.width = scene.image.height = 24;
    std::get<scene::Disc>(scene.objects.at(0).shape).center = dvec3(0.0);
    scene.objects.resize(1);
    scene.lights.clear();
    return scene;
}

void lookAt(scene::Scene& scene, dvec3 from, dvec3 to, units::Angle fov) {
    scene.camera.position = from;
    scene.camera.target = to;
    scene.camera.up = dvec3(0.0, 0.0, -1.0);
    scene.camera.projection = scene::Perspective{fov, {}};
}

const optics::Spectrum& daylight() {
    static const optics::Spectrum spectrum = optics::namedSpectrum("D65").value();
    return spectrum;
}

template <class Model>
void addLight(scene::Scene& scene, const Model& model, const optics::Spectrum& spectrum = daylight()) {
    scene.lights.push_back({"", dvec3(1.0), spectrum, model});
}

// Largest difference between device and reference, relative to the largest value of the reference. Pixels are
// left out where that changes by more than `edge` of its largest value within two pixels: the device shows
// the mean over a pixel, the reference its middle.
double deviation(const scene::Scene& scene, double edge) {
    const image::Image device = renderOnDevice(scene), reference = renderReference(scene);
    double peak = 0.0, worst = 0.0;
    for (const image::Pixel& pixel : reference.pixels) peak = std::max(peak, distance(pixel, {}));
    EXPECT_GT(peak, 0.0);
    std::size_t judged = 0;
    const auto neighbours = [](std::uint32_t at, std::uint32_t size) {
        return std::pair(at < 2 ? 0 : at - 2, std::min(at + 2, size - 1));
    };
    for (std::uint32_t y = 0; y < reference.height; ++y) {
        for (std::uint32_t x = 0; x < reference.width; ++x) {
            double range = 0.0;
            const auto [top, bottom] = neighbours(y, reference.height);
            const auto [left, right] = neighbours(x, reference.width);
            for (std::uint32_t j = top; j <= bottom; ++j)
                for (std::uint32_t i = left; i <= right; ++i)
                    range = std::max(range, distance(reference.at(i, j), reference.at(x, y)));
            if (range > edge * peak) continue;
            ++judged;
            worst = std::max(worst, distance(device.at(x, y), reference.at(x, y)) / peak);
        }
    }
    EXPECT_GT(judged, reference.pixels.size() / 12);
    return worst;
}

constexpr dvec3 kLamp{-0.12, 0.8, -0.25};

// The streak of a small lamp, a hundred pixels wide. Of 2e-3 half are the pieces of the spectrum within which
// the shares of the orders count as even (shaders/disc.glsl), and half the width that the pixel adds to the
// lamp.
TEST(OnDevice, DiscUnderASphereAgreesWithTheReference) {
    scene::Scene scene = discScene();
    discOf(scene).pitShare = 1.0;
    lookAt(scene, {0, 0.3, 0.26}, {-0.0126, 0, 0.034}, 0.5 * deg);
    addLight(scene, scene::AreaLight{scene::Sphere{kLamp, 0.015}, 10.0 * W, false});
    EXPECT_LE(deviation(scene, 0.05), 2e-3);
}

// The sun is a cap of the sky for both.
TEST(OnDevice, DiscUnderTheSunAgreesWithTheReference) {
    scene::Scene scene = discScene();
    discOf(scene).pitShare = 1.0;
    lookAt(scene, {0, 0.3, 0.26}, {-0.0128, 0, 0.035}, 0.3 * deg);
    addLight(scene, scene::DirectionalLight{glm::normalize(-kLamp), 1000.0 * W_per_m2, 0.53 * deg});
    EXPECT_LE(deviation(scene, 0.05), 2e-3);
}

// Lines are followed one by one, so nothing is uneven but the pixel.
TEST(OnDevice, DiscUnderLinesAgreesWithTheReference) {
    scene::Scene scene = discScene();
    discOf(scene).pitShare = 1.0;
    lookAt(scene, {0, 0.3, 0.26}, {-0.0126, 0, 0.034}, 2.0 * deg);
    addLight(scene, scene::AreaLight{scene::Sphere{kLamp, 0.05}, 10.0 * W, false},
             optics::namedSpectrum("mercury").value());
    EXPECT_LE(deviation(scene, 0.005), 2e-3);
}

// All orders of a DVD and of given efficiencies, from a window that is no point, and a lamp that is a ring.
TEST(OnDevice, DiscUnderFlatLightsAgreesWithTheReference) {
    scene::Scene scene = discScene();
    discOf(scene).pitch = 0.74 * um;
    discOf(scene).pitWidth = 0.32 * um;
    discOf(scene).metal = scene::Metal::gold;
    lookAt(scene, {0, 0.3, 0.26}, {0, 0, 0}, 8.0 * deg);
    addLight(scene, scene::AreaLight{scene::Rectangle{{-0.5, 0.4, 0.1}, {0.0, 0.2, 0.0}, {0.1, 0.0, 0.2}},
                                     10.0 * W, true});
    EXPECT_LE(deviation(scene, 0.05), 1e-3);
    scene.lights.clear();
    // The image of a disc is taken for an ellipse: an error of the square of its angular radius, 0.05^2, in
    // the streak's edges.
    addLight(scene, scene::AreaLight{
                        scene::Disc{{-0.4, 0.9, 0.1}, glm::normalize(dvec3(0.4, -0.9, -0.1)), 0.05, 0.02},
                        10.0 * W, false});
    discOf(scene).efficiencies = {{-1, optics::constantCurve(0.3)}, {1, {{380.0, 0.1}, {780.0, 0.5}}}};
    EXPECT_LE(deviation(scene, 0.02), 1e-2);
}

// Everything that a disc shows: hub, plain metal, data with what pits scatter, rim; under the open sky, seen
// in a gold mirror. The sky's light is summed over bands of 5 to 12 nm, in some of which an order passes off.
TEST(OnDevice, DiscUnderTheSkyInAMirrorAgreesWithTheReference) {
    scene::Scene scene = discScene();
    scene.objects.push_back({"", scene::Rectangle{{0.0, 0.1, 0.5}, {0.3, 0.0, 0.0}, {0.0, 0.3, 0.05}}, 2});
    scene.materials.resize(2);
    scene.materials.push_back({"mirror", scene::Conductor{scene::Metal::gold}});
    lookAt(scene, {0.3, 0.5, 0.1}, {0.1, 0.1, 0.48}, 30.0 * deg);
    addLight(scene, scene::EnvironmentLight{1.0 * W_per_m2_sr});
    EXPECT_LE(deviation(scene, 0.05), 1e-3);
    lookAt(scene, {0.02, 0.3, 0.1}, {0, 0, 0}, 24.0 * deg);
    EXPECT_LE(deviation(scene, 0.05), 2e-3);
}

// A record: some orders near the mirror image, beyond them white, where the ripple of twelve overlapping
// orders is what errs.
TEST(OnDevice, RecordAgreesWithTheReference) {
    scene::Scene scene = discScene();
    auto& record = discOf(scene);
    record.metal = {};
    record.pitch = 113.0 * um;
    record.pitWidth = 56.0 * um;
    record.pitDepth = 28.0 * um;
    record.pitShare = 1.0;
    scene.image.width = scene.image.height = 12;
    lookAt(scene, {0, 0.3, 0.26}, {-0.0126, 0, 0.034}, 0.5 * deg);
    addLight(scene, scene::AreaLight{scene::Sphere{kLamp, 0.03}, 10.0 * W, false});
    EXPECT_LE(deviation(scene, 0.2), 0.02);
}

// ---- the grating equation and the balance of power --------------------------------

// A camera straight above with parallel rays, and a lamp without extent at `source`: where on the radius (1,
// 0, 0) the wavelength of order 1 is seen. There alpha_in + lambda/d = alpha_out = 0 for the light's own
// cosine across the track.
double radiusOfOrder(dvec3 source, double wavelengthOverPitch) {
    double low = 0.02, high = 0.2;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        const double cosine = glm::normalize(source - dvec3(middle, 0.0, 0.0)).x;  // falls with the radius
        (cosine > wavelengthOverPitch ? low : high) = middle;
    }
    return low;
}

// Change of direction cosine across and along the track at a point of the disc, for light that leaves
// straight up.
dvec2 changeAt(dvec3 source, dvec2 at) {
    const dvec3 position(at.x, 0.0, at.y), radial = glm::normalize(position);
    const dvec3 toLight = glm::normalize(source - position);
    return {dot(toLight, radial), dot(toLight, glm::cross(dvec3(0.0, 1.0, 0.0), radial))};
}

struct Spot {
    double radius;    // where it should be
    dvec2 offset;     // of its middle from there, in metres
    double radiance;  // summed over pixels, Y
    double pixel;     // metres
};

Spot spotOfLaser(dvec3 source, units::Length wavelength, double height) {
    scene::Scene scene = discScene();
    discOf(scene).pitShare = 1.0;
    scene.image.width = scene.image.height = 64;
    Spot spot{radiusOfOrder(source, wavelength / discOf(scene).pitch), dvec2(0.0), 0.0, height / 64.0};
    scene.camera = {
        {spot.radius, 0.5, 0.0}, {spot.radius, 0.0, 0.0}, {0.0, 0.0, -1.0}, scene::Orthographic{height}, {}};
    addLight(scene, scene::PointLight{source, 4.0 * pi * W}, optics::laser(wavelength, 0.0 * nm));
    const image::Image picture = renderOnDevice(scene);
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            const double value = picture.at(x, y).y;
            spot.radiance += value;
            spot.offset += value * spot.pixel * dvec2(x + 0.5 - 32.0, y + 0.5 - 32.0);
        }
    }
    spot.offset /= spot.radiance;
    return spot;
}

// To 1e-6 in the direction cosine. Pixels of 0.16 um change it by 1.3e-7.
TEST(OnDevice, OrderLiesWhereTheGratingEquationSays) {
    const dvec3 source{0.4, 1.0, 0.0};
    for (const double wavelength_nm : {532.0, 545.0}) {
        const Spot spot = spotOfLaser(source, wavelength_nm * nm, 1e-5);
        ASSERT_GT(spot.radiance, 0.0);
        const dvec2 there(spot.radius + spot.offset.x, spot.offset.y);
        const dvec2 change = changeAt(source, there);
        EXPECT_NEAR(change.x, wavelength_nm / 1600.0, 1e-6);
        EXPECT_NEAR(change.y, 0.0, 1e-6);
    }
}

// The integral of the radiance over both direction cosines is the irradiance times the order's share, here by
// an area on the disc times the Jacobian. The device has no such integral: it follows from the width of a
// pixel alone.
TEST(OnDevice, OrderCarriesItsShareOfTheIrradiance) {
    const dvec3 source{0.4, 1.0, 0.0};
    constexpr double kWavelength_nm = 560.0;
    const Spot spot = spotOfLaser(source, kWavelength_nm * nm, 1e-3);
    const double h = 1e-6;
    const dvec2 at(spot.radius, 0.0);
    const dvec2 dx =
        (changeAt(source, at + dvec2(h, 0.0)) - changeAt(source, at - dvec2(h, 0.0))) / (2.0 * h);
    const dvec2 dz =
        (changeAt(source, at + dvec2(0.0, h)) - changeAt(source, at - dvec2(0.0, h))) / (2.0 * h);
    const double jacobian = std::abs(dx.x * dz.y - dx.y * dz.x);

    // The share, from the pits' Fourier coefficients, with the power of evanescent orders handed to the
    // others.
    const double step = kWavelength_nm / 1600.0, index = 1.55;
    const dvec3 toLight = glm::normalize(source - dvec3(spot.radius, 0.0, 0.0));
    const auto cosineInside = [&](double sine) { return std::sqrt(1.0 - sine * sine / (index * index)); };
    const auto share = [&](int order) {
        const double sine = order * step - toLight.x;
        const double phase =
            2.0 * pi * index * 120.0 / kWavelength_nm * (cosineInside(toLight.x) + cosineInside(sine));
        const double duty = 0.5 / 1.6;
        const double sinc = order == 0 ? 1.0 : std::sin(pi * order * duty) / (pi * order * duty);
        const double contrast = 2.0 - 2.0 * std::cos(phase);
        return order == 0 ? 1.0 - contrast * duty * (1.0 - duty) : contrast * duty * duty * sinc * sinc;
    };
    double all = 0.0;
    for (int order = -8; order <= 8; ++order)
        if (std::abs(order * step - toLight.x) < 1.0) all += share(order);
    // Fresnel at the cover, twice, near normal incidence on one side; aluminium behind it
    // (third_party/metals).
    const auto cover = [&](double cosine) {
        const double behind = cosineInside(std::sqrt(1.0 - cosine * cosine));
        const double s = (cosine - index * behind) / (cosine + index * behind);
        const double p = (index * cosine - behind) / (index * cosine + behind);
        return 0.5 * (s * s + p * p);
    };
    const double in = cover(toLight.y), out = cover(1.0);
    const double metal = 0.8748;  // (n - 1.55)^2 + k^2 over (n + 1.55)^2 + k^2 with n = 1.06, k = 6.76
    const double mirror = (1.0 - in) * (1.0 - out) * metal / (1.0 - metal * std::sqrt(in * out));
    const double distance_ = glm::length(source - dvec3(spot.radius, 0.0, 0.0));
    const double irradiance = toLight.y / (distance_ * distance_);
    const double y =
        optics::xyzPerWatt(optics::laser(kWavelength_nm * nm, 0.0 * nm), optics::constantCurve(1.0)).y;
    const double expected = irradiance * share(1) / all * mirror * y;
    // What one pixel's share is rounded by where the spot, two pixels high, ends.
    EXPECT_NEAR(spot.radiance * spot.pixel * spot.pixel * jacobian / expected, 1.0, 0.02);
}

// Order +1 of 550 nm, thrown on a wall: the mean over cells of 2 cm, worked out by following 8e6 photons (1.3
// % off at most) and by solving for the points of the disc that send light to a point of the wall, 0.07797
// and 0.0500 W/m^2 for a lamp of 1 W/sr.
TEST(OnDevice, DiscLightsAWallAsPhotonsDo) {
    const dvec3 source{0.10, 0.05, 0.50};
    struct Cell {
        dvec2 middle;
        double irradiance;
    };
    for (const Cell& cell : {Cell{{-0.20, 0.70}, 0.07797}, Cell{{-0.25, 0.78}, 0.0500}}) {
        scene::Scene scene = discScene();
        auto& shape = std::get<scene::Disc>(scene.objects.at(0).shape);
        shape.normal = dvec3(0.0, 0.0, 1.0);
        scene::OpticalDisc& disc = discOf(scene);
        disc.coverIndex = 1.0;
        disc.metal = scene::Metal::silver;
        disc.efficiencies = {{1, optics::constantCurve(1.0)}};
        disc.castsLight = true;
        scene.materials.resize(1);
        scene.materials.push_back({"wall", scene::Diffuse{optics::constantCurve(1.0)}});
        scene.objects.push_back({"", scene::Plane{{-0.6, 0.0, 0.0}, {1.0, 0.0, 0.0}}, 1});
        addLight(scene, scene::PointLight{source, 4.0 * pi * W}, optics::laser(550.0 * nm, 0.0 * nm));
        scene.camera = {{-0.4, cell.middle.x, cell.middle.y},
                        {-0.6, cell.middle.x, cell.middle.y},
                        {0, 0, 1},
                        scene::Orthographic{0.02},
                        {}};
        double sum = 0.0;
        for (const image::Pixel& pixel : renderOnDevice(scene).pixels) sum += pixel.y / (24.0 * 24.0);
        const double perWatt =
            optics::xyzPerWatt(optics::laser(550.0 * nm, 0.0 * nm), optics::constantCurve(1.0)).y;
        const dvec3 way = source - dvec3(-0.6, cell.middle.x, cell.middle.y);
        const double direct = way.x / std::pow(dot(way, way), 1.5);  // of 1 W/sr
        constexpr double kSilver = 0.983;  // n = 0.06, k = 3.59; some 0.003 less at a slant
        EXPECT_NEAR((sum * pi / perWatt - direct) / (kSilver * cell.irradiance), 1.0, 0.02);
    }
}

// Where formulas might divide by zero: a lamp and an eye on the axis of the disc, in its plane, in each
// other's mirror direction; a disc without a hole, a lamp that touches it, a window that stands on it.
TEST(OnDevice, DiscIsFiniteEverywhere) {
    for (const dvec3 eye : {dvec3(0, 0.4, 0), dvec3(0.2, 1e-4, 0)}) {
        scene::Scene scene = discScene();
        std::get<scene::Disc>(scene.objects.at(0).shape).innerRadius = 0.0;
        discOf(scene).metalInnerRadius = 1e-9;
        discOf(scene).dataInnerRadius = 1e-9;
        lookAt(scene, eye, {0, 0, 0}, 25.0 * deg);
        scene.camera.up = dvec3(0.0, 0.1, -1.0);
        for (const dvec3 lamp : {dvec3(0, 0.4, 0), dvec3(-0.2, 0.2, 0), dvec3(0.3, 1e-5, 0)}) {
            addLight(scene, scene::PointLight{lamp, 1.0 * W});
            addLight(scene, scene::DirectionalLight{-glm::normalize(lamp), 1.0 * W_per_m2});
            addLight(scene, scene::AreaLight{scene::Sphere{lamp, 0.05}, 1.0 * W, true});
        }
        addLight(scene, scene::AreaLight{scene::Rectangle{{0.0, 0.0, -0.07}, {0.1, 0, 0}, {0, 0.1, 0}},
                                         1.0 * W, true});
        addLight(scene, scene::EnvironmentLight{1.0 * W_per_m2_sr}, optics::namedSpectrum("sodium").value());
        for (const image::Pixel& pixel : renderOnDevice(scene).pixels) {
            EXPECT_TRUE(std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z));
            EXPECT_GE(pixel.y, 0.0F);
        }
    }
}

// ---- sides ------------------------------------------------------------------------

// The back is a matt disc of the label's reflectance, and so is the middle of a record.
TEST(OnDevice, LabelIsMatt) {
    scene::Scene scene = discScene();
    discOf(scene).labelReflectance = optics::constantCurve(0.4);
    std::get<scene::Disc>(scene.objects.at(0).shape).innerRadius = discOf(scene).metalInnerRadius;
    lookAt(scene, {0.02, -0.3, 0.1}, {0.03, 0, 0}, 2.0 * deg);
    addLight(scene, scene::PointLight{{0.2, -0.5, 0.1}, 10.0 * W});
    scene::Scene matt = scene;
    matt.materials.at(0).model = scene::Diffuse{optics::constantCurve(0.4)};
    const image::Image label = renderOnDevice(scene), expected = renderOnDevice(matt);
    for (std::size_t i = 0; i < label.pixels.size(); ++i)
        EXPECT_NEAR(distance(label.pixels[i], expected.pixels[i]), 0.0,
                    1e-6 * expected.pixels[i].y);  // bands summed
}

// A plain conductor, with nothing that diffracts in the scene, has none of this in its pipeline.
TEST(Discs, CostNothingWhereThereAreNone) {
    scene::Scene scene = discScene();
    scene.materials.at(0).model = scene::Conductor{scene::Metal::aluminium};
    addLight(scene, scene::PointLight{{0.2, 0.5, 0.1}, 10.0 * W});
    const compile::CompiledScene compiled = compile::compileScene(scene);
    const device::Specialisation constants = compile::specialise(compiled, scene.camera);
    EXPECT_EQ(constants.OPTICAL_DISC_COUNT, 0U);
    EXPECT_EQ(constants.HAS_SCATTERING + constants.HAS_DISC_CONTINUUM + constants.HAS_DISC_LINES +
                  constants.HAS_HUBS + constants.HAS_GROOVES,
              0U);
}

}  // namespace
}  // namespace fringe::testing
