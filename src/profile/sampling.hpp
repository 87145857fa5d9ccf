// A profile as a picture: the scene whose picture is a line on a surface of another scene.
#pragma once

#include <cstdint>

#include "profile/surface.hpp"

namespace fringe::profile {

// The line from left to right as a picture of `samples` x 1 pixels, seen perpendicularly from just above the
// surface. A pixel is as wide as its share of the line, and square. Every surface that does not glow is
// white, so that nothing but the light on it shows. Throws LineError where a light has no irradiance.
scene::Scene lineScene(scene::Scene scene, const SurfaceLine& line, std::uint32_t samples);

}  // namespace fringe::profile
