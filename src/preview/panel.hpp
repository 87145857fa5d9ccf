// The widgets beside the picture.
#pragma once

#include "preview/wish.hpp"

namespace fringe::preview {

// What the user sets beside the scene itself.
struct Settings {
    Display display;
    std::uint32_t samples = 16;
    bool showsPanel = true;
    bool showsKeys = false;
};

// What the panel tells.
struct Facts {
    const State& state;
    const Picture* picture = nullptr;  // on show; null before the first
    float picturesPerSecond = 0.0F;
};

// Pixels that the panel takes at the left edge of the window.
int panelWidth(const Settings& settings, float scale);

// Draws panel, key list and messages. True if settings have changed.
bool drawPanel(Settings& settings, const Facts& facts, float scale);

}  // namespace fringe::preview
