// The instrument as widgets: at the window's right edge what was measured, and over the picture where.
#pragma once

#include "preview/instrument.hpp"
#include "preview/wish.hpp"

namespace fringe::preview {

// Pixels that it takes at the right edge of the window; 0 while it is off.
int instrumentWidth(const Instrument& instrument, float scale);

// Pixels that the window should be high for it.
int instrumentHeight(float scale);

// Draws it. True when what was found is to be written to files. `place` is that of the picture.
bool drawInstrument(const Instrument& instrument, const State& state, const scene::Scene& scene,
                    const scene::Camera& camera, const Rectangle& place, float scale);

}  // namespace fringe::preview
