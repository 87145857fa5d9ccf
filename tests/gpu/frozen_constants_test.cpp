// withFrozenConstants(): what follows from the constants is what the language says, and nothing is left to
// the driver but the operation that is not known.
#include "gpu/frozen_constants.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "gpu/probe.hpp"
#include "gpu/spirv.hpp"
#include "shaders/constants_probe.comp.h"

namespace fringe::testing {
namespace {

// constants_probe.comp in C++.
std::vector<std::uint32_t> expected(std::uint32_t count, bool hasIt) {
    const std::uint32_t unset = 42;
    const std::uint32_t sum = count * 3 + unset - 2;
    const std::uint32_t mask = (1U << count) - 1;
    const bool few = count <= 4 && count >= 1;
    const bool many = count > 4 || count >= 3;
    return {count,
            hasIt,
            unset,
            sum,
            mask,
            sum % 5,
            few,
            many,
            hasIt == few,
            (count != unset) != hasIt,
            hasIt ? sum : mask,
            count == unset};
}

// The Kernel freezes whatever it is given.
TEST(FrozenConstantsOnDevice, ComputeWhatFollowsFromThem) {
    constexpr std::array<std::byte, 4> kUnused{};
    for (const std::uint32_t count : {0U, 1U, 3U, 4U, 5U, 17U}) {
        for (const bool hasIt : {false, true}) {
            const std::vector<std::uint32_t> wanted = expected(count, hasIt);
            EXPECT_EQ(runProbe(constants_probe_comp, kUnused, {count, hasIt}, wanted.size()), wanted);
        }
    }
}

TEST(FrozenConstants, LeaveOneOperationToTheDriver) {
    const std::vector<std::uint32_t> values{3, 1};
    std::vector<gpu::spirv::Opcode> left;
    gpu::spirv::forEachInstruction(
        gpu::withFrozenConstants(constants_probe_comp, values), [&](gpu::spirv::Words words) {
            const gpu::spirv::Opcode opcode = gpu::spirv::opcodeOf(words);
            if (opcode >= gpu::spirv::kSpecConstantTrue && opcode <= gpu::spirv::kSpecConstantOp) {
                left.push_back(opcode);
            }
        });
    EXPECT_EQ(left, std::vector{gpu::spirv::kSpecConstantOp});  // SUM % 5
}

}  // namespace
}  // namespace fringe::testing
