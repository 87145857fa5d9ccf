#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <utility>
#include <variant>

#include "image/file_error.hpp"
#include "image/luminance_reader.hpp"
#include "scene/extract.hpp"
#include "scene/files.hpp"
#include "scene/polygon.hpp"

namespace fringe::scene {
namespace {

using glm::dvec2;
using optics::CircularAperture, optics::LatticeAperture, optics::MaskAperture, optics::PolygonalAperture,
    optics::RectangularAperture;

// Area of a polygon, or of the parallelogram between two vectors, in parts of the square of its size, below
// which its sides lie on one line.
constexpr double kFlat = 1e-6;

RectangularAperture rectangleApertureOf(const Node& node) {
    return {node["width"].length(), node["height"].length()};
}

CircularAperture circleOf(const Node& node) {
    return {node["diameter"].length(), {}};
}

CircularAperture ringOf(const Node& node) {
    const Node inner = node["inner_diameter"];
    const Node outer = node["diameter"];
    if (inner.length() >= outer.length()) {
        inner.refuse(
            fmt::format("\"inner_diameter\" is \"{}\"; write less than the diameter, which is \"{}\"",
                        inner.text(), outer.text()),
            {outer});
    }
    return {outer.length(), inner.length()};
}

// ---- polygons ------------------------------------------------------------------------------------

double sizeOf(const Polygon& polygon) {
    double size = 0.0;
    for (const dvec2& vertex : polygon) size = std::max(size, glm::length(vertex - polygon.front()));
    return size;
}

// The polygon counter-clockwise about its centroid.
PolygonalAperture polygonOfVertices(const Node& node) {
    Polygon polygon;
    for (const Node& vertex : node.elements()) polygon.push_back(vertex.lengths());
    const double size = sizeOf(polygon);
    if (const auto sides = crossing(polygon)) {
        const auto [first, second] = *sides;
        const std::size_t count = polygon.size();
        node.refuse(
            fmt::format("the side from [{}] to [{}] meets that from [{}] to [{}]; write the corners in "
                        "their order round the opening, each once",
                        first, (first + 1) % count, second, (second + 1) % count));
        return {};
    }
    const double area = signedArea(polygon);
    if (size < kSmallestSize || std::abs(area) < kFlat * size * size) {
        node.refuse("the vertices lie on one line; write three or more that span an area");
        return {};
    }
    const dvec2 middle = centroid(polygon);
    for (dvec2& vertex : polygon) vertex -= middle;
    if (area < 0.0) std::reverse(polygon.begin(), polygon.end());
    return {std::move(polygon)};
}

PolygonalAperture polygonOf(const Node& node) {
    if (node.has("vertices")) {
        for (const std::string_view key : {"sides", "diameter", "rotation"}) {
            if (!node.has(key)) continue;
            node[key].refuse(
                fmt::format("\"{}\" stands beside \"vertices\"; keep the vertices, or the keys of "
                            "a regular polygon",
                            key),
                {node["vertices"]});
        }
        return polygonOfVertices(node["vertices"]);
    }
    for (const std::string_view key : {"sides", "diameter"}) {
        if (node.has(key)) continue;
        node.refuse(fmt::format(
            "missing key \"{}\"; a polygon has \"sides\" and \"diameter\", or \"vertices\"", key));
        return {};
    }
    return {regularPolygon(node["sides"].count(), node["diameter"].length().si, node["rotation"].angle().si)};
}

// ---- lattices ------------------------------------------------------------------------------------

optics::Cell cellOf(const Node& node) {
    const std::string type = node["type"].text();
    if (type == "rectangle") return rectangleApertureOf(node);
    if (type == "circle") return circleOf(node);
    if (type == "ring") return ringOf(node);
    assert(type == "polygon");
    return polygonOf(node);
}

bool overlaps(const RectangularAperture& cell, const dvec2& shift) {
    return std::abs(shift.x) < (1.0 - kTouch) * cell.width.si &&
           std::abs(shift.y) < (1.0 - kTouch) * cell.height.si;
}

bool overlaps(const CircularAperture& cell, const dvec2& shift) {
    return glm::length(shift) < (1.0 - kTouch) * cell.diameter.si;
}

bool overlaps(const PolygonalAperture& cell, const dvec2& shift) {
    return scene::overlaps(cell.vertices, shift);
}

// Of the circle about 0 that covers the cell.
double diameterOf(const RectangularAperture& cell) {
    return std::hypot(cell.width.si, cell.height.si);
}
double diameterOf(const CircularAperture& cell) {
    return cell.diameter.si;
}
double diameterOf(const PolygonalAperture& cell) {
    double radius = 0.0;
    for (const dvec2& vertex : cell.vertices) radius = std::max(radius, glm::length(vertex));
    return 2.0 * radius;
}

// Looks at every copy whose middle is within a diameter of that of the first: in each row those about the
// foot of the perpendicular. By symmetry half of them are enough.
bool copiesOverlap(const LatticeAperture& lattice) {
    const double diameter = std::visit([](const auto& cell) { return diameterOf(cell); }, lattice.cell);
    const dvec2& first = lattice.first;
    const dvec2& second = lattice.second;
    const double rowDistance = std::abs(first.x * second.y - first.y * second.x) / glm::length(first);
    const double rows = std::min(lattice.secondCount - 1.0, std::floor(diameter / rowDistance));
    const double last = lattice.firstCount - 1.0;
    for (double row = 0.0; row <= rows; ++row) {
        const double middle = -row * glm::dot(first, second) / glm::dot(first, first);
        const double half = diameter / glm::length(first);
        const double begin = std::max(row == 0.0 ? 1.0 : -last, std::ceil(middle - half));
        const double end = std::min(last, std::floor(middle + half));
        for (double i = begin; i <= end; ++i) {
            const dvec2 shift = i * first + row * second;
            if (std::visit([&](const auto& cell) { return overlaps(cell, shift); }, lattice.cell))
                return true;
        }
    }
    return false;
}

LatticeAperture latticeOf(const Node& node) {
    const Node first = node["first"];
    const Node second = node["second"];
    LatticeAperture lattice{cellOf(node["cell"]), first.lengths(), second.lengths(),
                            node["first_count"].count(), node["second_count"].count()};
    const double across = std::abs(lattice.first.x * lattice.second.y - lattice.first.y * lattice.second.x);
    if (across <= kFlat * glm::length(lattice.first) * glm::length(lattice.second)) {
        second.refuse(
            "\"second\" is along \"first\", or one of them is 0; write two vectors that span an area",
            {first});
    } else if (copiesOverlap(lattice)) {
        node["cell"].refuse("the openings overlap; write a smaller cell, or longer vectors", {first, second});
    }
    return lattice;
}

// ---- masks ---------------------------------------------------------------------------------------

// What a pixel passes of the light is its luminance, so what it passes of the amplitude is the root of that.
MaskAperture maskOf(const Node& node) {
    const Node file = node["file"];
    try {
        const image::LuminancePicture picture = image::readLuminance(pathOf(file));
        MaskAperture mask{picture.width, picture.height, node["pixel"].length(), picture.values};
        for (float& value : mask.transmission) value = std::sqrt(value);
        if (std::all_of(mask.transmission.begin(), mask.transmission.end(),
                        [](float v) { return v == 0.0F; }))
            file.refuse("the picture is black and passes no light; write one with some white");
        return mask;
    } catch (const image::FileError& error) {
        file.refuse(error.what());
        return {};
    }
}

}  // namespace

optics::Aperture apertureOf(const Node& node) {
    const std::string type = node["type"].text();
    if (type == "slits") return slitsOf(node);
    if (type == "lattice") return latticeOf(node);
    if (type == "mask") return maskOf(node);
    return std::visit([](auto&& cell) -> optics::Aperture { return std::forward<decltype(cell)>(cell); },
                      cellOf(node));
}

}  // namespace fringe::scene
