// Which gratings may light a part of space: whatever the shader's tests of a point (reachesBand,
// reachesSlits, reachesOpening) let pass anywhere in it, and never less.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "compile/compiled_scene.hpp"
#include "compile/extent.hpp"

namespace fringe::compile {

// A box along the axes; a side may be infinitely far.
struct Region {
    glm::dvec3 low, high;
};

inline Interval alongAxis(const Region& region, int axis) {
    return {region.low[axis], region.high[axis]};
}

// The gratings of a scene in the order that shaders/path.glsl counts them: of the thesis, slits, openings.
class GratingReach {
public:
    // Keeps a reference to the scene's gratings.
    explicit GratingReach(const CompiledScene& scene) : scene_(scene) {}

    device::uint count() const;
    glm::dvec3 position(device::uint grating) const;

    // Whether any point of the region may get light of the grating.
    bool mayReach(device::uint grating, const Region& region) const;

private:
    const CompiledScene& scene_;
};

}  // namespace fringe::compile
