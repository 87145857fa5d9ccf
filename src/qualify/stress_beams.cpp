// Beams where they land, and the tables that spectra and masks are looked up in. Inputs lie where such code
// breaks: on the edge of the light and on its axis, in the focus and close to it, at the ends of a table and
// on its entries.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>

#include "oracle/exact_pattern.hpp"
#include "oracle/quadrature.hpp"
#include "oracle/section.hpp"
#include "qualify/cases.hpp"
#include "shaders/stress_beams.comp.h"

namespace fringe::qualify {
namespace {

using std::numbers::pi;
using Inputs = std::span<const float>;

double anyWave(Draw& draw) {
    return draw.between(380e-9, 780e-9);
}

// Of a beam: collimated, focused anywhere, or all but in the focus at this curvature.
double anyConvergence(Draw& draw, double curvature, double half, double wavelength) {
    if (draw.oneIn(3)) return 0.0;
    if (draw.oneIn(4)) return curvature;
    if (draw.oneIn(3))
        return curvature - draw.sign() * draw.magnitude(1e-6, 10.0) * wavelength / (half * half);
    return curvature * draw.between(0.1, 3.0);
}

// ---- one dimension of a beam ---------------------------------------------------------------------

// Offset, curvature, half of the beam, wavelength, convergence. `widest` in Fresnel's units of length.
void drawSection(Draw& draw, std::span<float> inputs, double widest) {
    const double wavelength = anyWave(draw), curvature = draw.magnitude(1e-3, 1e3);
    const double unit = std::sqrt(0.5 * wavelength / curvature);
    const double half = unit * draw.magnitude(0.01, widest);
    const double convergence = anyConvergence(draw, curvature, half, wavelength);
    const double image = half * std::abs(1.0 - convergence / curvature);
    const double spread = unit + unit * unit / half;  // of the edges, or of a narrow opening's light
    double offset = draw.sign() * draw.unit() * (image + 10.0 * spread);
    if (draw.oneIn(3)) offset = draw.sign() * image + draw.between(-5.0, 5.0) * spread;
    if (draw.oneIn(8)) offset = draw.among<4>({0.0, -0.0, 1e-45, -1e-38});
    const std::array values{offset, curvature, half, wavelength, convergence};
    std::transform(values.begin(), values.end(), inputs.begin(),
                   [](double v) { return static_cast<float>(v); });
}

void drawEvenSection(Draw& draw, std::span<float> inputs) {
    drawSection(draw, inputs, 300.0);
}
void drawGaussianSection(Draw& draw, std::span<float> inputs) {
    drawSection(draw, inputs, 1e4);
}

// Relative to where the light is strongest: 1, or more in a focus.
Judgement relativeTo(double peak, float got, double expected) {
    const double scale = std::max(peak, 1.0);
    Judgement judgement = compared(got, expected);
    judgement.error /= scale;
    return judgement;
}

Judgement judgeEven(Inputs in, Inputs results) {
    const oracle::Travel travel{in[0], in[1], in[4]};
    const double half = in[2], wavelength = in[3];
    const double expected =
        std::norm(oracle::evenSection(half, travel, wavelength)) * travel.curvature / wavelength;
    const double peak = std::min(4.0 * half * half * travel.curvature / wavelength,
                                 travel.curvature / std::abs(travel.curvature - travel.convergence));
    return relativeTo(peak, results[0], expected);
}

Judgement judgeGaussian(Inputs in, Inputs results) {
    const oracle::Travel travel{in[0], in[1], in[4]};
    const double radius = in[2], wavelength = in[3];
    const double factor = travel.curvature / wavelength;
    const double expected = std::norm(oracle::gaussianSection(radius, travel, wavelength)) * factor;
    const double peak =
        std::norm(oracle::gaussianSection(radius, {0.0, travel.curvature, travel.convergence}, wavelength)) *
        factor;
    return relativeTo(peak, results[0], expected);
}

// ---- a disc --------------------------------------------------------------------------------------

// Offset (x, y), curvature (x, y), radius, wavelength, convergence.
void drawDisc(Draw& draw, std::span<float> inputs) {
    const double wavelength = anyWave(draw), curvatureY = draw.magnitude(1e-2, 1e2);
    const double curvatureX = curvatureY * draw.between(0.3, 1.0);  // beside the axis across the slits
    // Up to where the shader takes the rim for a straight edge.
    const double radius = std::sqrt(draw.magnitude(1e-3, 39.0) * wavelength / curvatureY);
    const double convergence = draw.oneIn(2) ? 0.0 : curvatureY * draw.between(0.0, 1.0);
    const double reach = radius + 2.0 * wavelength / (radius * curvatureY);
    const std::array values{draw.between(-reach, reach),
                            draw.oneIn(4) ? 0.0 : draw.between(-reach, reach),
                            curvatureX,
                            curvatureY,
                            radius,
                            wavelength,
                            convergence};
    std::transform(values.begin(), values.end(), inputs.begin(),
                   [](double v) { return static_cast<float>(v); });
}

Judgement judgeDisc(Inputs in, Inputs results) {
    const double radius = in[4], wavelength = in[5], convergence = in[6];
    const oracle::Travel across{in[0], in[2], convergence}, along{in[1], in[3], convergence};
    const auto sum = [&](const oracle::Travel& x, const oracle::Travel& y) {
        std::complex<double> all = 0.0;
        const auto turnsOf = [&](const oracle::Travel& t) {
            return radius * (radius * std::abs(t.curvature - convergence) + t.curvature * std::abs(t.foot)) /
                   wavelength;
        };
        const double turns = turnsOf(x) + turnsOf(y);
        // y = radius sin(angle): the chords end smoothly there.
        oracle::forNodes(
            -0.5 * pi, 0.5 * pi, 2 + static_cast<std::size_t>(turns), [&](double angle, double weight) {
                const double at = radius * std::sin(angle), chord = radius * std::cos(angle);
                const double way =
                    0.5 * y.curvature * (at - y.foot) * (at - y.foot) - 0.5 * convergence * at * at;
                all += weight * chord * std::polar(1.0, 2.0 * pi * std::fmod(way / wavelength, 1.0)) *
                       oracle::evenSection(chord, x, wavelength);
            });
        return std::norm(all) * x.curvature * y.curvature / (wavelength * wavelength);
    };
    const double expected = sum(across, along);
    const double area = pi * radius * radius;
    const double focused = area * area * across.curvature * along.curvature / (wavelength * wavelength);
    return relativeTo(std::min(focused, 4.0 * across.curvature * along.curvature /
                                            (std::abs(across.curvature - convergence) *
                                             std::abs(along.curvature - convergence))),
                      results[0], expected);
}

// ---- tables --------------------------------------------------------------------------------------

constexpr int kMaskEdge = 4;                                               // columns and rows of its spectrum
constexpr int kMaskStride = kMaskEdge / 2 + 4, kMaskRows = kMaskEdge + 3;  // of its table

int wrapped(int i) {
    return (i % kMaskEdge + kMaskEdge) % kMaskEdge;
}

// Frequencies per um, pixel in um, one unused, and the table of spline coefficients: of any function that is
// even.
void drawMask(Draw& draw, std::span<float> inputs) {
    std::array<std::array<float, kMaskEdge>, kMaskEdge> coefficients{};
    for (int j = 0; j < kMaskEdge; ++j) {
        for (int i = 0; i < kMaskEdge; ++i) {
            const float value = static_cast<float>(draw.unit());
            coefficients[j][i] = coefficients[wrapped(-j)][wrapped(-i)] = value;
        }
    }
    for (int row = 0; row < kMaskRows; ++row) {
        for (int column = 0; column < kMaskStride; ++column)
            inputs[4 + row * kMaskStride + column] = coefficients[wrapped(row - 1)][wrapped(column - 1)];
    }
    const double pixel = draw.magnitude(0.1, 1e3);
    const auto frequency = [&] {
        const double inPixels =
            draw.oneIn(8)   ? draw.among<5>({0.0, -0.0, 1e-40, 0.5, -0.5})
            : draw.oneIn(4) ? std::nearbyint(draw.between(-8.0, 8.0)) / kMaskEdge + draw.between(-1e-6, 1e-6)
                            : draw.sign() * draw.magnitude(1e-6, 100.0);
        return static_cast<float>(inPixels / pixel);
    };
    inputs[0] = frequency();
    inputs[1] = frequency();
    inputs[2] = static_cast<float>(pixel);
    inputs[3] = 0.0F;
}

// The cubic B-spline by its definition as a sum of one-sided cubes.
double bSpline(double x) {
    double sum = 0.0;
    constexpr std::array kBinomials{1.0, -4.0, 6.0, -4.0, 1.0};
    for (int i = 0; i < 5; ++i) sum += kBinomials[i] * std::pow(std::max(x + 2.0 - i, 0.0), 3.0);
    return std::max(sum / 6.0, 0.0);
}

Judgement judgeMask(Inputs in, Inputs results) {
    const double x = double{in[0]} * in[2], y = double{in[1]} * in[2];
    const double column = (x - std::nearbyint(x)) * kMaskEdge, row = -(y - std::nearbyint(y)) * kMaskEdge;
    double sum = 0.0;
    for (int j = -kMaskEdge; j <= kMaskEdge; ++j) {
        for (int i = -kMaskEdge; i <= kMaskEdge; ++i) {
            // Only half of the plane is in the table.
            const bool isMirrored = wrapped(i) > kMaskEdge / 2;
            const int at =
                4 + (wrapped(isMirrored ? -j : j) + 1) * kMaskStride + wrapped(isMirrored ? -i : i) + 1;
            sum += bSpline(column - i) * bSpline(row - j) * in[at];
        }
    }
    return compared(results[0], sum * oracle::slitPattern(x) * oracle::slitPattern(y));
}

constexpr std::size_t kEntries = 6;

// u, width of the window, number of the entry for u = 0, entries per u, number of the first of six entries at
// hand; then these, in halves of words: three running integrals and the slopes.
void drawResponse(Draw& draw, std::span<float> inputs) {
    const double perU = draw.magnitude(50.0, 2e4);
    const double first = std::floor(draw.unit() * 1.9 * perU);
    const double zeroEntry = std::floor(perU * draw.between(0.9, 1.1));
    const double steps = draw.oneIn(4) ? draw.magnitude(1e-6, 1.0) : draw.between(0.0, 3.0);
    double place = draw.between(0.0, 5.0);
    if (draw.oneIn(4)) place = std::nearbyint(place);
    inputs[2] = static_cast<float>(zeroEntry);
    inputs[3] = static_cast<float>(perU);
    inputs[4] = static_cast<float>(first);
    // The window has to stay among the entries at hand.
    const double reach = 0.5 * std::max(steps, 1.0) + 0.01;
    place = std::clamp(place, reach, 4.98 - reach);
    inputs[0] = static_cast<float>((first + place - zeroEntry) / inputs[3]);
    inputs[1] = static_cast<float>(steps / inputs[3]);

    // Responses at the entries: linear between them, so their integral is the trapezium's.
    std::array<std::uint64_t, 3> integral{};
    std::array<std::array<std::int64_t, 3>, kEntries> response{};
    for (auto& entry : response)
        for (std::int64_t& value : entry) value = 2 * static_cast<std::int64_t>(draw.between(0.0, 1e6));
    const std::uint32_t shift = 13;  // slopes of up to 2e6 in nine bits
    for (std::uint64_t& start : integral) start = static_cast<std::uint64_t>(draw.between(0.0, 2e9));
    for (std::size_t k = 0; k < kEntries; ++k) {
        std::uint32_t slopes = shift << 27;
        for (std::size_t c = 0; c < 3; ++c) {
            if (k + 1 < kEntries) {
                const std::int64_t slope = (response[k + 1][c] - response[k][c]) >> shift;
                slopes |= (static_cast<std::uint32_t>(slope) & 0x1ffU) << (9 * c);
            }
            const auto word = static_cast<std::uint32_t>(integral[c]);
            inputs[5 + 8 * k + 2 * c] = static_cast<float>(word >> 16);
            inputs[6 + 8 * k + 2 * c] = static_cast<float>(word & 0xffffU);
            if (k + 1 < kEntries)
                integral[c] += static_cast<std::uint64_t>((response[k][c] + response[k + 1][c]) / 2);
        }
        inputs[11 + 8 * k] = static_cast<float>(slopes >> 16);
        inputs[12 + 8 * k] = static_cast<float>(slopes & 0xffffU);
    }
}

std::uint32_t wordAt(Inputs in, std::size_t i) {
    return static_cast<std::uint32_t>(in[i]) << 16 | static_cast<std::uint32_t>(in[i + 1]);
}

// Integral up to a place of the response that the entries describe, in one channel, less that up to the first
// of them.
double integralTo(Inputs in, double place, std::size_t channel) {
    const auto k = static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, 4.0));
    const double f = place - static_cast<double>(k);
    const double before = double{1.0} * (wordAt(in, 5 + 8 * k + 2 * channel) - wordAt(in, 5 + 2 * channel));
    const double step =
        double{1.0} * (wordAt(in, 13 + 8 * k + 2 * channel) - wordAt(in, 5 + 8 * k + 2 * channel));
    const std::uint32_t packed = wordAt(in, 11 + 8 * k);
    auto slope = static_cast<std::int32_t>(packed >> (9 * channel) & 0x1ffU);
    if (slope >= 256) slope -= 512;
    const double change = std::ldexp(slope, static_cast<int>(packed >> 27));
    // From r to r + change in a step, with the mean `step`.
    const double start = step - 0.5 * change;
    return before + f * start + 0.5 * f * f * change;
}

