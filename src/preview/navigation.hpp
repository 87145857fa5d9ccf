// Mouse and keys to camera: what the user does over the picture, read from Dear ImGui's input.
#pragma once

#include <optional>
#include <span>

#include "preview/presenter.hpp"
#include "scene/scene.hpp"

namespace fringe::preview {

// The camera after what was done since the last frame; nothing if it stays. `place` is that of the picture in
// the window, `keys` went down in it. Without `leftOrbits` the left button alone does nothing.
std::optional<scene::Camera> navigated(const scene::Camera& camera, const scene::Scene& scene,
                                       const Rectangle& place, const Window& window,
                                       std::span<const KeyPress> keys, bool leftOrbits);

// Whether a key is held that moves the camera for as long as it is.
bool isFlying(const Window& window);

struct KeyHelp {
    const char* keys;
    const char* what;
};
std::span<const KeyHelp> navigationHelp();

}  // namespace fringe::preview
