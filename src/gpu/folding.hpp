// Operations of a shader whose operands are known, computed before a driver sees it.
#pragma once

#include <cstdint>
#include <optional>

#include "gpu/spirv.hpp"

namespace fringe::gpu::spirv {

// What an operation makes of its operands; booleans are 0 and 1. None: it is not one of those known here.
std::optional<std::uint32_t> folded(Opcode operation, Words operands);

}  // namespace fringe::gpu::spirv
