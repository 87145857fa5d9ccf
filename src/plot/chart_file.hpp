// The formats of drawings.
#pragma once

#include <filesystem>

namespace fringe::plot {

// Whether the extension names one of them, .svg or .png in any case.
bool isChartFile(const std::filesystem::path& path);

}  // namespace fringe::plot
