// Leaves out of a shader what it never comes to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fringe::gpu {

// The SPIR-V module `spirv` without the branches that its constants rule out, loops of no turns, and
// functions that nothing calls. A function whose blocks are not in the order of their execution stays as it
// is. Pure.
//
// Drivers find that out as well, but only after they have read and rewritten all of it: for a scene that
// needs a sixth of the renderer lavapipe took four times as long to compile it.
std::vector<std::uint32_t> withoutDeadCode(std::span<const std::uint32_t> spirv);

}  // namespace fringe::gpu