// Relative to the largest mean of a step at hand.
Judgement judgeResponse(Inputs in, Inputs results) {
    const double place = double{in[0]} * in[3] + in[2] - in[4], steps = std::max(double{in[1]} * in[3], 1.0);
    Judgement worst{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        double peak = 0.0;
        for (std::size_t k = 0; k < 5; ++k)
            peak = std::max(peak, integralTo(in, k + 1.0, channel) - integralTo(in, k, channel));
        const double mean =
            (integralTo(in, place + 0.5 * steps, channel) - integralTo(in, place - 0.5 * steps, channel)) /
            steps;
        Judgement judgement = compared(results[channel], mean);
        // What the rounding of u's own place in the table does is the table's resolution, not an error of its
        // reader.
        judgement.error /= peak;
        if (judgement.error >= worst.error) worst = judgement;
    }
    return worst;
}

// ---- orders of slits -----------------------------------------------------------------------------

// Order, wavelength and period in um, incoming cosines, half of the beam, offset, and the window that the
// sample averages over, which is so wide that no ripple shows.
void drawOrder(Draw& draw, std::span<float> inputs) {
    const double wavelength_um = draw.between(0.38, 0.78), period_um = draw.magnitude(0.2, 1e4);
    const double alphaIn = draw.oneIn(3) ? 0.0 : draw.between(-0.7, 0.7),
                 betaIn = draw.oneIn(3) ? 0.0 : draw.between(-0.7, 0.7);
    const double order = std::nearbyint(draw.between(-1.0, 1.0) * period_um / wavelength_um);
    const double z = draw.magnitude(1e-3, 1e3);
    const double alpha = alphaIn + order * wavelength_um / period_um;
    const double gamma = std::sqrt(std::max(1.0 - alpha * alpha - betaIn * betaIn, 0.01));
    const double range = z / gamma;
    const double window = range * draw.between(0.02, 0.05) + 30.0 * std::sqrt(1e-6 * wavelength_um * range);
    const double half = window * draw.magnitude(0.6, 10.0);
    inputs[0] = static_cast<float>(order);
    inputs[1] = static_cast<float>(wavelength_um);
    inputs[2] = static_cast<float>(period_um);
    inputs[3] = static_cast<float>(alphaIn);
    inputs[4] = static_cast<float>(betaIn);
    inputs[5] = static_cast<float>(half);
    inputs[6] = static_cast<float>(range * alpha + draw.between(-1.5, 1.5) * half);
    inputs[7] = static_cast<float>(range * betaIn + draw.between(-1.5, 1.5) * half);
    inputs[8] = static_cast<float>(z);
    inputs[9] = static_cast<float>(window);
}

