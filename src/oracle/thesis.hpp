// The original algorithm, with its faults: A. J. Watson, "Diffraction Gratings in Ray Tracing", MSc thesis,
// UC San Diego, 2009, section "Code". docs/thesis-algorithm.md sets the faults out.
//
// Where a listing is 0/0, Faults::limit gives the value its neighbourhood tends to, and is finite everywhere;
// Faults::asPrinted takes the listing's own steps, in double precision, and gives the NaN that they give.
#pragma once

#include <array>

#include "oracle/ray.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

// Metres; what the listing calls red, green and blue light.
inline constexpr std::array<double, 3> kPrintedWavelengths{450e-9, 550e-9, 700e-9};

// Intensity of `slits` towards a deviation of sine `sine`, relative to one slit's straight ahead, each
// channel clamped at 1. Finite everywhere. Takes time in proportion to the number of slits.
scene::Rgb limitIntensity(double sine, const scene::Slits& slits);

// The same as the listing has it: NaN where it is 0/0, or where `sine` is.
scene::Rgb printedIntensity(double sine, const scene::Slits& slits);

// What a grating adds to the picture at `point`, but for its colour, its power and shadows: 0 on its back and
// outside the band of its beam. It may be NaN as the listing has it.
scene::Rgb gratingValue(const scene::ThesisGrating& grating, const dvec3& point);

// The pattern of the disc at `point` seen along the unit vector `view`, but for the light's colour. At the
// very centre of a disc without a hole, where the listing has no direction to go by, the limit is that of
// sine 0.
scene::Rgb discPattern(const scene::ThesisDisc& material, const scene::Disc& disc, const dvec3& point,
                       const dvec3& view);

}  // namespace fringe::oracle
