// Lattices. Many cells send light into orders, whose sum is the share of an infinite lattice; what finite
// numbers of cells change is c1/firstCount + c2/secondCount and less, and each c comes from a lattice that is
// finite in one direction alone, a sum of line integrals. Where cells are far apart, which makes many orders,
// the share is that of one cell, and a little that neighbours change in it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "optics/integrals.hpp"
#include "optics/shares.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {
namespace {

using glm::dvec2;

// From this number of orders among the propagating frequencies on, and this many wavelengths from a cell to
// the next, neighbours change little enough for shareOfNeighbours().
constexpr double kManyOrders = 2000.0;
constexpr double kFarApart = 12.0;

// The finite lattice that c1 or c2 is found from has at most this many cells.
constexpr std::uint32_t kMostFinite = 8;

double power(const Cell& cell, dvec2 f) {
    return std::visit([&](const auto& shape) { return std::norm(transform(shape, f)); }, cell);
}

double areaOf(const Cell& cell) {
    return std::visit([](const auto& shape) { return area(shape); }, cell);
}

double extentOf(const Cell& cell) {
    if (const auto* rectangle = std::get_if<RectangularAperture>(&cell))
        return std::hypot(rectangle->width / units::m, rectangle->height / units::m);
    if (const auto* circle = std::get_if<CircularAperture>(&cell)) return circle->diameter / units::m;
    double radius = 0.0;
    for (const dvec2& vertex : std::get<PolygonalAperture>(cell).vertices)
        radius = std::max(radius, glm::length(vertex));
    return 2.0 * radius;
}

bool isSparse(const LatticeAperture& lattice, double determinant, double wavelength) {
    const double nearest =
        std::min({glm::length(lattice.first), glm::length(lattice.second),
                  glm::length(lattice.first + lattice.second), glm::length(lattice.first - lattice.second)});
    return std::numbers::pi * std::abs(determinant) > kManyOrders * wavelength * wavelength &&
           nearest > kFarApart * wavelength;
}

// The orders of one direction of the lattice are lines in the plane of frequencies: order n along `spacing`
// n, and on each t steps of `along`. Both are columns of the inverse of the lattice's own vectors.
struct Lines {
    dvec2 spacing;
    dvec2 along;
};

// Where a line crosses the edge of what propagates; empty (from >= to) where it does not.
struct Section {
    double from;
    double to;
};

Section propagating(const Lines& lines, double order, const Incidence& in) {
    const dvec2 start = in.direction + in.wavelength * order * lines.spacing;
    const dvec2 step = in.wavelength * lines.along;
    const double a = glm::dot(step, step), b = glm::dot(start, step), c = glm::dot(start, start) - 1.0;
    const double discriminant = b * b - a * c;
    if (discriminant <= 0.0) return {0.0, 0.0};
    return {(-b - std::sqrt(discriminant)) / a, (-b + std::sqrt(discriminant)) / a};
}

// Calls with the number of each line that holds propagating directions, and the section of it.
template <class Visit>
void forEachLine(const Lines& lines, const Incidence& in, Visit visit) {
    // Neighbouring lines lie this far apart.
    const dvec2 across = dvec2(-lines.along.y, lines.along.x) / glm::length(lines.along);
    const double distance = in.wavelength * std::abs(glm::dot(lines.spacing, across));
    const auto last = static_cast<int>((1.0 + glm::length(in.direction)) / distance) + 1;
    for (int order = -last; order <= last; ++order) {
        const Section section = propagating(lines, order, in);
        if (section.from < section.to) visit(double(order), section);
    }
}

double orders(const Cell& cell, const Lines& lines, double perArea, const Incidence& in) {
    double sum = 0.0;
    forEachLine(lines, in, [&](double order, Section section) {
        for (double t = std::ceil(section.from); t <= section.to; ++t)
            sum += power(cell, order * lines.spacing + t * lines.along);
    });
    return sum * perArea;
}

// `count` cells along the lines' own direction, infinitely many along the other.
double finiteAlong(const Cell& cell, const Lines& lines, std::uint32_t count, double perArea,
                   const Incidence& in) {
    static const GaussRule rule = gaussLegendre(6);
    double sum = 0.0;
    forEachLine(lines, in, [&](double order, Section section) {
        const double length = section.to - section.from;
        const auto panels = static_cast<int>(count * length) + 2;
        const double half = 0.5 * length / panels;
        for (int panel = 0; panel < panels; ++panel) {
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const double t = section.from + (2.0 * panel + 1.0 + rule.nodes[i]) * half;
                const double array = arrayFactor(count, t);
                sum += half * rule.weights[i] * array * array / count *
                       power(cell, order * lines.spacing + t * lines.along);
            }
        }
    });
    return sum * perArea;
}

}  // namespace

double shareOf(const LatticeAperture& lattice, const Incidence& in) {
    const double firstCount = lattice.firstCount, secondCount = lattice.secondCount;
    const double extent = extentOf(lattice.cell) + (firstCount - 1.0) * glm::length(lattice.first) +
                          (secondCount - 1.0) * glm::length(lattice.second);
    if (extent < kLargestExtent * in.wavelength) return shareByQuadrature(lattice, extent, in);

    const double determinant = lattice.first.x * lattice.second.y - lattice.first.y * lattice.second.x;
    if (isSparse(lattice, determinant, in.wavelength)) {
        const double own = std::visit([&](const auto& cell) { return shareOf(cell, in); }, lattice.cell);
        return own + shareOfNeighbours(lattice, extentOf(lattice.cell), in);
    }
    const dvec2 toFirst = dvec2(lattice.second.y, -lattice.second.x) / determinant;
    const dvec2 toSecond = dvec2(-lattice.first.y, lattice.first.x) / determinant;
    const double perArea = 1.0 / (areaOf(lattice.cell) * std::abs(determinant));

    const double infinite = orders(lattice.cell, {toFirst, toSecond}, perArea, in);
    const std::uint32_t first = std::min(lattice.firstCount, kMostFinite);
    const std::uint32_t second = std::min(lattice.secondCount, kMostFinite);
    const double finiteFirst = finiteAlong(lattice.cell, {toSecond, toFirst}, first, perArea, in);
    const double finiteSecond = finiteAlong(lattice.cell, {toFirst, toSecond}, second, perArea, in);
    return infinite + (finiteFirst - infinite) * first / firstCount +
           (finiteSecond - infinite) * second / secondCount;
}

}  // namespace fringe::optics