// The share of a window about `at` that lies within `half` of 0.
double covered(double at, double window, double half) {
    return std::max(std::min(at + 0.5 * window, half) - std::max(at - 0.5 * window, -half), 0.0) / window;
}

// Geometry: traced back along the order's direction, how much of the window lies in the beam. Near the plane
// of the slits the direction itself is lost to the rounding of what is given: judged for what leaves more
// than 0.1 steeply.
Judgement judgeOrder(Inputs in, Inputs results) {
    const double alpha = in[3] + double{in[0]} * in[1] / in[2], beta = in[4];
    const double gamma2 = 1.0 - alpha * alpha - beta * beta;
    if (gamma2 <= 0.0) return compared(results[0], gamma2 > -1e-5 ? results[0] : 0.0);
    if (gamma2 < 0.01) return compared(results[0], results[0]);
    const double gamma = std::sqrt(gamma2), range = in[8] / gamma;
    const double footX = in[6] - range * alpha, footY = in[7] - range * beta;
    return compared(results[0], covered(footX, in[9], in[5]) * covered(footY, in[9], in[5]));
}

}  // namespace

std::vector<StressCase> beamCases() {
    const std::span<const std::uint32_t> shader(stress_beams_comp);
    const std::vector<std::string_view> section{"offset", "curvature", "half", "wavelength", "convergence"},
        disc{"x", "y", "curvature_x", "curvature_y", "radius", "wavelength", "convergence"},
        order{"order", "wavelength_um", "period_um", "alpha_in", "beta_in", "half", "x", "y", "z", "window"};
    std::vector<std::string_view> mask{"fx", "fy", "pixel", "-"};
    mask.insert(mask.end(), std::size_t{kMaskStride} * kMaskRows, "entry");
    std::vector<std::string_view> response{"u", "width", "zero_entry", "per_u", "first_entry"};
    response.insert(response.end(), 8 * kEntries, "half_word");
    return {
        {"footprint", "footprint of an even beam, beam.glsl", 2e-4,
         "places among 600 of Fresnel's units round to 3e-5 of one, at either edge; at the focus, where the "
         "light counts as in "
         "it, a phase of 5e-3 half turns",
         shader, 0, section, 1, drawEvenSection, judgeEven, kFullCount},
        {"gaussian-footprint", "footprint of a Gaussian beam, beam.glsl", 2e-6, "roundings, ten of 1e-7",
         shader, 1, section, 1, drawGaussianSection, judgeGaussian, kFullCount},
        {"disc-footprint", "discFootprint, beam.glsl", 1e-3,
         "Gauss-Chebyshev nodes as many as the phase's turns times 3.2, and 12", shader, 2, disc, 1, drawDisc,
         judgeDisc, 2'000'000},
        {"mask", "maskPattern, masks.glsl", 2e-6, "weights of splines and their sum, roundings; sines, 4e-7",
         shader, 3, mask, 1, drawMask, judgeMask, 10'000'000},
        {"response", "meanResponse, slits.glsl", 1e-2,
         "a place among 20,000 entries rounds to 1e-3 of a step, and these responses change by all of their "
         "peak in "
         "one; real ones by some hundredths",
         shader, 4, response, 3, drawResponse, judgeResponse, kFullCount},
        {"order", "orderIrradiance, slits.glsl", 1e-3,
         "the order's sine rounds to 1.5e-7, its foot to range / cosine^2 of that: 8e-4 of the narrowest "
         "window at the "
         "steepest",
         shader, 5, order, 1, drawOrder, judgeOrder, kFullCount},
    };
}

}  // namespace fringe::qualify
