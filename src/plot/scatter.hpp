// Points on two logarithmic axes, in series, as SVG or PNG: what is gained against what it costs, and which
// of the points none beats.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "image/file_error.hpp"
#include "plot/chart_file.hpp"

namespace fringe::plot {

struct ScatterPoint {
    double x;           // > 0
    double y;           // > 0
    std::string label;  // beside it, where it is on the front
};

struct ScatterSeries {
    std::string name;
    std::vector<ScatterPoint> points;
};

struct Scatter {
    std::string title;
    std::string subtitle;
    std::string xLabel;
    std::string yLabel;
    std::vector<ScatterSeries> series;  // with one point or more in all
    // Points that the series hold, each list in the order of its x: joined by a line and ringed; labelled
    // where there is but one list.
    std::vector<std::vector<ScatterPoint>> fronts;
};

// The file appears whole or not at all. Throws image::FileError. Precondition: isChartFile(path).
void writeScatter(const std::filesystem::path& path, const Scatter& scatter);

}  // namespace fringe::plot
