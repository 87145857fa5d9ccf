// A curve as a chart, SVG or PNG, drawn by the same code: axes with round numbers, marks with labels above
// the frame, and under it a strip of colours.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "image/file_error.hpp"
#include "plot/chart_file.hpp"

namespace fringe::plot {

struct Mark {
    double x;
    double y;
    std::string label;
};

using Color = std::array<std::uint8_t, 3>;  // sRGB

// A second curve over the same x, dashed, under the first.
struct Reference {
    std::string label;
    std::vector<double> y;  // empty: none
};

struct Chart {
    std::string title;
    std::string subtitle;
    std::string xLabel;
    std::string yLabel;
    std::vector<double> x;  // ascending, two or more
    std::vector<double> y;  // 0 or more, as many
    Reference reference{};  // cut off where it rises high above the first
    std::vector<Mark> marks{};
    std::vector<Color> strip{};  // from the least x to the greatest, evenly; may be empty
};

// Columns that a strip is shown in.
inline constexpr std::size_t kStripColumns = 1600;

// The largest value that a chart of a curve and its reference (none: empty) has to show.
double highestShown(std::span<const double> y, std::span<const double> reference);

// Where there is no room for all marks, the highest have labels. The file appears whole or not at all. Throws
// image::FileError. Precondition: isChartFile(path).
void writeChart(const std::filesystem::path& path, const Chart& chart);

}  // namespace fringe::plot
