// Words for messages: lists, the nearest of some names, and values as a reader would write them.
#pragma once

#include <json/value.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace fringe::scene {

// a, b or c
std::string anyOf(std::span<const std::string> words);

// Enough for any sensible name or quantity, in bytes.
inline constexpr std::size_t kLongestQuote = 60;

// The text in double quotes, cut short when it is longer than that; control characters are escaped, so that a
// message stays on its line.
std::string inQuotes(std::string_view text, std::size_t longest = kLongestQuote);

// The one of `names` that `word` most likely stands for, or an empty text where none is near: at most one
// letter in three may be wrong, missing, extra or swapped with its neighbour (upper and lower case are
// alike).
std::string_view nearest(std::string_view word, std::span<const std::string> names);

// Ends a message about `word`, which is none of `names`: did you mean "sphere"? Without a near one it lists
// them (the first twenty of many): `lead` "plane", "sphere" or "box".
std::string suggestion(std::string_view word, std::span<const std::string> names, std::string_view lead);

// A value as it is in "this is ...": a number, "some text", an array, an object, true, null.
std::string spoken(const Json::Value& value);

}  // namespace fringe::scene
