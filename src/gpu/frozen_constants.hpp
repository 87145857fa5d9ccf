// Gives a shader's specialisation constants their values before a driver sees it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fringe::gpu {

// The SPIR-V module `spirv` with specialisation constant i, of 32 bits or bool, made the ordinary constant
// `values[i]`, and with what is computed from such constants computed: comparisons and logic, sums and
// products. An operation beyond those is left to the driver; a constant without a value keeps its default.
// Pure.
//
// Drivers take the values as well, but not all of them fold what follows from them: SwiftShader compiled the
// whole renderer, 9 s of it, where a scene needed a tenth.
std::vector<std::uint32_t> withFrozenConstants(std::span<const std::uint32_t> spirv,
                                               std::span<const std::uint32_t> values);

}  // namespace fringe::gpu
