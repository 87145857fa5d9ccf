// What constants leave of a shader, in modules small enough to count by hand, and in the renderer.
#include "qualify/live_code.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "compile/interface.hpp"
#include "gpu/frozen_constants.hpp"
#include "gpu/spirv.hpp"
#include "shaders/render_000.h"

namespace fringe::qualify {
namespace {

using Words = std::vector<std::uint32_t>;

// An instruction of `opcode`.
void put(Words& module, std::uint32_t opcode, const Words& operands) {
    gpu::spirv::append(module, static_cast<gpu::spirv::Opcode>(opcode), operands);
}

// main() { if (ID 3) call ID 20 else return; }, with ID 3 as given; ID 20 is a function of three words more
// than an empty one.
Words branching(std::uint32_t opcodeOfCondition) {
    Words module{0x07230203, 0x00010500, 0, 100, 0};
    put(module, gpu::spirv::kEntryPoint, {5, 10, 'm'});
    put(module, opcodeOfCondition, {2, 3});
    put(module, gpu::spirv::kFunction, {1, 10, 0, 4});
    put(module, 248, {11});         // OpLabel                  2 words
    put(module, 250, {3, 12, 13});  // OpBranchConditional      4
    put(module, 248, {12});         // OpLabel                  2
    put(module, 57, {1, 14, 20});   // OpFunctionCall           4
    put(module, 249, {13});         // OpBranch                 2
    put(module, 248, {13});         // OpLabel                  2
    put(module, 253, {});           // OpReturn                 1
    put(module, 56, {});            // OpFunctionEnd
    put(module, gpu::spirv::kFunction, {1, 20, 0, 4});
    put(module, 248, {21});                         // OpLabel                  2
    put(module, gpu::spirv::kIAdd, {2, 22, 3, 3});  //            5
    put(module, 253, {});                           // OpReturn                 1
    put(module, 56, {});
    return module;
}

constexpr std::size_t kAlways = 2 + 4 + 2 + 1, kIfTaken = 2 + 4 + 2, kCalled = 2 + 5 + 1;
constexpr std::size_t kWord = 4;

TEST(LiveCode, FollowsNoBranchThatAConstantForbids) {
    EXPECT_EQ(liveCodeBytes(branching(gpu::spirv::kConstantFalse)), kWord * kAlways);
    EXPECT_EQ(liveCodeBytes(branching(gpu::spirv::kConstantTrue)), kWord * (kAlways + kIfTaken + kCalled));
}

TEST(LiveCode, FollowsBothWhereTheConditionIsUnknown) {
    constexpr std::uint32_t kUndefined = 1;  // OpUndef
    EXPECT_EQ(liveCodeBytes(branching(kUndefined)), kWord * (kAlways + kIfTaken + kCalled));
}

std::size_t ofRenderer(std::uint32_t value) {
    const Words constants(device::kSpecialisationCount, value);
    return liveCodeBytes(gpu::withFrozenConstants(render_000, constants));
}

// Everything is there once against nothing at all.
TEST(LiveCode, OfTheRendererShrinksWithWhatItIsFor) {
    EXPECT_GT(ofRenderer(0), 0U);
    EXPECT_LT(4 * ofRenderer(0), ofRenderer(1));
    EXPECT_LE(ofRenderer(1), sizeof(std::uint32_t) * std::size(render_000));
}

}  // namespace
}  // namespace fringe::qualify
