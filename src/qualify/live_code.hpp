// How much of a shader is left once its constants are known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fringe::qualify {

// Bytes of those instructions of a SPIR-V module's functions that can be reached from its entry point, when
// no branch is taken whose condition is a constant that forbids it. Specialisation constants must have been
// given their values (gpu::withFrozenConstants). An unsigned number is known not to be less than 0, whatever
// it is; nothing else is folded, so that a driver's optimiser finds less. Pure.
std::size_t liveCodeBytes(std::span<const std::uint32_t> spirv);

}  // namespace fringe::qualify
