// Small shaders whose results are words that a test compares.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fringe::testing {

// Runs one workgroup of a shader with a uniform block that holds `uniforms` at binding 0 and room for `words`
// words at binding 1, and gives what it wrote there. Any message of the validation layer fails the test that
// runs.
std::vector<std::uint32_t> runProbe(std::span<const std::uint32_t> spirv, std::span<const std::byte> uniforms,
                                    const std::vector<std::uint32_t>& constants, std::size_t words);

}  // namespace fringe::testing
