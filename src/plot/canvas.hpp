// What every drawing shares: a white sheet, lines and words on it, and its way into a file.
#pragma once

#include <cairo.h>

#include <filesystem>
#include <functional>
#include <string>

#include "image/file_error.hpp"
#include "plot/chart_file.hpp"

namespace fringe::plot {

// Points of 1/72 inch in SVG; a PNG has twice as many pixels.
inline constexpr double kWidth = 960.0, kHeight = 540.0;
inline constexpr double kTextSize = 12.0;

// A context whose unit is the point, y downwards.
class Canvas {
public:
    explicit Canvas(cairo_t* context) : cr_(context) {}

    cairo_t* context() const { return cr_; }

    void ink(double grey) const { cairo_set_source_rgb(cr_, grey, grey, grey); }

    void line(double x1, double y1, double x2, double y2) const;

    // `anchor`: 0 puts the text's beginning at the point, 0.5 its middle, 1 its end.
    void text(const std::string& words, double x, double y, double size, double anchor,
              double turn = 0.0) const;
    double widthOf(const std::string& words, double size) const;

    // At the top, beginning at `left`.
    void titles(const std::string& title, const std::string& subtitle, double left) const;

private:
    cairo_t* cr_;
};

// The file appears whole or not at all. Throws image::FileError. Precondition: isChartFile(path).
void writeDrawing(const std::filesystem::path& path, const std::function<void(const Canvas&)>& draw);

}  // namespace fringe::plot
