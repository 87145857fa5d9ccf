// Turns a shader's uniform block into constants of the shader, when its bytes are known before it is
// compiled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fringe::gpu {

// The SPIR-V module `spirv` with the one variable of storage class Uniform made a Private variable that
// begins as `block`, the bytes the uniform block would hold. A compiler can then fold every value, and has no
// load to check against the end of a buffer. Binding and set of the block are no longer used; specialisation
// constants stay.
//
// Arrays end with their last element that is not all zero; a shader must not read further, so whatever is in
// use must hold some bit that is not 0.
//
// The block may consist of structs, arrays, vectors and 32-bit numbers, laid out as the module's own Offset
// and ArrayStride decorations say (SPIR-V specification 1.5, sections 2.3 and 3.37). Pure. Anything else in
// the module's block is a mistake in our shader and asserts, as does a block that ends before its last
// member.
std::vector<std::uint32_t> withConstantBlock(std::span<const std::uint32_t> spirv,
                                             std::span<const std::byte> block);

}  // namespace fringe::gpu
