// Values that the schema of scene files would take where there are none yet.
#pragma once

#include <json/value.h>

#include <string>

#include "scene/schema.hpp"

namespace fringe::preview {

// The default, the first choice or the example of the schema, and of an object all keys that it requires.
Json::Value exampleOf(const scene::Schema& schema);

// `value` made into an object of another schema: keys that both know stay, what is required is added.
Json::Value adapted(const Json::Value& value, const scene::Schema& schema);

// What an alternative is called in a list: its title without the article, else its value or "number".
std::string labelOf(const scene::Schema& schema);

}  // namespace fringe::preview
