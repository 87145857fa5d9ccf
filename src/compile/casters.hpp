// Which shapes can throw a shadow at all. A flat shape that has the whole scene on one side of its plane,
// such as a wall of a room, lies between no two points of the scene: shadow rays need not look at it, and a
// scene of walls alone has no shadow rays.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace fringe::compile {

// Every shape of the scene: the objects in their order, then those of the area lights.
std::vector<scene::Shape> allShapes(const scene::Scene& scene);

// For each of allShapes(): false where it is certain that no shadow ray of this scene can meet it.
std::vector<bool> shadowCasters(const scene::Scene& scene);

}  // namespace fringe::compile
