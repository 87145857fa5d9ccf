// Widgets for the values of a scene, made from its own structure and the schema of scene files: whatever a
// scene may say can be turned here.
#pragma once

#include <string>

#include "preview/document.hpp"

namespace fringe::preview {

// Draws the lights, materials, objects and the lens of the camera. True if the document has changed.
bool drawSceneEditor(Document& document);

// What a light or object goes by: its name and type, or its number and type.
std::string entryName(const Json::Value& value, Json::ArrayIndex index);

}  // namespace fringe::preview
