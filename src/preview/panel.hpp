// The widgets beside the picture.
#pragma once

#include "preview/document.hpp"
#include "preview/wish.hpp"

namespace fringe::preview {

// What the user sets beside the scene itself.
struct Settings {
    Display display;
    double wavelength_nm = 550.0;  // of the views that show one
    Switches switches;             // but for the wavelength
    std::uint32_t samples = 16;
    bool showsPanel = true;
    bool showsKeys = false;
};

// What the panel tells.
struct Facts {
    const State& state;
    const Picture* picture = nullptr;  // on show; null before the first
    float picturesPerSecond = 0.0F;
    const std::string& notice;       // what was written, or why it was not
    const std::string& fileProblem;  // why changes of the scene file cannot be followed
};

// Pixels that the panel takes at the left edge of the window.
int panelWidth(const Settings& settings, float scale);

// What was done in the panel.
struct PanelActions {
    bool display = false;  // the settings have changed
    bool scene = false;    // the document has
    bool savePicture = false;
    bool saveScene = false;
};

// Draws panel, key list and messages.
PanelActions drawPanel(Settings& settings, Document& document, const Facts& facts, float scale);

}  // namespace fringe::preview
