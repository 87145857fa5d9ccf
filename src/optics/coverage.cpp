#include "optics/coverage.hpp"

#include <algorithm>
#include <cmath>

namespace fringe::optics {
namespace {

using glm::dvec2;

// Integrals of 1, x and y over a part of a pixel, about its upper left corner.
struct Integrals {
    double area = 0.0, x = 0.0, y = 0.0;

    Integrals& operator+=(const Integrals& other) {
        area += other.area;
        x += other.x;
        y += other.y;
        return *this;
    }
};

// By Green's theorem: each piece of an outline adds what lies to the right of it, with the sign of its way
// down.
class Sum {
public:
    Sum(std::uint32_t columns, std::uint32_t rows)
        : columns_(columns),
          rows_(rows),
          inside_(std::size_t{columns} * rows),
          beyond_(std::size_t{columns + 1} * rows) {}

    void addEdge(dvec2 from, dvec2 to) {
        cut(from.y, to.y, rows_, [&](double a, double b) {
            const dvec2 start = from + a * (to - from), end = from + b * (to - from);
            const double row = std::floor(0.5 * (start.y + end.y));
            if (row < 0.0 || row >= rows_) return;
            cut(start.x, end.x, columns_, [&](double c, double d) {
                addPiece(start + c * (end - start), start + d * (end - start), row);
            });
        });
    }

    std::vector<Covered> covered() const {
        std::vector<Covered> result;
        result.reserve(inside_.size());
        double whole = 0.0;
        for (std::uint32_t row = 0; row < rows_; ++row) {
            Integrals before;
            for (std::uint32_t column = 0; column < columns_; ++column) {
                before += beyond_[std::size_t{row} * (columns_ + 1) + column];
                Integrals pixel = inside_[std::size_t{row} * columns_ + column];
                pixel += before;
                whole += pixel.area;
                const bool isEmpty = std::abs(pixel.area) < 1e-12;
                result.push_back({isEmpty ? 0.0 : pixel.area,
                                  isEmpty ? dvec2(0.0) : dvec2(pixel.x, pixel.y) / pixel.area - 0.5});
            }
        }
        if (whole < 0.0)
            for (Covered& pixel : result) pixel.share = -pixel.share;
        return result;
    }

private:
    // Calls use(a, b) for the parts of [0, 1] between which a coordinate that goes from `from` to `to` passes
    // whole numbers, of 0 to `last`.
    template <class Use>
    static void cut(double from, double to, double last, const Use& use) {
        double at = 0.0;
        const double step = to > from ? 1.0 : -1.0;
        if (from != to) {
            const double first = step > 0.0 ? std::floor(std::max(from, -1.0)) + 1.0
                                            : std::ceil(std::min(from, last + 1.0)) - 1.0;
            for (double line = first; line >= 0.0 && line <= last && step * (to - line) > 0.0; line += step) {
                const double next = (line - from) / (to - from);
                use(at, next);
                at = next;
            }
        }
        use(at, 1.0);
    }

    // Within one row, and one column unless to the left or the right of all.
    void addPiece(dvec2 from, dvec2 to, double row) {
        const double column = std::floor(0.5 * (from.x + to.x));
        if (column >= columns_) return;
        const double left = std::max(column, 0.0);
        const auto limited = [&](dvec2 at) { return dvec2(column < 0.0 ? 0.0 : at.x - left, at.y - row); };
        const dvec2 a = limited(from), b = limited(to);
        const double fall = b.y - a.y, shift = b.x - a.x;
        const double y = 0.5 * fall * (a.y + b.y);
        const auto at = static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(left);
        inside_[at] +=
            {fall * (1.0 - 0.5 * (a.x + b.x)), 0.5 * fall * (1.0 - (a.x * a.x + a.x * b.x + b.x * b.x) / 3.0),
             fall * (a.y * (1.0 - a.x) + 0.5 * (fall * (1.0 - a.x) - a.y * shift) - fall * shift / 3.0)};
        beyond_[at + static_cast<std::size_t>(row) + 1] += {fall, 0.5 * fall, y};
    }

    std::uint32_t columns_;
    std::uint32_t rows_;
    std::vector<Integrals> inside_;  // of the pixels that pieces of an outline lie in
    std::vector<Integrals> beyond_;  // of all pixels from there on to the right
};

}  // namespace

std::vector<Covered> coverage(std::span<const std::vector<dvec2>> outlines, std::uint32_t columns,
                              std::uint32_t rows) {
    Sum sum(columns, rows);
    for (const std::vector<dvec2>& outline : outlines)
        for (std::size_t i = 0; i < outline.size(); ++i)
            sum.addEdge(outline[i], outline[(i + 1) % outline.size()]);
    return sum.covered();
}

}  // namespace fringe::optics
