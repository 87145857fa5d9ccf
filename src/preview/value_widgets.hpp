// Widgets for single values of a scene: numbers, quantities with their units, choices, vectors.
#pragma once

#include <json/value.h>

#include <optional>

#include "scene/schema.hpp"

namespace fringe::preview {

// Whether a value of this schema has one widget, on one line.
bool isSimple(const scene::Schema& schema);

// Whether it is turned by two angles.
bool isDirection(const scene::Schema& schema);

// Draws it; the new value if the user has changed it. Precondition: isSimple(schema), and the value fits it.
std::optional<Json::Value> drawValue(const scene::Schema& schema, const char* label,
                                     const Json::Value& value);

}  // namespace fringe::preview
