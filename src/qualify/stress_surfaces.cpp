// Reflectance of glass and metals, out of 1.
#include <algorithm>
#include <cmath>
#include <complex>

#include "oracle/fresnel.hpp"
#include "qualify/cases.hpp"
#include "shaders/stress_surfaces.comp.h"

namespace fringe::qualify {
namespace {

using Inputs = std::span<const float>;

// Of the angle of incidence: any, grazing, perpendicular.
double anyIncidence(Draw& draw) {
    if (draw.oneIn(3)) return draw.among<5>({0.0, 1e-45, 1e-38, 0x1.fffffep-1, 1.0});
    return draw.oneIn(2) ? draw.magnitude(1e-12, 1.0) : draw.unit();
}

void drawDielectric(Draw& draw, std::span<float> inputs) {
    double index = draw.oneIn(4) ? 1.0 + draw.sign() * draw.magnitude(1e-7, 1e-2) : draw.magnitude(0.2, 5.0);
    if (draw.oneIn(10)) index = 1.0;
    double cosine = anyIncidence(draw);
    // About the angle of total reflection.
    if (index < 1.0 && draw.oneIn(3))
        cosine = std::clamp(std::sqrt(1.0 - index * index) * (1.0 + draw.sign() * draw.magnitude(1e-8, 0.1)),
                            0.0, 1.0);
    inputs[0] = static_cast<float>(cosine);
    inputs[1] = static_cast<float>(index);
}

// At the angle of total reflection results have a vertical tangent, and it is the index that leaves them
// open: they may be those of any index within two roundings of the given one, each half a unit in the last
// place. In between, an index of 1 reflects least.
template <class Function>
Judgement judgedNear(float got, double index, Function function) {
    constexpr double kTwoRoundings = 0x1p-22;
    const double less = index * (1.0 - kTwoRoundings), more = index * (1.0 + kTwoRoundings);
    const double exact = function(index);
    const auto [low, high] =
        std::minmax({exact, function(less), function(more), function(std::clamp(1.0, less, more))});
    Judgement judgement = compared(got, exact);
    judgement.error = std::max({low - double{got}, double{got} - high, 0.0});
    return judgement;
}

Judgement judgeDielectric(Inputs in, Inputs results) {
    const double cosine = in[0];
    const Judgement reflected =
        judgedNear(results[0], in[1], [&](double index) { return oracle::reflectance(cosine, index); });
    const Judgement transmitted = judgedNear(results[1], in[1], [&](double index) {
        return std::sqrt(std::max(1.0 - (1.0 - cosine * cosine) / (index * index), 0.0));
    });
    return reflected.error >= transmitted.error ? reflected : transmitted;
}

void drawConductor(Draw& draw, std::span<float> inputs) {
    inputs[0] = static_cast<float>(anyIncidence(draw));
    inputs[1] = static_cast<float>(draw.magnitude(0.01, 20.0));
    inputs[2] = static_cast<float>(draw.oneIn(8) ? 0.0 : draw.magnitude(1e-4, 40.0));
}

Judgement judgeConductor(Inputs in, Inputs results) {
    return judgedNear(results[0], in[1],
                      [&](double n) { return oracle::reflectance(in[0], std::complex<double>(n, in[2])); });
}

}  // namespace

std::vector<StressCase> surfaceCases() {
    return {
        {"dielectric",
         "fresnelDielectric, materials.glsl",
         1e-6,
         "a dozen roundings, with the index known to one",
         stress_surfaces_comp,
         0,
         {"cosine", "index"},
         2,
         drawDielectric,
         judgeDielectric,
         kFullCount},
        {"conductor",
         "fresnelConductor, materials.glsl",
         1e-6,
         "two dozen roundings",
         stress_surfaces_comp,
         1,
         {"cosine", "n", "k"},
         1,
         drawConductor,
         judgeConductor,
         kFullCount},
    };
}

}  // namespace fringe::qualify
