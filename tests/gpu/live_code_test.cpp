// withoutDeadCode(): a shader does what it did, and is shorter where its constants rule something out.
#include "gpu/live_code.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "gpu/frozen_constants.hpp"
#include "gpu/probe.hpp"
#include "gpu/spirv.hpp"
#include "shaders/branches_probe.comp.h"

namespace fringe::testing {
namespace {

constexpr std::size_t kWords = 12;

// branches_probe.comp in C++.
std::uint32_t steps(std::uint32_t n, bool hasIt) {
    for (std::uint32_t i = 0; i < 100; ++i) {
        if (hasIt && i == 3) return 1000 + i;
        if (n <= 1) return i;
        n = n % 2 == 0 ? n / 2 : 3 * n + 1;
    }
    return 100;
}

std::vector<std::uint32_t> expected(std::uint32_t count, std::uint32_t kind, bool hasIt,
                                    std::uint32_t given) {
    std::vector<std::uint32_t> words(kWords, 0);
    std::uint32_t value = 7;
    if (kind == 1) value += given;
    words[0] = value;
    words[1] = hasIt ? value * 3 : value + 100;
    words[2] = kind != 0 && given > 2 ? 5 : 6;
    words[3] = hasIt || given > 100 ? 8 : 9;
    std::uint32_t sum = 0;
    for (std::uint32_t i = 0; kind != 2 && i < count && i + given <= 12; ++i) sum += i + given;
    words[4] = sum;
    for (std::uint32_t i = 0; i < (hasIt ? 1 : given); ++i)
        sum += 10 * i + (hasIt ? 0 : count * (count - 1) / 2);
    words[5] = sum;
    words[6] = hasIt ? given : 1;
    if (kind == 0 || kind == 1) words[7] = (kind + 1) * given;
    if (kind == 1 || kind == 2) words[8] = 3 * given;
    if (kind > 2) words[7] = 4;
    words[9] = steps(given, hasIt);
    if (hasIt) words[10] = steps(given + 1, hasIt);
    if (kind != 3) words[11] = 1;
    return words;
}

// The Kernel leaves out dead code of whatever it is given.
TEST(LiveCodeOnDevice, DoesWhatTheWholeDoes) {
    constexpr std::array<std::uint32_t, 1> kGiven{9};
    for (const std::uint32_t count : {0U, 1U, 5U}) {
        for (const std::uint32_t kind : {0U, 1U, 2U, 3U}) {
            for (const bool hasIt : {false, true}) {
                EXPECT_EQ(runProbe(branches_probe_comp, std::as_bytes(std::span(kGiven)),
                                   {count, kind, hasIt}, kWords),
                          expected(count, kind, hasIt, kGiven[0]))
                    << count << ' ' << kind << ' ' << hasIt;
            }
        }
    }
}

std::size_t count(std::span<const std::uint32_t> spirv, gpu::spirv::Opcode opcode) {
    std::size_t found = 0;
    gpu::spirv::forEachInstruction(
        spirv, [&](gpu::spirv::Words words) { found += gpu::spirv::opcodeOf(words) == opcode ? 1 : 0; });
    return found;
}

TEST(LiveCode, IsWhatTheConstantsLeave) {
    using namespace gpu::spirv;
    const std::vector<std::uint32_t> none{0, 0, 0}, all{5, 1, 1};
    const auto whole = gpu::withFrozenConstants(branches_probe_comp, none);
    const auto least = gpu::withoutDeadCode(whole);
    const auto most = gpu::withoutDeadCode(gpu::withFrozenConstants(branches_probe_comp, all));
    EXPECT_LT(least.size(), most.size());
    EXPECT_LT(most.size(), whole.size());
    // Left are the ends of four loops (the zeros, `given`, do-while, steps()), n <= 1, and even or odd.
    EXPECT_EQ(count(least, kBranchConditional), 6U);
    // What is live once is live ever after.
    EXPECT_EQ(gpu::withoutDeadCode(least), least);
}

}  // namespace
}  // namespace fringe::testing
