// Far fields of apertures and Fresnel's edges, relative to a peak of 1. Inputs lie where such formulas break:
// at 0, at and next to the exact orders, at grazing incidence, with one slit and a million, periods far below
// and far above the wavelength, denormal numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "oracle/exact_pattern.hpp"
#include "oracle/section.hpp"
#include "qualify/cases.hpp"
#include "shaders/stress_patterns.comp.h"

namespace fringe::qualify {
namespace {

using glm::dvec2;
using Inputs = std::span<const float>;

// No aperture is wider than this, in wavelengths: 150 m of green light. Turns of two floats are right to
// 2^-48 of them, so a million slits agree on their phases to 4e-6 of a turn.
constexpr double kWidest = 3e8;

double signedMagnitude(Draw& draw, double low, double high) {
    return draw.sign() * draw.magnitude(low, high);
}

// 0, denormals, and what is nearly so.
double nearZero(Draw& draw) {
    return draw.oneIn(4) ? draw.among<4>({0.0, -0.0, 1e-45, -1e-38}) : signedMagnitude(draw, 1e-44, 1e-3);
}

// A difference of two direction cosines.
double anyCosine(Draw& draw) {
    return draw.oneIn(8) ? draw.among<6>({2.0, -2.0, 1.0, -1.0, 0x1.fffffep-1, -0x1.fffffep0})
                         : draw.between(-2.0, 2.0);
}

double anyCount(Draw& draw, double most) {
    if (draw.oneIn(8)) return 1.0;
    if (draw.oneIn(8)) return std::floor(most);
    return std::max(1.0, std::nearbyint(draw.magnitude(1.0, most)));
}

// Where the slits of this period have an order, or a few of their fringes beside it.
double nearOrder(Draw& draw, double period, double count) {
    const double last = std::floor(2.0 * period);
    const double order = std::nearbyint(draw.between(-last, last));
    const double beside = draw.oneIn(3) ? 0.0 : draw.between(-3.0, 3.0) / count;
    return std::clamp((order + beside) / period, -2.0, 2.0);
}

double cosineFor(Draw& draw, double period, double count) {
    if (draw.oneIn(10)) return nearZero(draw);
    return draw.oneIn(2) ? nearOrder(draw, period, count) : anyCosine(draw);
}

void drawTurns(Draw& draw, std::span<float> inputs) {
    inputs[0] = static_cast<float>(draw.oneIn(8)   ? nearZero(draw)
                                   : draw.oneIn(4) ? std::nearbyint(signedMagnitude(draw, 1.0, 1e7)) +
                                                         draw.between(-0.01, 0.01)
                                                   : signedMagnitude(draw, 1e-6, 1e30));
}

void drawTurnsAndCount(Draw& draw, std::span<float> inputs) {
    const double count = anyCount(draw, 1e6);
    inputs[1] = static_cast<float>(count);
    const double order = std::nearbyint(signedMagnitude(draw, 0.3, 1e6));
    inputs[0] = static_cast<float>(draw.oneIn(8)   ? nearZero(draw)
                                   : draw.oneIn(2) ? order + draw.between(-3.0, 3.0) / count
                                                   : signedMagnitude(draw, 1e-6, 1e6));
}

// u, width, period (high, low) in wavelengths, count.
void drawSlits(Draw& draw, std::span<float> inputs) {
    const double period = draw.magnitude(0.02, 2.5e5);
    const double count = anyCount(draw, std::min(1e6, kWidest / period));
    inputs[0] = static_cast<float>(cosineFor(draw, period, count));
    inputs[1] = static_cast<float>(period * draw.between(0.01, 0.99));
    inputs[2] = static_cast<float>(period);
    inputs[3] = static_cast<float>(period - double{inputs[2]});
    inputs[4] = static_cast<float>(count);
}

double slits(Inputs in) {
    const double turns = oracle::turnsPast(in[0], in[2], in[3]);
    return oracle::slitPattern(double{in[0]} * in[1]) * oracle::arrayPattern(turns, in[4]);
}

// u, v, width, height in wavelengths.
void drawRectangle(Draw& draw, std::span<float> inputs) {
    for (std::size_t i : {0U, 1U}) {
        const double size = draw.magnitude(0.01, 1e6);
        inputs[i] = static_cast<float>(cosineFor(draw, size, 1.0));
        inputs[2 + i] = static_cast<float>(size);
    }
}

double rectanglePattern(Inputs in) {
    return oracle::slitPattern(double{in[0]} * in[2]) * oracle::slitPattern(double{in[1]} * in[3]);
}

// Diameter times frequency; the shader has a seam at 1.25.
void drawAiry(Draw& draw, std::span<float> inputs) {
    inputs[0] = static_cast<float>(draw.oneIn(8)   ? std::abs(nearZero(draw))
                                   : draw.oneIn(8) ? draw.between(1.2499, 1.2501)
                                                   : draw.magnitude(1e-4, 1e7));
    inputs[1] = static_cast<float>(draw.oneIn(4) ? draw.magnitude(1e-6, 0.1) : draw.between(0.0, 0.99));
}

// Two edges in Fresnel's unit of length.
void drawStrip(Draw& draw, std::span<float> inputs, double farthest) {
    const double place = draw.oneIn(8) ? nearZero(draw) : signedMagnitude(draw, 1e-3, farthest);
    const double other =
        draw.oneIn(3) ? signedMagnitude(draw, 1e-3, farthest) : place + draw.magnitude(1e-5, 10.0);
    inputs[0] = static_cast<float>(place);
    inputs[1] = static_cast<float>(std::min(other, farthest));
}

void drawNearStrip(Draw& draw, std::span<float> inputs) {
    drawStrip(draw, inputs, 32.0);
}
void drawAnyStrip(Draw& draw, std::span<float> inputs) {
    drawStrip(draw, inputs, 1e5);
}

double strip(Inputs in) {
    return 0.5 * std::norm(oracle::fresnelIntegral(in[1]) - oracle::fresnelIntegral(in[0]));
}

constexpr std::size_t kCorners = 6;

// u, v, wavenumber per um, area, and corners in um, which are drawn by their angles and distances from the
// middle; the middle is not quite the centroid, which the shader does not ask for.
void drawCorners(Draw& draw, std::span<float> inputs, bool isSymmetric) {
    const double size = draw.magnitude(0.01, 3000.0);
    std::array<dvec2, kCorners> corners;
    double area = 0.0;
    for (std::size_t i = 0; i < kCorners; ++i) {
        const double angle = std::numbers::pi / 3.0 * (static_cast<double>(i) + draw.between(-0.4, 0.4));
        corners[i] = size * draw.between(0.3, 1.0) * dvec2(std::cos(angle), std::sin(angle));
        if (isSymmetric && i >= kCorners / 2) corners[i] = -corners[i - kCorners / 2];
        inputs[4 + 2 * i] = static_cast<float>(corners[i].x);
        inputs[5 + 2 * i] = static_cast<float>(corners[i].y);
    }
    for (std::size_t i = 0; i < kCorners; ++i) {
        const std::size_t next = 4 + 2 * ((i + 1) % kCorners), here = 4 + 2 * i;
        area += 0.5 * (double{inputs[here]} * inputs[next + 1] - double{inputs[here + 1]} * inputs[next]);
    }
    const double wavenumber = 1.0 / draw.between(0.38, 0.78);
    const double peak = 1.0 / (size * wavenumber);
    dvec2 uv(anyCosine(draw), anyCosine(draw));
    if (draw.oneIn(2)) uv = peak * dvec2(draw.between(-3.0, 3.0), draw.between(-3.0, 3.0));
    if (draw.oneIn(8)) uv = dvec2(nearZero(draw), nearZero(draw));
    // Along the normal of an edge, where its phase stands still.
    if (draw.oneIn(8))
        uv = dvec2(corners[1].y - corners[0].y, corners[0].x - corners[1].x) / size * draw.unit();
    inputs[0] = static_cast<float>(uv.x);
    inputs[1] = static_cast<float>(uv.y);
    inputs[2] = static_cast<float>(wavenumber);
    inputs[3] = static_cast<float>(area);
}

void drawPolygon(Draw& draw, std::span<float> inputs) {
    drawCorners(draw, inputs, false);
}
void drawSymmetricPolygon(Draw& draw, std::span<float> inputs) {
    drawCorners(draw, inputs, true);
}

double polygon(Inputs in) {
    std::array<dvec2, kCorners> corners;
    for (std::size_t i = 0; i < kCorners; ++i) corners[i] = dvec2(in[4 + 2 * i], in[5 + 2 * i]);
    return oracle::polygonPattern(corners, double{in[2]} * dvec2(in[0], in[1]));
}

// u, v, wavenumber per um, two steps in um (x, y high, x, y low), two counts.
void drawLattice(Draw& draw, std::span<float> inputs) {
    const double wavenumber = 1.0 / draw.between(0.38, 0.78);
    std::array<dvec2, 2> step;
    std::array<double, 2> count;
    const double angle = draw.between(0.0, 2.0 * std::numbers::pi);
    for (std::size_t i : {0U, 1U}) {
        const double size = draw.magnitude(0.02, 1e4);
        const double turned = angle + (i == 0 ? 0.0 : draw.between(0.3, 2.8));
        step[i] = size * (draw.oneIn(2) ? (i == 0 ? dvec2(1.0, 0.0) : dvec2(0.0, 1.0))
                                        : dvec2(std::cos(turned), std::sin(turned)));
        count[i] = anyCount(draw, std::min(1e6, 0.1 * kWidest / (size * wavenumber)));
        for (std::size_t k : {0U, 1U}) {
            const auto component = static_cast<int>(k);
            const std::size_t at = 3 + 4 * i + k;
            inputs[at] = static_cast<float>(step[i][component]);
            inputs[at + 2] = static_cast<float>(step[i][component] - double{inputs[at]});
        }
        inputs[11 + i] = static_cast<float>(count[i]);
    }
    const double determinant = step[0].x * step[1].y - step[0].y * step[1].x;
    dvec2 uv(anyCosine(draw), anyCosine(draw));
    if (draw.oneIn(10)) uv = dvec2(nearZero(draw), nearZero(draw));
    if (std::abs(determinant) > 0.0 && draw.oneIn(2)) {
        // Next to an order of both rows.
        std::array<double, 2> turns;
        for (std::size_t i : {0U, 1U}) {
            const auto axis = static_cast<int>(i);
            turns[i] = std::nearbyint(glm::dot(uv, step[i]) * wavenumber) +
                       (axis == 0 && draw.oneIn(3) ? 0.0 : draw.between(-3.0, 3.0) / count[i]);
        }
        uv = dvec2(turns[0] * step[1].y - turns[1] * step[0].y, turns[1] * step[0].x - turns[0] * step[1].x) /
             (determinant * wavenumber);
    }
    inputs[0] = static_cast<float>(std::clamp(uv.x, -2.0, 2.0));
    inputs[1] = static_cast<float>(std::clamp(uv.y, -2.0, 2.0));
    inputs[2] = static_cast<float>(wavenumber);
}

// 64 bits of a long double hold the turns of a row to 1e-14.
double lattice(Inputs in) {
    double product = 1.0;
    for (std::size_t i : {0U, 1U}) {
        long double way = 0.0L;
        for (std::size_t k : {0U, 1U}) {
            const std::size_t at = 3 + 4 * i + k;
            way += static_cast<long double>(in[k]) * in[at] + static_cast<long double>(in[k]) * in[at + 2];
        }
        const long double turns = way * in[2];
        product *= oracle::arrayPattern(static_cast<double>(turns - std::nearbyint(turns)), in[11 + i]);
    }
    return product;
}

template <double expected(Inputs)>
Judgement judged(Inputs inputs, Inputs results) {
    return compared(results[0], expected(inputs));
}

double slit(Inputs in) {
    return oracle::slitPattern(in[0]);
}
double row(Inputs in) {
    const double turns = in[0];
    return oracle::arrayPattern(turns - std::nearbyint(turns), in[1]);
}
double airyPattern(Inputs in) {
    return oracle::discPattern(in[0]);
}
double ringPattern(Inputs in) {
    return oracle::discPattern(in[0], in[1]);
}

constexpr std::string_view kSines =
    "sinPiOverX errs by 2e-7 of the amplitude, 4e-7 of the intensity; roundings";
constexpr std::uint64_t kBillion = 1'000'000'000;

}  // namespace

std::vector<StressCase> patternCases() {
    const std::span<const std::uint32_t> shader(stress_patterns_comp);
    const std::vector<std::string_view> turns{"x"}, row_{"t", "count"},
        slits_{"u", "width", "period", "period_low", "count"}, rectangle_{"u", "v", "width", "height"},
        disc_{"x", "inner"}, strip_{"from", "to"},
        polygon_{"u",  "v",  "wavenumber", "area", "x0", "y0", "x1", "y1",
                 "x2", "y2", "x3",         "y3",   "x4", "y4", "x5", "y5"},
        lattice_{"u",  "v",  "wavenumber", "x1",     "y1",     "x1_low", "y1_low",
                 "x2", "y2", "x2_low",     "y2_low", "count1", "count2"};
    return {
        {"slit", "slitFactor, phase.glsl", 1e-6, kSines, shader, 0, turns, 1, drawTurns, judged<slit>,
         kFullCount},
        {"array", "arrayFactor, phase.glsl", 1e-6, kSines, shader, 1, row_, 1, drawTurnsAndCount, judged<row>,
         kFullCount},
        {"slits", "slitsPattern, apertures.glsl", 5e-6,
         "sines, 1e-6; turns of two floats, 2^-48 of 6e8 turns between the outer slits", shader, 2, slits_, 1,
         drawSlits, judged<slits>, kBillion},
        {"slits-as-printed",
         "the thesis's formula in radians by the driver's sine",
         {},
         "0/0 at every order and at 0, and noise beside them",
         shader,
         3,
         slits_,
         1,
         drawSlits,
         judged<slits>,
         kFullCount},
        {"rectangle", "slitFactor of both sides, phase.glsl", 1e-6, kSines, shader, 4, rectangle_, 1,
         drawRectangle, judged<rectanglePattern>, kFullCount},
        {"circle", "circlePattern, apertures.glsl", 1e-6, "airyAmplitude errs by 3e-7 of the amplitude",
         shader, 5, disc_, 1, drawAiry, judged<airyPattern>, kFullCount},
        {"ring", "ringPattern, apertures.glsl", 5e-5,
         "two discs, 3e-7 of the amplitude each, over 1 - 0.99^2", shader, 6, disc_, 1, drawAiry,
         judged<ringPattern>, kFullCount},
        {"edges", "stripIntensity, fresnel.glsl", 5e-6,
         "fresnelAuxiliary errs by 5e-7 of the amplitude, twice", shader, 7, strip_, 1, drawNearStrip,
         judged<strip>, kFullCount},
        {"far-edges", "stripIntensity, fresnel.glsl", 5e-4,
         "from 4600 on the phase pi x^2/2 is lost to the rounding of x; the wave is sqrt(2)/(pi x) then, "
         "twice",
         shader, 7, strip_, 1, drawAnyStrip, judged<strip>, kFullCount},
        {"polygon", "polygonPattern, apertures.glsl", 2e-5,
         "3e-7 of the amplitude times perimeter radius / area", shader, 10, polygon_, 1, drawPolygon,
         judged<polygon>, kFullCount},
        {"symmetric-polygon", "pairOfEdges, apertures.glsl", 2e-5,
         "3e-7 of the amplitude times perimeter radius / area", shader, 11, polygon_, 1, drawSymmetricPolygon,
         judged<polygon>, kFullCount},
        {"lattice", "wayPerCell and fejer, phase.glsl", 5e-6, "as for slits, with a sum of two ways", shader,
         20, lattice_, 1, drawLattice, judged<lattice>, kFullCount},
    };
}

}  // namespace fringe::qualify
