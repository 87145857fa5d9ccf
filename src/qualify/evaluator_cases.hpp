// The slits that their evaluators are benchmarked on: from one to a million, fine and coarse, in lines and in
// continuous light.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "optics/aperture.hpp"
#include "optics/spectrum.hpp"

namespace fringe::qualify {

// Slits seen through windows of u as wide as a pixel of 0.2 mm a metre away.
struct EvaluatorCase {
    std::string_view name;
    std::uint32_t count;
    double width_um;
    double period_um;
    optics::Spectrum spectrum;
    double largestSine;        // of the angles at which light leaves, to either side
    double incoming = 0.0;     // direction cosine of the beam across the slits
    bool isWidelyLit = false;  // beyond the outermost slits: a few coarse ones are then added up pair by pair
};

std::span<const EvaluatorCase> evaluatorCases();

optics::Slits slitsOf(const EvaluatorCase& which);
bool hasContinuum(const EvaluatorCase& which);

// Whether the undeviated light is followed apart from the evaluators (shaders/slits.glsl): wherever it is
// nearer to u = 0 than this; 0: nowhere.
double undeviatedUpTo(const EvaluatorCase& which);

}  // namespace fringe::qualify
