#include "scene/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fringe::scene {
namespace {

// Walks forward through a text and counts lines and characters.
class Cursor {
public:
    explicit Cursor(std::string_view text) : text_(text) {}

    void advanceTo(std::ptrdiff_t offset) {
        const auto end = std::min(static_cast<std::size_t>(offset), text_.size());
        for (; at_ < end; ++at_) step();
    }

    std::size_t line() const { return line_; }
    std::size_t column() const { return column_; }

private:
    void step() {
        const auto byte = static_cast<unsigned char>(text_[at_]);
        const bool crOfCrLf = byte == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
        if ((byte == '\n' || byte == '\r') && !crOfCrLf) {
            ++line_;
            column_ = 1;
        } else if ((byte & 0xC0U) != 0x80U) {  // not a continuation byte of UTF-8
            ++column_;
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::size_t column_ = 1;
};

}  // namespace

std::vector<Problem> placed(Findings findings, std::string_view text, const std::string& fileName,
                            std::span<const Override> overrides) {
    std::stable_sort(findings.begin(), findings.end(),
                     [](const Finding& a, const Finding& b) { return a.offset < b.offset; });
    std::vector<Problem> problems;
    problems.reserve(findings.size());
    Cursor cursor(text);
    for (Finding& finding : findings) {
        if (isOverride(finding.offset)) {
            const Override& source = overrides[static_cast<std::size_t>(finding.offset - kFirstOverride)];
            problems.push_back(
                {fmt::format("--set {}={}", source.path, source.value), std::move(finding.message)});
        } else {
            cursor.advanceTo(finding.offset);
            problems.push_back({fmt::format("{}:{}:{}", fileName, cursor.line(), cursor.column()),
                                std::move(finding.message)});
        }
    }
    return problems;
}

}  // namespace fringe::scene
