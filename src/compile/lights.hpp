// Lights and gratings as records of the device: powers become intensities, irradiances and radiances.
#pragma once

#include "compile/compiled_scene.hpp"

namespace fringe::compile {

// Appends what objects of emissive materials light. A rectangle, disc or sphere does, other shapes only glow.
void addGlowingObjects(const scene::Scene& scene, SpectralTables& tables, CompiledScene& out);

// Appends every light of the scene, and a material for the shape of each area light. Reflectances must be in
// `tables` already: what a grating needs depends on what it falls on.
void addLights(const scene::Scene& scene, SpectralTables& tables, CompiledScene& out);

}  // namespace fringe::compile
