// Gratings for the tests of the reference renderer, at the origin unless a test moves them: x across the
// slits, y along them, light towards +z.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace fringe::oracle {

// One watt that falls on `aperture` straight from behind.
inline scene::Grating lit(const optics::Aperture& aperture, scene::BeamProfile profile,
                          units::Length diameter) {
    scene::Grating grating{};
    grating.normal = {0.0, 0.0, 1.0};
    grating.slitDirection = {0.0, 1.0, 0.0};
    grating.aperture = aperture;
    grating.beam = {profile, diameter, diameter, {0.0, 0.0, 1.0}, 1.0 * units::W, 0.0 * units::rad, {}};
    return grating;
}

// Direction of a beam with these direction cosines.
inline glm::dvec3 towards(double alpha, double beta) {
    return {alpha, beta, std::sqrt(1.0 - alpha * alpha - beta * beta)};
}

}  // namespace fringe::oracle
