#include "gpu/folding.hpp"

namespace fringe::gpu::spirv {

std::optional<std::uint32_t> folded(Opcode operation, Words x) {
    switch (operation) {
        case kIAdd:
            return x[0] + x[1];
        case kISub:
            return x[0] - x[1];
        case kIMul:
            return x[0] * x[1];
        case kShiftLeftLogical:
            return x[1] < 32 ? x[0] << x[1] : 0;  // SPIR-V leaves the other case undefined
        case kLogicalEqual:
        case kIEqual:
            return x[0] == x[1];
        case kLogicalNotEqual:
        case kINotEqual:
            return x[0] != x[1];
        case kLogicalOr:
            return x[0] | x[1];
        case kLogicalAnd:
            return x[0] & x[1];
        case kLogicalNot:
            return x[0] == 0;
        case kSelect:
            return x[0] != 0 ? x[1] : x[2];
        case kUGreaterThan:
            return x[0] > x[1];
        case kUGreaterThanEqual:
            return x[0] >= x[1];
        case kULessThan:
            return x[0] < x[1];
        case kULessThanEqual:
            return x[0] <= x[1];
        default:
            return std::nullopt;
    }
}

}  // namespace fringe::gpu::spirv
