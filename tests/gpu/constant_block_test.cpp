// withConstantBlock(): the same shader reads the same numbers, bit for bit, from a uniform block and from
// constants.
#include "gpu/constant_block.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <vector>

#include "gpu/probe.hpp"
#include "shaders/block_probe.comp.h"

namespace fringe::testing {
namespace {

using Word = std::uint32_t;
constexpr Word kInvocations = 4;

// block_probe.comp's block, in scalar layout.
struct Inner {
    Word kind;
    std::array<float, 3> direction;
};
struct Outer {
    float scale;
    std::array<Inner, 4> inner;
    std::array<Word, 4> counts;
};
struct Block {
    std::array<Outer, 2> outer;
    std::int32_t lowest;
    std::array<float, 6> zeros;
    std::array<float, 4> spread;
};
static_assert(sizeof(Block) == 2 * (4 + 4 * 16 + 16) + 4 + 24 + 16);

// Every number another, but for `zeros` and for an Inner that equals the last of its array.
Block block() {
    Block result{};
    float next = 1.25F;
    Word number = 7;
    for (Outer& outer : result.outer) {
        outer.scale = next++;
        for (Inner& inner : outer.inner) {
            inner.kind = number++;
            for (float& component : inner.direction) component = next++;
        }
        for (Word& count : outer.counts) count = number++;
    }
    result.outer[0].inner[1] = result.outer[0].inner[3];
    result.outer[1].inner[0].direction[1] = -0.0F;  // not the zero whose bits are all 0
    result.lowest = -5;
    result.spread = {0.5F, -3.0F, 1e30F, 0.125F};
    return result;
}

std::span<const std::byte> bytesOf(const Block& block) {
    return std::as_bytes(std::span(&block, 1));
}

// What the shader should write, by the language's own arrays.
std::vector<Word> expected(const Block& block, Word last) {
    std::vector<Word> words;
    const auto put = [&](auto value) { words.push_back(std::bit_cast<Word>(value)); };
    for (Word i = 0; i < kInvocations; ++i) {
        put(block.lowest);
        put(block.outer[1].scale);
        put(block.outer[1].inner[2].direction[1]);
        put(block.outer[last].counts[2]);
        put(block.spread[i]);
        put(block.zeros[i]);
        put(block.outer[0].inner[i].direction[0]);
        put(block.outer[i & 1U].inner[3 - i].kind);
        put(block.outer[0].counts[i]);
        put(block.outer[1].inner[i].direction[2]);
        put(block.outer[1].inner[1].kind);
        put(block.spread[0] + block.spread[1] + block.spread[2]);
        const Inner& first = block.outer[i >> 1U].inner[0];
        put(first.direction[0] + first.direction[1]);
    }
    return words;
}

// The block that the rewritten shader is bound to holds other numbers: it must not be read.
TEST(ConstantBlockOnDevice, ReadsWhatTheUniformBlockHolds) {
    const Block values = block();
    const auto constants = gpu::withConstantBlock(block_probe_comp, bytesOf(values));
    const Block others{};
    for (const Word last : {0U, 1U}) {
        const std::vector<Word> wanted = expected(values, last);
        EXPECT_EQ(runProbe(block_probe_comp, bytesOf(values), {last}, wanted.size()), wanted);
        EXPECT_EQ(runProbe(constants, bytesOf(others), {last}, wanted.size()), wanted);
    }
}

}  // namespace
}  // namespace fringe::testing
