// A problem while the text is still at hand: where it is, as a byte offset, and what to say.
// Offsets become lines and columns in one sweep at the end, when all problems are known.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/parse.hpp"

namespace fringe::scene {

struct Finding {
    std::ptrdiff_t offset;  // into the text of the file, or that of an override
    std::string message;
};

using Findings = std::vector<Finding>;

// What override number `index` has set carries this offset in place of one into the text. It is past the end
// of any text, so that sorting puts the problems of overrides last.
inline constexpr std::ptrdiff_t kFirstOverride = std::numeric_limits<std::ptrdiff_t>::max() / 2;

constexpr std::ptrdiff_t overrideOffset(std::size_t index) {
    return kFirstOverride + static_cast<std::ptrdiff_t>(index);
}

constexpr bool isOverride(std::ptrdiff_t offset) {
    return offset >= kFirstOverride;
}

// The findings in the order of the file and then of the overrides, each with its place in words. Lines end at
// LF, CRLF or CR; columns count the characters of UTF-8. Takes time in proportion to text and findings.
std::vector<Problem> placed(Findings findings, std::string_view text, const std::string& fileName,
                            std::span<const Override> overrides);

}  // namespace fringe::scene
