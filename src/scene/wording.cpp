#include "scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace fringe::scene {
namespace {

constexpr std::size_t kLongestList = 20;  // names; more than any type has keys

bool sameLetter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

// Optimal string alignment distance (Damerau 1964, each letter moved once), with the three last rows of its
// table.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(beforeLast, last);
        std::swap(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (sameLetter(a[i - 1], b[j - 1]) ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && sameLetter(a[i - 1], b[j - 2]) && sameLetter(a[i - 2], b[j - 1])) {
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

}  // namespace

std::string anyOf(std::span<const std::string> words) {
    if (words.empty()) return {};
    if (words.size() == 1) return words.front();
    return fmt::format("{} or {}", fmt::join(words.first(words.size() - 1), ", "), words.back());
}

std::string inQuotes(std::string_view text, std::size_t longest) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool startsCharacter = (byte & 0xC0U) != 0x80U;  // of UTF-8
        if (startsCharacter && result.size() > longest) return result + "...\"";
        result += byte < 0x20U || byte == 0x7FU ? fmt::format("\\u{:04x}", byte) : std::string(1, c);
    }
    return result + '"';
}

std::string_view nearest(std::string_view word, std::span<const std::string> names) {
    std::string_view best;
    std::size_t bestDistance = std::max<std::size_t>(1, word.size() / 3) + 1;
    if (word.empty() || word.size() > kLongestQuote) return best;
    for (const std::string& name : names) {
        if (name.size() > kLongestQuote) continue;
        const std::size_t distance = editDistance(word, name);
        // A short word is near to nothing: one wrong letter must leave another that is right.
        if (distance < bestDistance && distance < std::max(word.size(), name.size())) {
            best = name;
            bestDistance = distance;
        }
    }
    return best;
}

std::string suggestion(std::string_view word, std::span<const std::string> names, std::string_view lead) {
    if (const std::string_view near = nearest(word, names); !near.empty()) {
        return fmt::format("did you mean {}?", inQuotes(near));
    }
    std::vector<std::string> listed;
    for (const std::string& name : names.first(std::min(names.size(), kLongestList)))
        listed.push_back(inQuotes(name));
    if (names.size() > kLongestList)
        listed.push_back(fmt::format("one of {} more", names.size() - kLongestList));
    return fmt::format("{} {}", lead, anyOf(listed));
}

std::string spoken(const Json::Value& value) {
    switch (value.type()) {
        case Json::nullValue:
            return "null";
        case Json::intValue:
        case Json::uintValue:
            return value.asString();
        case Json::realValue:
            return fmt::format("{}", value.asDouble());
        case Json::stringValue:
            return inQuotes(value.asString());
        case Json::booleanValue:
            return value.asBool() ? "true" : "false";
        case Json::arrayValue:
            return "an array";
        case Json::objectValue:
            return "an object";
    }
    return {};
}

}  // namespace fringe::scene
