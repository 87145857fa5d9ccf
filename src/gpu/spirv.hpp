// SPIR-V modules as words: five words of header and then instructions, each with its length and opcode in its
// first word: names and decorations, then types, constants and variables, then functions. Numbers and layouts
// of operands are those of the SPIR-V specification 1.5, section 3.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fringe::gpu::spirv {

using Words = std::span<const std::uint32_t>;
using Id = std::uint32_t;

enum Opcode : std::uint32_t {
    kUndef = 1,
    kName = 5,
    kEntryPoint = 15,
    kExecutionMode = 16,
    kCapability = 17,
    kFirstType = 19,
    kTypeBool = 20,
    kTypeInt = 21,
    kTypeFloat = 22,
    kTypeVector = 23,
    kTypeImage = 25,
    kTypeArray = 28,
    kTypeRuntimeArray = 29,
    kTypeStruct = 30,
    kTypePointer = 32,
    kConstantTrue = 41,
    kConstantFalse = 42,
    kConstant = 43,
    kConstantComposite = 44,
    kConstantNull = 46,
    kSpecConstantTrue = 48,
    kSpecConstantFalse = 49,
    kSpecConstant = 50,
    kSpecConstantOp = 52,
    kFunction = 54,
    kFunctionEnd = 56,
    kFunctionCall = 57,
    kVariable = 59,
    kLoad = 61,
    kStore = 62,
    kCopyMemory = 63,
    kCopyMemorySized = 64,
    kAccessChain = 65,
    kInBoundsAccessChain = 66,
    kDecorate = 71,
    kMemberDecorate = 72,
    kCopyObject = 83,
    kImageWrite = 99,
    kIAdd = 128,
    kISub = 130,
    kIMul = 132,
    kLogicalEqual = 164,
    kLogicalNotEqual = 165,
    kLogicalOr = 166,
    kLogicalAnd = 167,
    kLogicalNot = 168,
    kSelect = 169,
    kIEqual = 170,
    kINotEqual = 171,
    kUGreaterThan = 172,
    kUGreaterThanEqual = 174,
    kULessThan = 176,
    kULessThanEqual = 178,
    kShiftLeftLogical = 196,
    kControlBarrier = 224,
    kMemoryBarrier = 225,
    kAtomicStore = 228,
    kPhi = 245,
    kLoopMerge = 246,
    kSelectionMerge = 247,
    kLabel = 248,
    kBranch = 249,
    kBranchConditional = 250,
    kSwitch = 251,
    kKill = 252,
    kReturn = 253,
    kReturnValue = 254,
    kUnreachable = 255,
};

enum Decoration : std::uint32_t {
    kSpecId = 1,
    kArrayStride = 6,
    kBinding = 33,
    kDescriptorSet = 34,
    kOffset = 35
};

// Storage classes, and an execution mode.
constexpr std::uint32_t kUniform = 2, kPushConstant = 9;
constexpr std::uint32_t kLocalSize = 17;

constexpr std::size_t kHeaderWords = 5;
constexpr std::size_t kVersionWord = 1;
constexpr std::size_t kBoundWord = 3;  // one more than the largest id

inline Opcode opcodeOf(Words instruction) {
    return static_cast<Opcode>(instruction[0] & 0xffffU);
}

// Calls `visit` with each instruction, its first word included.
template <class Visit>
void forEachInstruction(Words module, Visit visit) {
    for (std::size_t at = kHeaderWords; at < module.size();) {
        const std::size_t length = module[at] >> 16;
        assert(length > 0 && at + length <= module.size());
        visit(module.subspan(at, length));
        at += length;
    }
}

inline void append(std::vector<std::uint32_t>& to, Words words) {
    to.insert(to.end(), words.begin(), words.end());
}

inline void append(std::vector<std::uint32_t>& to, Opcode opcode, Words operands) {
    to.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | opcode);
    append(to, operands);
}

}  // namespace fringe::gpu::spirv
