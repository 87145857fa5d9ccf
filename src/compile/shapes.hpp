// Shapes as records of the device.
#pragma once

#include "compile/compiled_scene.hpp"

namespace fringe::compile {

// Shadow casters first, so that shadow rays look at the beginning of each array alone. The shapes of area
// lights take the materials from `firstLightMaterial` on.
void addShapes(const scene::Scene& scene, device::uint firstLightMaterial, CompiledScene& out);

}  // namespace fringe::compile
