#include "plot/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "plot/canvas.hpp"

namespace fringe::plot {
namespace {

constexpr double kRadius = 3.5;

// Told apart in light print and by most who see colours otherwise (Okabe and Ito, 2008).
struct Ink {
    double r, g, b;
};
constexpr std::array<Ink, 7> kInks{{{0.00, 0.45, 0.70},
                                    {0.84, 0.37, 0.00},
                                    {0.00, 0.62, 0.45},
                                    {0.80, 0.47, 0.65},
                                    {0.90, 0.62, 0.00},
                                    {0.34, 0.71, 0.91},
                                    {0.35, 0.35, 0.35}}};

// Whole decades around what is shown.
struct LogAxis {
    double first = std::numeric_limits<double>::infinity();  // powers of ten
    double last = -std::numeric_limits<double>::infinity();

    void include(double value) {
        first = std::min(first, std::floor(std::log10(value)));
        last = std::max(last, std::ceil(std::log10(value)));
    }

    // When all values are included: one decade at least.
    void close() { last = std::max(last, first + 1.0); }

    // 0 at the first power, 1 at the last.
    double place(double value) const { return (std::log10(value) - first) / (last - first); }
};

std::string powerOfTen(double exponent) {
    constexpr double kPlain = 3.0;  // 0.001 to 1000 are written out
    return std::abs(exponent) <= kPlain ? fmt::format("{:g}", std::pow(10.0, exponent))
                                        : fmt::format("1e{:.0f}", exponent);
}

class ScatterDrawing : Canvas {
    static constexpr double kLeft = 88.0, kRight = kWidth - 230.0, kTop = 60.0, kBottom = kHeight - 60.0;
    static constexpr double kLegend = kRight + 20.0;

public:
    ScatterDrawing(const Canvas& canvas, const Scatter& scatter)
        : Canvas(canvas), cr_(canvas.context()), scatter_(scatter) {
        for (const ScatterSeries& series : scatter.series) {
            for (const ScatterPoint& point : series.points) {
                x_.include(point.x);
                y_.include(point.y);
            }
        }
        x_.close();
        y_.close();
    }

    void run() {
        grid();
        fronts();
        for (std::size_t i = 0; i < scatter_.series.size(); ++i) series(i);
        labels();
        titles(scatter_.title, scatter_.subtitle, kLeft);
    }

private:
    double toX(double x) const { return kLeft + x_.place(x) * (kRight - kLeft); }
    double toY(double y) const { return kBottom - y_.place(y) * (kBottom - kTop); }

    // A line for each power of ten, fainter ones for its multiples where there is room.
    void grid() {
        cairo_set_line_width(cr_, 0.8);
        for (double power = x_.first; power <= x_.last; ++power) {
            for (int multiple = 1; multiple <= (power < x_.last ? 9 : 1); ++multiple) {
                const double x = toX(multiple * std::pow(10.0, power));
                ink(multiple == 1 ? 0.8 : 0.93);
                line(x, kTop, x, kBottom);
            }
            ink(0.25);
            text(powerOfTen(power), toX(std::pow(10.0, power)), kBottom + 16.0, kTextSize, 0.5);
        }
        for (double power = y_.first; power <= y_.last; ++power) {
            const double y = toY(std::pow(10.0, power));
            ink(0.8);
            line(kLeft, y, kRight, y);
            ink(0.25);
            text(powerOfTen(power), kLeft - 6.0, y + 4.0, kTextSize, 1.0);
        }
        text(scatter_.xLabel, 0.5 * (kLeft + kRight), kBottom + 38.0, kTextSize, 0.5);
        text(scatter_.yLabel, 22.0, 0.5 * (kTop + kBottom), kTextSize, 0.5, -0.5 * std::numbers::pi);
    }

    void frontLine(const std::vector<ScatterPoint>& front) {
        ink(0.7);
        cairo_new_path(cr_);
        for (const ScatterPoint& point : front) cairo_line_to(cr_, toX(point.x), toY(point.y));
        cairo_stroke(cr_);
    }

    void fronts() {
        cairo_set_line_width(cr_, 1.0);
        for (const auto& front : scatter_.fronts) frontLine(front);
        ink(0.1);
        for (const auto& front : scatter_.fronts)
            for (const ScatterPoint& point : front) ring(toX(point.x), toY(point.y));
        ring(kLegend, kBottom - 4.0);
        text("none is both faster and closer", kLegend + 12.0, kBottom, kTextSize, 0.0);
    }

    void ring(double x, double y) {
        cairo_new_path(cr_);
        cairo_arc(cr_, x, y, kRadius + 2.5, 0.0, 2.0 * std::numbers::pi);
        cairo_stroke(cr_);
    }

    void series(std::size_t number) {
        const Ink& color = kInks.at(number % kInks.size());
        const auto dot = [&](double x, double y) {
            cairo_set_source_rgb(cr_, color.r, color.g, color.b);
            cairo_new_path(cr_);
            cairo_arc(cr_, x, y, kRadius, 0.0, 2.0 * std::numbers::pi);
            cairo_fill(cr_);
        };
        for (const ScatterPoint& point : scatter_.series[number].points) dot(toX(point.x), toY(point.y));
        const double y = kTop + 12.0 + 18.0 * static_cast<double>(number);
        dot(kLegend, y - 4.0);
        ink(0.1);
        text(scatter_.series[number].name, kLegend + 12.0, y, kTextSize, 0.0);
    }

    // To the right of a point and above it, where the front has none. Of several fronts labels would cover
    // each other.
    void labels() {
        ink(0.1);
        if (scatter_.fronts.size() != 1) return;
        for (const ScatterPoint& point : scatter_.fronts.front()) {
            const bool right = x_.place(point.x) < 0.8;
            text(point.label, toX(point.x) + (right ? 8.0 : -8.0), toY(point.y) - 6.0, kTextSize,
                 right ? 0.0 : 1.0);
        }
    }

    cairo_t* cr_;
    const Scatter& scatter_;
    LogAxis x_, y_;
};

}  // namespace

void writeScatter(const std::filesystem::path& path, const Scatter& scatter) {
    assert(std::any_of(scatter.series.begin(), scatter.series.end(),
                       [](const ScatterSeries& series) { return !series.points.empty(); }));
    writeDrawing(path, [&](const Canvas& canvas) { ScatterDrawing(canvas, scatter).run(); });
}

}  // namespace fringe::plot
