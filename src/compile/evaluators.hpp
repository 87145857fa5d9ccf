// Which way the device takes to the colour of slits: its cost, memory and error, and the choice between them
// (docs/theory.md, "Evaluators"; the ways themselves are in shaders/evaluators.glsl).
#pragma once

#include <cstdint>
#include <string>

#include "compile/interface.hpp"
#include "compile/spectral.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

// Slits that cover more than 40 um are wide: the undeviated light is then followed apart from the orders, and
// with it the near field across the slits. Below, the far field holds to 2e-3 from 0.15 m on (Fresnel number
// 0.005).
bool areWide(const optics::Slits& slits);

struct EvaluatorChoice {
    device::uint evaluator;        // TABLE_EVALUATOR, ... of shaders/interface.h
    device::uint wavelengths = 0;  // that a sum goes over
    double stepsPerU = 0.0;        // of a table
    double error = 0.0;            // estimated, relative to the pattern's highest value
    double cost = 0.0;             // estimated, in look-ups of a table
    std::uint64_t bytes = 0;       // on the device
    std::string reason;
};

// For a continuous spectrum; lines are always followed one by one. What the scene leaves open ("auto") is the
// cheapest way whose estimated error is within `tolerance`, where one is; the reason says so where none is.
EvaluatorChoice chooseEvaluator(const scene::Grating& grating, const optics::Slits& slits,
                                const optics::Spectrum& spectrum, ResponseRows rows, double tolerance);

// As scene files call it.
const char* nameOf(device::uint evaluator);

}  // namespace fringe::compile
