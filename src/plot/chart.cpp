#include "plot/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "plot/canvas.hpp"
#include "plot/ticks.hpp"

namespace fringe::plot {
namespace {

// The frame of the curve.
constexpr double kLeft = 88.0, kRight = kWidth - 24.0, kBottom = kHeight - 90.0;
constexpr double kStripTop = kHeight - 30.0, kStripBottom = kHeight - 10.0;

constexpr double kLegend = 58.0;  // of the second curve
constexpr double kBelowTitles = kLegend + 14.0;

constexpr double kLabelSpacing = 14.0;  // of labels that stand upright
constexpr double kLabelFoot = 21.0;     // where they stand above the frame
constexpr double kHeadroom = 1.06;      // the frame is this much higher than the curve

// Draws a chart.
class ChartDrawing : Canvas {
public:
    ChartDrawing(const Canvas& canvas, const Chart& chart)
        : Canvas(canvas),
          cr_(canvas.context()),
          chart_(chart),
          xMin_(chart.x.front()),
          xMax_(chart.x.back()) {
        const double highest = highestShown(chart.y, chart.reference.y);
        yMax_ = highest > 0.0 ? kHeadroom * highest : 1.0;
        double longest = 0.0;
        for (const Mark& mark : chart.marks) longest = std::max(longest, widthOf(mark.label, kTextSize));
        top_ = kBelowTitles + (chart.marks.empty() ? 0.0 : longest + kLabelFoot);
    }

    void run() {
        grid();
        reference();
        curve(chart_.y);
        cairo_set_source_rgb(cr_, 0.11, 0.25, 0.55);
        cairo_set_line_width(cr_, 1.3);
        cairo_stroke(cr_);
        frame();
        marks();
        strip();
        titles(chart_.title, chart_.subtitle, kLeft);
    }

private:
    double toX(double x) const { return kLeft + (x - xMin_) / (xMax_ - xMin_) * (kRight - kLeft); }
    double toY(double y) const { return kBottom - y / yMax_ * (kBottom - top_); }

    void grid() {
        cairo_set_line_width(cr_, 0.8);
        const Ticks across = ticksBetween(xMin_, xMax_, 10);
        for (const double x : across.values) {
            ink(0.9);
            line(toX(x), top_, toX(x), kBottom);
            ink(0.25);
            text(across.label(x), toX(x), kBottom + 16.0, kTextSize, 0.5);
        }
        const Ticks up = ticksBetween(0.0, yMax_, 5);
        for (const double y : up.values) {
            ink(0.9);
            line(kLeft, toY(y), kRight, toY(y));
            ink(0.25);
            text(up.label(y), kLeft - 6.0, toY(y) + 4.0, kTextSize, 1.0);
        }
        text(chart_.xLabel, 0.5 * (kLeft + kRight), kBottom + 36.0, kTextSize, 0.5);
        text(chart_.yLabel, 22.0, 0.5 * (top_ + kBottom), kTextSize, 0.5, -0.5 * std::numbers::pi);
    }

    void reference() {
        if (chart_.reference.y.empty()) return;
        cairo_save(cr_);
        cairo_rectangle(cr_, kLeft, top_, kRight - kLeft, kBottom - top_);
        cairo_clip(cr_);
        curve(chart_.reference.y);
        const auto stroke = [&] {
            cairo_set_source_rgb(cr_, 0.87, 0.45, 0.08);
            cairo_set_line_width(cr_, 2.2);
            cairo_stroke(cr_);
        };
        stroke();
        cairo_restore(cr_);
        constexpr double kSample = 24.0;  // of the line, before its label
        cairo_move_to(cr_, kLeft, kLegend - 4.0);
        cairo_rel_line_to(cr_, kSample, 0.0);
        stroke();
        ink(0.35);
        text(chart_.reference.label, kLeft + kSample + 6.0, kLegend, kTextSize, 0.0);
    }

