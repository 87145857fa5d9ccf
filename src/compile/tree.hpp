// A bounding volume hierarchy: boxes within boxes, with a shape in each leaf. A ray that misses a box misses
// all that is in it, so it looks at some tens of shapes among thousands.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "compile/interface.hpp"

namespace fringe::compile {

// A shape of the device and the box around it, in metres.
struct TreeLeaf {
    device::uint kind;  // as in shaders/trace.glsl
    device::uint index;
    glm::dvec3 low;
    glm::dvec3 high;
};

struct Tree {
    std::vector<device::TreeNode> nodes;  // the root first; none for fewer than two leaves
    device::uint depth = 0;               // nodes on the longest way from the root to a leaf
};

// Splits where the surface area heuristic finds the least cost among 16 bins along each axis (I. Wald, "On
// fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007). Boxes are larger by 4e-6 of the
// largest coordinate, the distance that rays keep from surfaces (shaders/trace.glsl, leave), so that no
// rounding of a hit leads past its box. Pure; the same leaves give the same tree.
Tree buildTree(std::vector<TreeLeaf> leaves);

}  // namespace fringe::compile
