// Checks JSON against the schema: keys, types, ranges, units. What the values mean together (directions that
// are parallel, names that lead nowhere) is checked where they are extracted.
#pragma once

#include <json/value.h>

#include <unordered_set>
#include <vector>

#include "scene/findings.hpp"
#include "scene/json_text.hpp"
#include "scene/schema.hpp"

namespace fringe::scene {

// The values that cannot be extracted: each has, somewhere inside, a problem other than an unknown key.
using Unsound = std::unordered_set<const Json::Value*>;

// Adds every problem of `root` to `findings`. `keys` gives the places of keys in the text, as readJson found
// them.
Unsound validate(const Json::Value& root, const Schema& schema, const std::vector<KeyPlace>& keys,
                 Findings& findings);

}  // namespace fringe::scene
