// Where in space which gratings may reach: even cells, of which each that holds something matt has a list of
// them. So a point of a scene with many gratings looks at those of its cell alone, whichever way the light
// takes from it to the eye.
#pragma once

#include <functional>
#include <vector>

#include "compile/compiled_scene.hpp"
#include "compile/grating_reach.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

// Whether there are so many gratings that the shader looks them up (candidates() of shaders/path.glsl).
bool hasManyGratings(const CompiledScene& scene);

// Adds the grid to the tables and the frame; of a scene with few gratings nothing.
void addGratingGrid(const scene::Scene& scene, CompiledScene& out);

// The cells that hold something matt and that some grating may reach, together all of space that gratings may
// light; with at most so many cells in all. Regions are larger than their cells by more than any rounding.
std::vector<Region> litRegions(const scene::Scene& scene, const CompiledScene& compiled,
                               std::size_t mostCells);

}  // namespace fringe::compile
