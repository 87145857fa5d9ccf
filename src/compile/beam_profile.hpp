// Whether a Gaussian beam is uneven across an opening, and whether what is shown knows it.
#pragma once

#include <optional>

#include "scene/scene.hpp"

namespace fringe::compile {

// By what share of that in the middle a Gaussian beam's irradiance is less at the opening's rim; 0 for other
// beams.
double fallToRim(const scene::Grating& grating);

struct UnevenBeam {
    double width;  // the Gaussian beam's 1/e^2 diameter in metres
    bool isWhole;  // all of it passes, and it is a Gaussian beam at any distance
};

// Of a beam whose profile goes into what is shown; nothing where the opening is lit evenly: because it is so
// to 1e-3 of the pattern's peak, and in lattices of too many cells (litCells()). `fresnelNumber`: at the
// nearest surface that it lights.
std::optional<UnevenBeam> profileAcross(const scene::Grating& grating, double fresnelNumber);

}  // namespace fringe::compile
