// Ways of moving a camera. Pure functions; all keep the direction that is up and what the lens is like.
#pragma once

#include "scene/scene.hpp"

namespace fringe::preview {

// Around the target, by angles in radians: to the right, and up; never over the poles.
scene::Camera orbited(scene::Camera camera, double right, double up);

// Camera and target together, sideways, so that what is at the target moves by so much of the picture's
// height: `right` and `up` of what is seen.
scene::Camera panned(scene::Camera camera, double right, double up);

// To the target, or away from it: its distance times `factor` (an orthographic picture shows that much more).
scene::Camera dollied(scene::Camera camera, double factor);

// Camera and target together, by metres along the camera's own axes.
scene::Camera flown(scene::Camera camera, const glm::dvec3& rightUpForward);

// Looking at the same target from the same distance, along an axis of the scene.
enum class Side { front, back, left, right, top, bottom };
scene::Camera seenFrom(scene::Camera camera, Side side);

}  // namespace fringe::preview
