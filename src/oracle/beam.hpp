// The beam that falls on a grating, in the grating's frame: x across the slits, y along them, z the outgoing
// normal. A reflected beam is its mirror image behind the grating.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace fringe::oracle {

// Power per area where the light is strongest, on the plane of the grating, for one watt of the beam. Its
// width and height are those of the light on that plane.
double peakIrradiance(const scene::Beam& beam);

// The irradiance at (x, y) over that at the middle.
double relativeIrradiance(const scene::Beam& beam, double x, double y);

// Half of the line |y| < h at `x` on which light falls: 0 beside the beam. A Gaussian beam has no end, and is
// cut off where 2e-8 of it is left across the slits and not at all along them.
double halfChord(const scene::Beam& beam, double x);

// The wavefront on a line of constant x: how much longer the way to the grating is than to its middle.
struct Front {
    double way;          // metres, at y = 0
    double alpha;        // direction cosine across the slits, at y = 0
    double beta;         // along them: slope of the way with y
    double convergence;  // 1 / metres: the slope falls by this per metre
};

// `incident` are the direction cosines of the beam's axis. Towards the focus, where there is one, the ways
// are exact at y = 0, and to second order beyond.
Front frontAt(const scene::Beam& beam, const glm::dvec2& incident, double x);

}  // namespace fringe::oracle
