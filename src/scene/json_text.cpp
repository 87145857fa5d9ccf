#include "scene/json_text.hpp"

#include <fmt/format.h>
#include <json/reader.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "scene/wording.hpp"

namespace fringe::scene {
namespace {

constexpr int kDeepest = 64;  // a scene needs 6; jsoncpp recurses once per level

// Length of the UTF-8 sequence at `at`, or 0 if there is none (RFC 3629: no overlong form, no surrogate).
std::size_t utf8Length(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) -> unsigned {
        return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
    };
    const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
    const unsigned first = byte(0);
    if (first < 0x80U) return 1;
    if (first >= 0xC2U && first <= 0xDFU) return continues(1) ? 2 : 0;
    if (first >= 0xE0U && first <= 0xEFU) {
        const bool overlong = first == 0xE0U && byte(1) < 0xA0U;
        const bool surrogate = first == 0xEDU && byte(1) > 0x9FU;
        return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (first >= 0xF0U && first <= 0xF4U) {
        const bool overlong = first == 0xF0U && byte(1) < 0x90U;
        const bool beyond = first == 0xF4U && byte(1) > 0x8FU;
        return continues(1) && continues(2) && continues(3) && !overlong && !beyond ? 4 : 0;
    }
    return 0;
}

std::optional<Finding> invalidUtf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8Length(text, at);
        if (length == 0) {
            return Finding{static_cast<std::ptrdiff_t>(at),
                           fmt::format("byte 0x{:02X} is not UTF-8 text; save the file as UTF-8",
                                       static_cast<unsigned char>(text[at]))};
        }
        at += length;
    }
    return std::nullopt;
}

// One pass over the text ahead of jsoncpp: finds the keys, and refuses what jsoncpp would accept or choke on.
// Any other fault of the syntax passes and is left to jsoncpp.
class Scan {
public:
    explicit Scan(std::string_view text) : text_(text) {
        while (skipSpaceAndComments(), at_ < text_.size() && !fault) token();
        if (!fault && !anything_)
            fault = {0, "there is no scene here; the smallest begins {\"fringe\": 1, \"camera\": ..."};
    }

    std::vector<KeyPlace> keys;
    std::optional<Finding> fault;

private:
    void skipSpaceAndComments() {
        while (at_ < text_.size()) {
            if (std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) {
                ++at_;
            } else if (text_.substr(at_, 2) == "//") {
                at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
            } else if (text_.substr(at_, 2) == "/*") {
                const std::size_t end = text_.find("*/", at_ + 2);
                at_ = end == std::string_view::npos ? text_.size() : end + 2;
            } else {
                return;
            }
        }
    }

    void token() {
        anything_ = true;
        const char c = text_[at_];
        if (c == ':') {
            awaitsValue_ = true;
            ++at_;
            return;
        }
        if (awaitsValue_) {
            keys.push_back({static_cast<std::ptrdiff_t>(at_), static_cast<std::ptrdiff_t>(lastString_)});
            awaitsValue_ = false;
        }
        if (c == '"') {
            string();
            return;
        }
        if (c == '{' || c == '[') {
            if (++depth_ > kDeepest) refuse("nested deeper than 64 levels; a scene needs 6");
        } else if (c == '}' || c == ']') {
            --depth_;
        }
        ++at_;
    }

    void string() {
        lastString_ = at_++;
        for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
            if (static_cast<unsigned char>(text_[at_]) < 0x20U) {
                refuse(
                    "a line break, tab or control character inside a string; write \\n or \\t, or close the "
                    "string with \"");
                return;
            }
            if (text_[at_] == '\\') ++at_;
        }
        ++at_;
    }

    void refuse(std::string message) {
        fault = Finding{static_cast<std::ptrdiff_t>(at_), std::move(message)};
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t lastString_ = 0;
    bool awaitsValue_ = false;
    bool anything_ = false;
    int depth_ = 0;
};

// The offset of a line and column as jsoncpp counts them: from 1, columns in bytes, lines ended by LF, CRLF
// or CR.
std::ptrdiff_t offsetOf(std::string_view text, int line, int column) {
    std::size_t begin = 0;
    for (; line > 1; --line) {
        begin = std::min(text.find_first_of("\r\n", begin), text.size());
        begin += text.substr(begin, 2) == "\r\n" ? 2 : 1;
    }
    return static_cast<std::ptrdiff_t>(std::min(begin + static_cast<std::size_t>(column) - 1, text.size()));
}

// jsoncpp's message in our form. Its own say what it missed, which is what would be right.
std::string reworded(std::string message) {
    while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
    const std::size_t quote = message.find('\'');
    if (message.starts_with("Duplicate key: '")) {
        return fmt::format("duplicate key {}; keep one of them",
                           inQuotes(std::string_view(message).substr(quote + 1, message.size() - quote - 2)));
    }
    if (message.ends_with("' is not a number")) {
        return fmt::format("{} is not a finite number; write one such as 12.5 or 1.2e-3",
                           message.substr(1, message.rfind('\'') - 1));
    }
    if (!message.empty() && message[0] >= 'A' && message[0] <= 'Z') message[0] += 'a' - 'A';
    return message;
}

// The first problem of jsoncpp's report, which is a list of "* Line 3, Column 7\n  message\n" and sometimes
// "See Line 3, Column 9 for detail.\n". What follows the first are mostly its consequences.
Finding firstProblem(std::string_view text, const std::string& report) {
    constexpr std::string_view kHead = "* Line ";
    constexpr std::string_view kColumn = ", Column ";
    if (!report.starts_with(kHead)) return {0, reworded(report)};
    int line = 1;
    int column = 1;
    const char* end = report.data() + report.size();
    const char* afterLine = std::from_chars(report.data() + kHead.size(), end, line).ptr;
    const char* afterColumn = std::from_chars(afterLine + kColumn.size(), end, column).ptr;
    constexpr std::string_view kIndent = "\n  ";
    const std::size_t begin = static_cast<std::size_t>(afterColumn - report.data()) + kIndent.size();
    const std::size_t stop = std::min(report.find("\nSee Line ", begin), report.find("\n* Line ", begin));
    return {offsetOf(text, line, column), reworded(report.substr(begin, stop - begin))};
}

Json::CharReaderBuilder strictReader() {
    Json::CharReaderBuilder builder;
    builder["collectComments"] = false;
    builder["allowComments"] = true;
    builder["allowTrailingCommas"] = false;
    builder["rejectDupKeys"] = true;
    builder["failIfExtra"] = true;
    builder["stackLimit"] = kDeepest + 2;  // never reached: Scan refuses before
    return builder;
}

}  // namespace

JsonText readJson(std::string_view text, Findings& findings) {
    if (std::optional<Finding> fault = invalidUtf8(text)) {
        findings.push_back(std::move(*fault));
        return {};
    }
    Scan scan(text);
    if (scan.fault) {
        findings.push_back(std::move(*scan.fault));
        return {};
    }
    JsonText result;
    std::string report;
    const std::unique_ptr<Json::CharReader> reader(strictReader().newCharReader());
    if (!reader->parse(text.data(), text.data() + text.size(), &result.root, &report)) {
        findings.push_back(firstProblem(text, report));
    }
    result.keys = std::move(scan.keys);
    return result;
}

}  // namespace fringe::scene
