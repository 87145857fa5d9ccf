// Turns a shader's uniform block into constants of the shader, when its bytes are known before it is
// compiled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fringe::gpu {

// The SPIR-V module `spirv` without its one variable of storage class Uniform: what was loaded from it is now
// a constant, taken from `block`, the bytes that the uniform block would hold. An element at an index known
// only later (a loop's variable, an invocation's) is selected among the array's constants. Specialisation
// constants stay.
//
// The block may consist of structs, arrays, vectors and 32-bit numbers, laid out as the module's own Offset
// and ArrayStride decorations say (SPIR-V specification 1.5, sections 2.3 and 3.37), and may be read by
// OpLoad of an access chain; the module is of SPIR-V 1.4 or later, whose OpSelect takes structs. Anything
// else is a mistake in our shader and asserts, as does a block that ends before its last member. Pure.
std::vector<std::uint32_t> withConstantBlock(std::span<const std::uint32_t> spirv,
                                             std::span<const std::byte> block);

}  // namespace fringe::gpu
