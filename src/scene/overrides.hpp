// Values set from outside the file: --set PATH=VALUE.
#pragma once

#include <json/value.h>

#include <span>

#include "scene/findings.hpp"
#include "scene/schema.hpp"

namespace fringe::scene {

// Sets each override's value in `root`, in order. A key on the way that is missing is made, from its default
// if the schema gives one; an element of an array, and a name in a map such as "materials", must exist unless
// it is the last segment of a map. Every value set or made carries overrideOffset() of its override as its
// offset.
void applyOverrides(std::span<const Override> overrides, const Schema& schema, Json::Value& root,
                    Findings& findings);

}  // namespace fringe::scene
