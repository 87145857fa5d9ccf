#include "oracle/opening_share.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "oracle/beam.hpp"
#include "oracle/quadrature.hpp"

namespace fringe::oracle {
namespace {

using glm::dvec2;
using std::numbers::pi;

constexpr double kLargest_wavelengths = 12.0;

// Polar coordinates about the normal, two panels of radius and 16 angles for each wavelength of the extent.
double overAllDirections(const OpeningShape& shape, const scene::Beam& beam, double wavelength,
                         const dvec2& incident) {
    const double size = extent(shape) / wavelength;
    const Opening opening(shape, (1.0 + glm::length(incident)) / wavelength, beam);
    const auto panels = static_cast<std::size_t>(std::ceil(2.0 * size)) + 1;
    const int angles = 32 + 16 * static_cast<int>(std::ceil(size));
    double sum = 0.0;
    forNodes(0.0, 1.0, panels, [&](double radius, double weight) {
        for (int i = 0; i < angles; ++i) {
            const double angle = 2.0 * pi * i / angles;
            const dvec2 direction = radius * dvec2(std::cos(angle), std::sin(angle));
            sum += weight * radius * 2.0 * pi / angles *
                   std::norm(opening.amplitude((direction - incident) / wavelength));
        }
    });
    return sum / (wavelength * wavelength * openArea(shape, beam));
}

// A straight piece of an outline, and the square of the step in amplitude across it.
struct Edge {
    dvec2 along;
    double step;
    dvec2 middle;
};

// As many pieces that a beam is even along each.
void addPieces(const dvec2& from, const dvec2& to, std::vector<Edge>& edges) {
    constexpr int kPieces = 64;
    const dvec2 piece = (to - from) / static_cast<double>(kPieces);
    for (int i = 0; i < kPieces; ++i) edges.push_back({piece, 1.0, from + (i + 0.5) * piece});
}

std::vector<Edge> edges(const optics::PolygonalAperture& polygon) {
    std::vector<Edge> result;
    const auto& vertices = polygon.vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        addPieces(vertices[i], vertices[(i + 1) % vertices.size()], result);
    return result;
}

std::vector<Edge> edges(const optics::RectangularAperture& rectangle) {
    const dvec2 half = 0.5 * dvec2(rectangle.width.si, rectangle.height.si);
    return edges(optics::PolygonalAperture{{-half, {half.x, -half.y}, half, {-half.x, half.y}}});
}

std::vector<Edge> edges(const optics::CircularAperture& circle) {
    constexpr int kPieces = 64;
    std::vector<Edge> result;
    for (const double diameter : {circle.diameter.si, circle.innerDiameter.si}) {
        for (int i = 0; i < kPieces; ++i) {
            const double angle = 2.0 * pi * i / kPieces;
            const dvec2 outwards(std::cos(angle), std::sin(angle));
            result.push_back(
                {pi * diameter / kPieces * dvec2(-outwards.y, outwards.x), 1.0, 0.5 * diameter * outwards});
        }
    }
    return result;
}

std::vector<Edge> edges(const optics::MaskAperture& mask) {
    const auto at = [&](std::int64_t column, std::int64_t row) {
        if (column < 0 || row < 0 || column >= mask.columns || row >= mask.rows) return 0.0;
        return double{mask.transmission[static_cast<std::size_t>(row * mask.columns + column)]};
    };
    double upright = 0.0;
    double level = 0.0;
    for (std::int64_t row = 0; row <= mask.rows; ++row) {
        for (std::int64_t column = 0; column <= mask.columns; ++column) {
            upright += std::pow(at(column, row) - at(column - 1, row), 2);
            level += std::pow(at(column, row) - at(column, row - 1), 2);
        }
    }
    return {{{0.0, mask.pixel.si}, upright, dvec2(0.0)}, {{mask.pixel.si, 0.0}, level, dvec2(0.0)}};
}

// Across an edge the amplitude falls off as step / (2 pi frequency). What lies beyond the horizon, on both
// sides of the incident direction, adds up to step^2 length wavelength conical / (2 pi^2 gamma^2).
double fromEdges(const OpeningShape& shape, const scene::Beam& beam, double wavelength,
                 const dvec2& incident) {
    const double gammaSquared = 1.0 - glm::dot(incident, incident);
    double missing = 0.0;
    const auto ofShape = [](const auto& s) {
        if constexpr (requires { edges(s); }) return edges(s);
        else return std::vector<Edge>();
    };
    for (const auto& [along, step, middle] : std::visit(ofShape, shape)) {
        const double length = glm::length(along);
        if (length == 0.0) continue;
        const double alongEdge = glm::dot(incident, along) / length;
        const double conical = std::sqrt(1.0 - alongEdge * alongEdge);
        const double lit =
            beam.profile == scene::BeamProfile::gaussian ? relativeIrradiance(beam, middle.x, middle.y) : 1.0;
        missing += step * lit * length * wavelength * conical / (2.0 * pi * pi * gammaSquared);
    }
    return 1.0 - missing / openArea(shape, beam);
}

// An endless lattice sends all light into its orders, each with the share that its cell gives it.
double overOrders(const optics::LatticeAperture& lattice, double wavelength, const dvec2& incident) {
    const dvec2& first = lattice.first;
    const dvec2& second = lattice.second;
    const double area = first.x * second.y - first.y * second.x;  // of the lattice per cell, signed
    const dvec2 alongFirst = dvec2(second.y, -second.x) / area;   // reciprocal vectors
    const dvec2 alongSecond = dvec2(-first.y, first.x) / area;
    const OpeningShape cell = std::visit([](const auto& c) -> OpeningShape { return c; }, lattice.cell);
    const Opening opening(cell, 2.0 / wavelength);

    // An order that propagates has a frequency of less than 2 / wavelength, and its number is that times the
    // lattice's vector.
    const auto most = [&](const dvec2& step) {
        return static_cast<int>(std::ceil(2.0 * glm::length(step) / wavelength));
    };
    double sum = 0.0;
    for (int i = -most(first); i <= most(first); ++i) {
        for (int j = -most(second); j <= most(second); ++j) {
            const dvec2 turns = static_cast<double>(i) * alongFirst + static_cast<double>(j) * alongSecond;
            const dvec2 direction = incident + wavelength * turns;
            if (glm::dot(direction, direction) < 1.0) sum += std::norm(opening.amplitude(turns));
        }
    }
    return sum / (std::abs(area) * openArea(cell));
}

// A lattice with so few cells that the whole of it is small, one at least: more of them make the orders
// narrower, and the share little different.
OpeningShape reduced(const OpeningShape& shape, double wavelength) {
    OpeningShape result = shape;
    if (auto* lattice = std::get_if<optics::LatticeAperture>(&result)) {
        const double room = std::max(0.0, kLargest_wavelengths * wavelength - cellExtent(shape));
        const auto fitting = [&](std::uint32_t count, const dvec2& step) {
            const double most = 1.0 + std::floor(room / (glm::length(step) * std::numbers::sqrt2));
            return static_cast<std::uint32_t>(std::min<double>(count, most));
        };
        lattice->firstCount = fitting(lattice->firstCount, lattice->first);
        lattice->secondCount = fitting(lattice->secondCount, lattice->second);
    }
    return result;
}

}  // namespace

bool isEndless(const OpeningShape& shape, double wavelength) {
    const auto* lattice = std::get_if<optics::LatticeAperture>(&shape);
    if (!lattice) return false;
    const OpeningShape judged = reduced(shape, wavelength);
    const auto& few = std::get<optics::LatticeAperture>(judged);
    return 1 < few.firstCount && few.firstCount < lattice->firstCount && 1 < few.secondCount &&
           few.secondCount < lattice->secondCount;
}

double propagatingShare(const OpeningShape& shape, double wavelength, const dvec2& incident) {
    scene::Beam even{};
    even.profile = scene::BeamProfile::flat;
    return propagatingShare(shape, even, wavelength, incident);
}

double propagatingShare(const OpeningShape& shape, const scene::Beam& beam, double wavelength,
                        const dvec2& incident) {
    if (isEndless(shape, wavelength))
        return overOrders(std::get<optics::LatticeAperture>(shape), wavelength, incident);
    const OpeningShape judged = reduced(shape, wavelength);
    if (extent(judged) <= 1.05 * kLargest_wavelengths * wavelength)
        return overAllDirections(judged, beam, wavelength, incident);
    // What a cell's edges keep back of the cell's light is the same in all.
    if (const auto* lattice = std::get_if<optics::LatticeAperture>(&judged)) {
        const OpeningShape cell = std::visit([](const auto& c) -> OpeningShape { return c; }, lattice->cell);
        scene::Beam even{};
        even.profile = scene::BeamProfile::flat;
        return fromEdges(cell, even, wavelength, incident);
    }
    return fromEdges(judged, beam, wavelength, incident);
}

}  // namespace fringe::oracle
