// From a place in the window to the surface that is seen there, and back.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>

#include "scene/scene.hpp"

namespace fringe::preview {

// Places in the picture are pixels of its full size from the upper left corner, x to the right and y down.
struct Pick {
    std::size_t object;  // index into Scene::objects
    glm::dvec3 point;
    glm::dvec3 normal;  // unit, towards the camera
};

// The nearest surface on the ray through the middle of the lens; nothing where there is none or a light is
// nearer.
std::optional<Pick> pickAt(const scene::Scene& scene, const scene::Camera& camera, glm::dvec2 place);

// The camera nearer to its target where a surface would be between them, so that a room is seen from inside;
// not by more than nine tenths of the way.
scene::Camera withinRoom(const scene::Scene& scene, scene::Camera camera);

// Where a point is in the picture; nothing behind the camera.
std::optional<glm::dvec2> placeOf(const scene::Image& image, const scene::Camera& camera, glm::dvec3 point);

}  // namespace fringe::preview