    // The path of a curve: of more samples than can be seen, the least and the greatest of each quarter
    // point.
    void curve(const std::vector<double>& y) {
        const std::size_t count = chart_.x.size();
        const auto columns = static_cast<std::size_t>(4.0 * (kRight - kLeft));
        cairo_new_path(cr_);
        if (count <= 2 * columns) {
            for (std::size_t i = 0; i < count; ++i) cairo_line_to(cr_, toX(chart_.x[i]), toY(y[i]));
        } else {
            for (std::size_t column = 0; column < columns; ++column) {
                const std::size_t first = column * count / columns;
                const std::size_t last = (column + 1) * count / columns;
                const auto begin = y.begin();
                const auto [low, high] = std::minmax_element(begin + static_cast<std::ptrdiff_t>(first),
                                                             begin + static_cast<std::ptrdiff_t>(last));
                cairo_line_to(cr_, toX(chart_.x[first]), toY(*low));
                cairo_line_to(cr_, toX(chart_.x[first]), toY(*high));
            }
        }
    }

    void frame() {
        ink(0.25);
        cairo_set_line_width(cr_, 1.0);
        cairo_rectangle(cr_, kLeft, top_, kRight - kLeft, kBottom - top_);
        cairo_stroke(cr_);
    }

    // Labels stand upright over the frame, in the order of their marks and pushed apart, a thin line from
    // each to its mark.
    void marks() {
        const double least = kLeft + 6.0, most = kRight - 4.0;
        std::vector<const Mark*> shown;
        for (const Mark& mark : chart_.marks) shown.push_back(&mark);
        std::stable_sort(shown.begin(), shown.end(),
                         [](const Mark* a, const Mark* b) { return a->y > b->y; });
        const auto room = static_cast<std::size_t>((most - least) / kLabelSpacing);
        if (shown.size() > room) shown.resize(room);
        std::sort(shown.begin(), shown.end(), [](const Mark* a, const Mark* b) { return a->x < b->x; });

        std::vector<double> places;
        for (const Mark* mark : shown) {
            const double free = places.empty() ? least : places.back() + kLabelSpacing;
            places.push_back(std::max(toX(mark->x), free));
        }
        double free = most;
        for (std::size_t i = places.size(); i-- > 0; free = places[i] - kLabelSpacing)
            places[i] = std::min(places[i], free);

        const double knee = top_ - 6.0, foot = top_ - kLabelFoot + 3.0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const double x = toX(shown[i]->x), y = toY(shown[i]->y);
            cairo_set_source_rgb(cr_, 0.75, 0.3, 0.2);
            cairo_set_line_width(cr_, 0.7);
            cairo_move_to(cr_, x, y - 3.0);
            cairo_line_to(cr_, x, knee);
            cairo_line_to(cr_, places[i], foot);
            cairo_stroke(cr_);
            ink(0.1);
            text(shown[i]->label, places[i] + 4.0, foot - 3.0, kTextSize, 0.0, -0.5 * std::numbers::pi);
        }
    }

    void strip() {
        if (chart_.strip.empty()) return;
        const double width = (kRight - kLeft) / static_cast<double>(chart_.strip.size());
        cairo_set_antialias(cr_, CAIRO_ANTIALIAS_NONE);  // or seams would show between the columns
        for (std::size_t i = 0; i < chart_.strip.size();) {
            std::size_t end = i + 1;
            while (end < chart_.strip.size() && chart_.strip[end] == chart_.strip[i]) ++end;
            const auto& [r, g, b] = chart_.strip[i];
            cairo_set_source_rgb(cr_, r / 255.0, g / 255.0, b / 255.0);
            cairo_rectangle(cr_, kLeft + width * static_cast<double>(i), kStripTop,
                            width * static_cast<double>(end - i), kStripBottom - kStripTop);
            cairo_fill(cr_);
            i = end;
        }
        cairo_set_antialias(cr_, CAIRO_ANTIALIAS_DEFAULT);
    }

    cairo_t* cr_;
    const Chart& chart_;
    double xMin_, xMax_, yMax_;
    double top_;  // of the curve's frame
};

}  // namespace

double highestShown(std::span<const double> y, std::span<const double> reference) {
    constexpr double kRoom = 1.5;  // for a reference, times the curve
    const double highest = *std::max_element(y.begin(), y.end());
    if (reference.empty()) return highest;
    const double other = *std::max_element(reference.begin(), reference.end());
    return highest > 0.0 ? std::max(highest, std::min(other, kRoom * highest)) : other;
}

void writeChart(const std::filesystem::path& path, const Chart& chart) {
    assert(chart.x.size() >= 2 && chart.x.size() == chart.y.size());
    writeDrawing(path, [&](const Canvas& canvas) { ChartDrawing(canvas, chart).run(); });
}

}  // namespace fringe::plot
