// Light behind slits against closed forms, published values, and the sum of the spherical waves from every
// point of the slits.
#include "oracle/slit_wave.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <numbers>

#include "gratings.hpp"
#include "oracle/beam.hpp"
#include "oracle/quadrature.hpp"

namespace fringe::oracle {
namespace {

using namespace units;
using Complex = std::complex<double>;
using glm::dvec2;
using glm::dvec3;
using optics::Slits;
using scene::BeamProfile;
using std::numbers::pi;

constexpr double kWavelength = 550e-9;

dvec2 incidence(const scene::Grating& grating) {
    return dvec2(grating.beam.direction);
}

SlitWave wave(const scene::Grating& grating) {
    return {grating, std::get<Slits>(grating.aperture)};
}

// As if all light propagated.
double irradiance(const scene::Grating& grating, const dvec3& offset,
                  const dvec3& normal = {0.0, 0.0, -1.0}) {
    const SlitWave slits = wave(grating);
    return slits.irradiance(slits.view(offset, normal, incidence(grating)), kWavelength);
}

// Every point of every slit sends out a spherical wave; ways are exact.
double sumOfSphericalWaves(const scene::Grating& grating, const dvec3& offset, std::size_t alongPanels) {
    const auto& slits = std::get<Slits>(grating.aperture);
    const dvec3 incident = grating.beam.direction;
    const auto wayTo = [&](double x, double y) {
        if (!grating.beam.focus) return incident.x * x + incident.y * y;
        const double f = grating.beam.focus->si;
        return f - glm::length(f * incident - dvec3(x, y, 0.0));
    };
    const double distance = glm::length(offset);
    Complex sum = 0.0;
    for (std::uint32_t i = 0; i < slits.count; ++i) {
        const double middle = (i - 0.5 * (slits.count - 1.0)) * slits.period.si;
        const double half = std::min(halfChord(grating.beam, middle), 2.0 * grating.beam.height.si);
        if (half <= 0.0) continue;
        forNodes(middle - 0.5 * slits.width.si, middle + 0.5 * slits.width.si, 1, [&](double x, double dx) {
            forNodes(-half, half, alongPanels, [&](double y, double dy) {
                const double way = wayTo(x, y) + glm::length(offset - dvec3(x, y, 0.0)) - distance;
                sum += dx * dy * std::sqrt(relativeIrradiance(grating.beam, middle, y)) *
                       std::polar(1.0, 2.0 * pi * way / kWavelength);
            });
        });
    }
    const double gamma = offset.z / distance;  // obliquity, and the cosine on a wall across the normal
    return peakIrradiance(grating.beam) * gamma * gamma * std::norm(sum) /
           std::pow(kWavelength * distance, 2);
}

// P = 5 mW, D = 5 mm, five slits of 1 um every 2 um, 550 nm, 1 m away: 0.01157 W/m^2, and order 1 at 0.2860
// m.
TEST(SlitWave, WorkedExample) {
    scene::Grating grating = lit(Slits{5, 1.0 * um, 2.0 * um}, BeamProfile::flat, 5.0 * mm);
    // Without the ripple of the edges, which the example leaves out.
    const double ripple = std::norm(evenSection(2.5e-3, {0.0, 1.0, 0.0}, kWavelength)) / kWavelength;
    EXPECT_NEAR(5e-3 * irradiance(grating, {0.0, 0.0, 1.0}) / ripple, 0.01157, 5e-6);

    // Over the light of a single slit the orders are as high as order 0.
    const scene::Grating single = lit(Slits{1, 1.0 * um, 2.0 * um}, BeamProfile::flat, 5.0 * mm);
    double best = 0.0;
    double place = 0.0;
    for (double x = 0.24; x < 0.33; x += 1e-4) {
        const double here = irradiance(grating, {x, 0.0, 1.0}) / irradiance(single, {x, 0.0, 1.0});
        if (here > best) {
            best = here;
            place = x;
        }
    }
    EXPECT_NEAR(place, 0.2860, 1e-4);
    EXPECT_NEAR(best, 25.0, 1e-3);
}

// Young's two slits: the squared cosine under the envelope, dark where the ways differ by half a wave.
TEST(SlitWave, TwoSlits) {
    const scene::Grating grating = lit(Slits{2, 4.0 * um, 40.0 * um}, BeamProfile::gaussian, 4.0 * mm);
    const double middle = irradiance(grating, {0.0, 0.0, 2.0});
    for (double turns = 0.0; turns < 3.0; turns += 0.125) {
        const double u = turns * kWavelength / 40e-6;
        const double x = 2.0 * u / std::sqrt(1.0 - u * u);
        const double a = pi * u * 4e-6 / kWavelength;
        const double envelope = a == 0.0 ? 1.0 : std::sin(a) / a;
        const double expected =
            middle * std::pow(std::cos(pi * turns) * envelope, 2) * std::pow(1.0 - u * u, 1.5);
        // The beam grows along the slits by 0.4 % on its way, and this by twice u^2 / 2 more on a longer way.
        EXPECT_NEAR(irradiance(grating, {x, 0.0, 2.0}), expected, 1e-5 * middle) << turns;
    }
}

// A single slit is taken as far away: (0.5 um)^2 / (550 nm 0.5 m) turns are left out. What the sum of waves
// has besides is coma along the slit, and the obliquity of its ends, 1e-5.
TEST(SlitWave, FewSlitsAreTheSumOfTheirSphericalWaves) {
    scene::Grating grating = lit(Slits{3, 1.0 * um, 2.0 * um}, BeamProfile::flat, 2.0 * mm);
    const double peak = irradiance(grating, {0.0, 0.0, 0.5});
    for (const double x : {0.0, 0.04, 0.15}) {
        for (const double y : {0.0, 0.5e-3, 0.93e-3, 1.1e-3, 1.6e-3}) {
            EXPECT_NEAR(irradiance(grating, {x, y, 0.5}), sumOfSphericalWaves(grating, {x, y, 0.5}, 100),
                        1e-4 * peak)
                << x << ' ' << y;
        }
    }
}

// Oblique to the slits the orders lie on a cone, and the beam's image is shifted along.
TEST(SlitWave, ConicalLightIsTheSumOfItsSphericalWaves) {
    scene::Grating grating = lit(Slits{3, 1.0 * um, 2.0 * um}, BeamProfile::flat, 2.0 * mm);
    grating.beam.direction = towards(0.2, -0.35);
    double peak = 0.0;
    double worst = 0.0;
    for (const double x : {-0.1, 0.08, 0.11, 0.3}) {
        const double distance = std::hypot(x, 0.5) / std::sqrt(1.0 - 0.35 * 0.35);
        for (const double y : {-1.2e-3, -0.4e-3, 0.0, 0.8e-3}) {
            const dvec3 offset(x, y - 0.35 * distance, 0.5);
            const double here = irradiance(grating, offset);
            peak = std::max(peak, here);
            worst = std::max(worst, std::abs(here - sumOfSphericalWaves(grating, offset, 2000)));
        }
    }
    EXPECT_LT(worst, 2e-3 * peak);  // coma: 3 beta (1 mm)^3 / (6 R^2) of way, 0.001 of a turn
}

// A grating that fills the beam: each order is an image of the beam with Fresnel's edges on all sides.
TEST(SlitWave, FilledBeamIsTheSumOfItsSphericalWaves) {
    const scene::Grating grating = lit(Slits{260, 1.0 * um, 2.0 * um}, BeamProfile::flat, 0.5 * mm);
    const double first = 0.3 * std::tan(std::asin(kWavelength / 2e-6));
    double peak = 0.0;
    double worst = 0.0;
    for (const double order : {0.0, first}) {
        for (const double x : {-0.25e-3, -0.1e-3, 0.0, 0.17e-3, 0.3e-3}) {
            for (const double y : {0.0, 0.2e-3, 0.3e-3}) {
                const dvec3 offset(order + x, y, 0.3);
                const double here = irradiance(grating, offset);
                peak = std::max(peak, here);
                worst = std::max(worst, std::abs(here - sumOfSphericalWaves(grating, offset, 8)));
            }
        }
    }
    EXPECT_LT(worst, 1e-3 * peak);
}

// A lens brings each order to a point, where the far field is: with five slits more than half a millimetre
// wide, sharper than the beam.
TEST(SlitWave, FocusedBeamIsTheSumOfItsSphericalWaves) {
    for (const double focus : {0.3, 0.5}) {
        scene::Grating grating = lit(Slits{250, 1.0 * um, 2.0 * um}, BeamProfile::flat, 0.5 * mm);
        grating.beam.focus = focus * m;
        grating.beam.direction = towards(0.1, 0.05);
        const double alpha = 0.1 + kWavelength / 2e-6;
        const dvec3 first = towards(alpha, 0.05) * (0.3 / towards(alpha, 0.05).z);
        const dvec3 straight = towards(0.1, 0.05) * (0.3 / towards(0.1, 0.05).z);
        double peak = 0.0;
        double worst = 0.0;
        for (const dvec3& order : {straight, first}) {
            for (const double x : {-0.2e-3, 0.0, 0.1e-3}) {
                for (const double y : {0.0, 0.05e-3, 0.2e-3}) {
                    const dvec3 offset = order + dvec3(x, y, 0.0);
                    const double here = irradiance(grating, offset);
                    peak = std::max(peak, here);
                    worst = std::max(worst, std::abs(here - sumOfSphericalWaves(grating, offset, 8)));
                }
            }
        }
        EXPECT_LT(worst, 2e-3 * peak) << focus;
    }
}

// A Gaussian stays one: H. Kogelnik, T. Li, "Laser Beams and Resonators", 1966. Order m is a copy of the
// beam, narrower by the cosine of its angle, with (a/d sinc(m a/d))^2 of the power on the grating.
TEST(SlitWave, GaussianBeamKeepsItsShapeInEveryOrder) {
    const double radius = 0.4e-3;
    const scene::Grating grating = lit(Slits{1200, 0.5 * um, 2.0 * um}, BeamProfile::gaussian, 0.8 * mm);
    const double z = 0.7;
    for (const int order : {0, 1, 2}) {
        const double alpha = order * kWavelength / 2e-6;
        const double gamma = std::sqrt(1.0 - alpha * alpha);
        const double distance = z / gamma;
        const double across = std::hypot(gamma * radius, kWavelength * distance / (pi * gamma * radius));
        const double along = std::hypot(radius, kWavelength * distance / (pi * radius));
        const double amplitude = order == 0 ? 0.25 : 0.25 * std::sin(0.25 * pi * order) / (0.25 * pi * order);
        const double peak = 2.0 * amplitude * amplitude / (pi * across * along) * gamma;
        for (const double xi : {0.0, 0.3e-3}) {
            for (const double y : {0.0, 0.5e-3}) {
                const dvec3 offset(z * alpha / gamma + xi / gamma, y, z);
                const double expected =
                    peak * std::exp(-2.0 * xi * xi / (across * across) - 2.0 * y * y / (along * along));
                // The distance changes across the spot, by 1e-3 of it at 33 degrees.
                EXPECT_NEAR(irradiance(grating, offset), expected, 2e-3 * peak)
                    << order << ' ' << xi << ' ' << y;
            }
        }
    }
}

// Table of docs/theory.md: closed forms with sine integrals.
TEST(SlitWave, PropagatingShareHasItsPublishedValues) {
    const auto share = [](std::uint32_t count, double width_um, double period_um, double wavelength_nm,
                          const dvec2& incident = dvec2(0.0)) {
        return wave(lit(Slits{count, width_um * um, period_um * um}, BeamProfile::flat, 5.0 * mm))
            .propagatingShare(1e-9 * wavelength_nm, incident);
    };
    constexpr double kPrinted = 6e-7;
    EXPECT_NEAR(share(1, 1.0, 2.0, 450.0), 0.951357, kPrinted);
    EXPECT_NEAR(share(5, 1.0, 2.0, 550.0), 0.949918, kPrinted);
    EXPECT_NEAR(share(2, 1.0, 2.0, 700.0), 0.917546, kPrinted);
    EXPECT_NEAR(share(50, 0.5, 1.6, 550.0), 0.899237, kPrinted);
    EXPECT_NEAR(share(5, 0.25, 0.5, 550.0), 0.567575, kPrinted);
    EXPECT_NEAR(share(1000, 0.25, 0.5, 650.0), 0.500096, kPrinted);
    EXPECT_NEAR(share(1000, 4.0, 8.0, 550.0), 0.985550, kPrinted);
    EXPECT_NEAR(share(3, 0.7, 1.5, 600.0), 0.902130415650, 1e-11);
    EXPECT_NEAR(share(50, 0.8, 1.6, 550.0, {0.5, 0.0}), 0.9276, 6e-5);
    EXPECT_NEAR(share(50, 0.8, 1.6, 550.0, {0.8, 0.0}), 0.7333, 6e-5);
    // With a part along the slits light behaves as if it had a longer wavelength: 440 nm / 0.8.
    EXPECT_NEAR(share(50, 0.8, 1.6, 440.0, {0.0, 0.6}), share(50, 0.8, 1.6, 550.0), 1e-12);
    EXPECT_NEAR(share(50, 0.8, 1.6, 440.0, {0.4, 0.6}), share(50, 0.8, 1.6, 550.0, {0.5, 0.0}), 1e-12);
}

// All light that leaves goes through the half cylinder about the slits: the wall of a box, bent. A Gaussian
// beam leaves nothing beyond its three diameters.
TEST(SlitWave, SendsOutWhatPassesTheSlits) {
    for (const dvec2 incident : {dvec2(0.0), dvec2(0.25, -0.3)}) {
        for (const std::uint32_t count : {1U, 2U, 5U}) {
            scene::Grating grating = lit(Slits{count, 1.0 * um, 2.0 * um}, BeamProfile::gaussian, 2.0 * mm);
            grating.beam.direction = towards(incident.x, incident.y);
            const double radius = 0.5;
            const double rise = radius * incident.y / std::sqrt(1.0 - incident.y * incident.y);
            double power = 0.0;
            forNodes(-0.5 * pi, 0.5 * pi, 40, [&](double angle, double dAngle) {
                const dvec3 out(std::sin(angle), 0.0, std::cos(angle));
                forNodes(-6e-3, 6e-3, 4, [&](double y, double dy) {
                    power += irradiance(grating, radius * out + dvec3(0.0, rise + y, 0.0), -out) * radius *
                             dAngle * dy;
                });
            });
            // Of one watt, a slit lets through its width over the beam's: 2 / (pi w^2) sqrt(pi / 2) w.
            double passing = 0.0;
            for (std::uint32_t i = 0; i < count; ++i) {
                const double x = 2e-3 * (i - 0.5 * (count - 1.0));  // over the beam's radius
                passing += 1e-6 * std::sqrt(2.0 / pi) / 1e-3 * std::exp(-2.0 * x * x);
            }
            const double share = wave(grating).propagatingShare(kWavelength, incident);
            EXPECT_NEAR(power, passing * share, 1e-6 * passing) << count;
        }
    }
}

// Along the slits an even beam keeps its sharp edge but for Fresnel's fringes, whose tails reach far: 1/(pi^2
// y) of Fresnel's units beyond y.
TEST(SlitWave, EvenBeamKeepsItsPower) {
    const scene::Grating grating = lit(Slits{1, 2.0 * um, 2.0 * um}, BeamProfile::flat, 2.0 * mm);
    const double z = 0.5;
    double power = 0.0;
    forNodes(-8e-3, 8e-3, 400, [&](double y, double dy) { power += irradiance(grating, {0.0, y, z}) * dy; });
    const double unit = std::sqrt(0.5 * kWavelength * z);
    const double tails = 2.0 / (pi * pi * 7e-3 / unit) * unit;  // of the height of 2 mm
    const double perHeight = peakIrradiance(grating.beam) * 2e-6 * 2e-6 / kWavelength / z;
    EXPECT_NEAR(power, perHeight * 2e-3, 1.5 * perHeight * tails);
}

TEST(SlitWave, FallsOffWithTheDistance) {
    const scene::Grating grating = lit(Slits{5, 1.0 * um, 2.0 * um}, BeamProfile::gaussian, 10.0 * mm);
    // The beam itself grows by 1.2e-5 from 1 m to 2 m.
    EXPECT_NEAR(irradiance(grating, {0.2, 0.0, 1.0}) / irradiance(grating, {0.4, 0.0, 2.0}), 2.0, 1e-3);
}

TEST(SlitWave, HasTheStatedEfficiency) {
    scene::Grating grating = lit(Slits{5, 1.0 * um, 2.0 * um}, BeamProfile::flat, 5.0 * mm);
    const double open = irradiance(grating, {0.1, 0.0, 1.0});
    grating.efficiency = 0.5;
    // Chords at 4 um from the middle differ from the diameter by 1e-6.
    const double share = 4.0 * 5.0 * 1e-6 / (pi * 5e-3);
    EXPECT_NEAR(irradiance(grating, {0.1, 0.0, 1.0}) * share / open, 0.5, 1e-5);
}

// Orders with the efficiencies of an amplitude grating make the amplitude grating, but for what neighbouring
// orders add to each other's foot.
TEST(SlitWave, OrdersOfAnAmplitudeGratingMakeOne) {
    scene::Grating grating = lit(Slits{50, 0.5 * um, 2.0 * um}, BeamProfile::rectangle, 5.0 * mm);
    scene::Grating orders = grating;
    for (int order = -6; order <= 6; ++order) {  // of which -4 and 4 are dark, and beyond 3 all evanescent
        const double a = 0.25 * pi * order;
        const double share = 0.0625 * (order == 0 ? 1.0 : std::pow(std::sin(a) / a, 2));
        orders.efficiencies.push_back({order, {{380.0, share}, {780.0, share}}});
    }
    const double peak = irradiance(grating, {0.0, 0.0, 1.0});
    for (double u = 0.0; u < 0.9; u += 0.0031) {
        const double x = u / std::sqrt(1.0 - u * u);
        EXPECT_NEAR(irradiance(orders, {x, 0.0, 1.0}), irradiance(grating, {x, 0.0, 1.0}), 2e-3 * peak) << u;
    }
    orders.efficiencies = {{1, {{380.0, 1.0}, {780.0, 1.0}}}};
    const double first = std::tan(std::asin(kWavelength / 2e-6));
    EXPECT_GT(irradiance(orders, {first, 0.0, 1.0}), 5.0 * peak);
    EXPECT_LT(irradiance(orders, {-first, 0.0, 1.0}), 1e-3 * peak);
    orders.efficiencies = {{4, {{380.0, 1.0}, {780.0, 1.0}}}};
    EXPECT_EQ(irradiance(orders, {5.0, 0.0, 1.0}), 0.0) << "evanescent";
}

// Surfaces may be turned any way; what faces away gets nothing. Each slit has its own cosine, which differ by
// 2 um / 1 m, and in second order on average.
TEST(SlitWave, FollowsTheReceiversCosine) {
    const scene::Grating grating = lit(Slits{3, 1.0 * um, 2.0 * um}, BeamProfile::gaussian, 2.0 * mm);
    const dvec3 point(0.6, 0.0, 0.8);
    const double straight = irradiance(grating, point, -point);
    EXPECT_NEAR(irradiance(grating, point, {0.0, 0.0, -1.0}), 0.8 * straight, 1e-10 * straight);
    EXPECT_NEAR(irradiance(grating, point, {-1.0, 0.0, 0.0}), 0.6 * straight, 1e-10 * straight);
    EXPECT_EQ(irradiance(grating, point, {0.0, 0.0, 1.0}), 0.0);
}

}  // namespace
}  // namespace fringe::oracle
