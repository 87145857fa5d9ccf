// Widgets for the values of a scene, made from its own structure and the schema of scene files: whatever a
// scene may say can be turned here.
#pragma once

#include "preview/document.hpp"

namespace fringe::preview {

// Draws the lights, materials, objects and the lens of the camera. True if the document has changed.
bool drawSceneEditor(Document& document);

}  // namespace fringe::preview
