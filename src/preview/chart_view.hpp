// A chart (plot/chart.hpp) drawn by Dear ImGui: the one that is written to files, as a widget.
#pragma once

#include <cstddef>
#include <optional>

#include "plot/chart.hpp"

namespace fringe::preview {

// Of this size in pixels, at the cursor. Returns the index of the sample under the mouse, if it is over the
// curve. Marks have their labels where there is room.
std::optional<std::size_t> drawChart(const plot::Chart& chart, float width, float height);

}  // namespace fringe::preview
