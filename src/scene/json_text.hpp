// JSON text with comments -> values that know their place in the text.
#pragma once

#include <json/value.h>

#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/findings.hpp"

namespace fringe::scene {

// Where the key of a value is; jsoncpp keeps only the place of the value.
struct KeyPlace {
    std::ptrdiff_t value;
    std::ptrdiff_t key;
};

struct JsonText {
    Json::Value root;
    std::vector<KeyPlace> keys;  // sorted by value
};

// Reads strict JSON in UTF-8 (no byte order mark) with // and /* */ comments. Every value's getOffsetStart()
// is its place in `text`. Duplicate keys, numbers that are not finite and nesting beyond 64 levels are
// refused. What is wrong is added to `findings`; the result counts only if nothing was.
JsonText readJson(std::string_view text, Findings& findings);

}  // namespace fringe::scene
