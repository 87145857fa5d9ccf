// How much of a beam an aperture in its middle lets through.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "optics/energy.hpp"
#include "optics/integrals.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {
namespace {

using glm::dvec2;
using std::numbers::pi;
using units::m;

// Width, height and shape of a beam; 1/e^2 diameters of a Gaussian.
struct Profile {
    double width;
    double height;
    BeamProfile shape;
};

// Irradiance at a point, per watt.
double irradiance(const Profile& beam, dvec2 at) {
    if (beam.shape == BeamProfile::rectangle) return 1.0 / (beam.width * beam.height);
    const double area = 0.25 * pi * beam.width * beam.width;
    if (beam.shape == BeamProfile::flat) return 1.0 / area;
    return 2.0 / area * std::exp(-8.0 * glm::dot(at, at) / (beam.width * beam.width));
}

// Share of the power at x' < x.
double upTo(const Profile& beam, double x) {
    const double place = 2.0 * x / beam.width;
    if (beam.shape == BeamProfile::gaussian) return 0.5 * (1.0 + std::erf(std::sqrt(2.0) * place));
    const double inside = std::clamp(place, -1.0, 1.0);
    if (beam.shape == BeamProfile::rectangle) return 0.5 * (1.0 + inside);
    return 0.5 + (inside * std::sqrt(1.0 - inside * inside) + std::asin(inside)) / pi;
}

double fractionOf(const Slits& slits, const Profile& beam) {
    const double period = slits.period / m, half = 0.5 * (slits.width / m);
    const double middle = 0.5 * (double(slits.count) - 1.0);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < slits.count; ++i) {
        const double x = (i - middle) * period;
        sum += upTo(beam, x + half) - upTo(beam, x - half);
    }
    return sum;
}

double fractionOf(const CircularAperture& circle, const Profile& beam) {
    const double outer = (circle.diameter / m) / beam.width, inner = (circle.innerDiameter / m) / beam.width;
    if (beam.shape != BeamProfile::gaussian) return area(circle) * irradiance(beam, dvec2(0.0));
    return std::exp(-2.0 * inner * inner) - std::exp(-2.0 * outer * outer);
}

// Green's theorem: the integral of the beam across x up to the edge, around the edge.
double fractionOf(const PolygonalAperture& polygon, const Profile& beam) {
    if (beam.shape != BeamProfile::gaussian) return area(polygon) * irradiance(beam, dvec2(0.0));
    static const GaussRule rule = gaussLegendre(12);
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const dvec2 from = polygon.vertices[i];
        const dvec2 edge = polygon.vertices[(i + 1) % polygon.vertices.size()] - from;
        const auto panels = static_cast<int>(std::min(4.0 * glm::length(edge) / beam.width, 1000.0)) + 1;
        for (int panel = 0; panel < panels; ++panel) {
            for (std::size_t node = 0; node < rule.nodes.size(); ++node) {
                const dvec2 at = from + (panel + 0.5 * (1.0 + rule.nodes[node])) / panels * edge;
                const double along = std::sqrt(8.0 / pi) / beam.width *
                                     std::exp(-8.0 * at.y * at.y / (beam.width * beam.width));
                sum += 0.5 * rule.weights[node] / panels * edge.y * upTo(beam, at.x) * along;
            }
        }
    }
    return sum;
}

double fractionOf(const RectangularAperture& rectangle, const Profile& beam) {
    return fractionOf(asPolygon(rectangle), beam);
}

// Cell by cell, with the beam a parabola over each: relative error (cell/beam)^4.
double fractionOf(const LatticeAperture& lattice, const Profile& beam) {
    const Moments cell = moments(lattice.cell);
    const double curvature = beam.shape == BeamProfile::gaussian ? 16.0 / (beam.width * beam.width) : 0.0;
    double sum = 0.0;
    for (std::uint32_t i = 0; i < lattice.firstCount; ++i) {
        for (std::uint32_t j = 0; j < lattice.secondCount; ++j) {
            const dvec2 at = (i - 0.5 * (double(lattice.firstCount) - 1.0)) * lattice.first +
                             (j - 0.5 * (double(lattice.secondCount) - 1.0)) * lattice.second;
            const double second = (curvature * at.x * at.x - 1.0) * cell.xx +
                                  2.0 * curvature * at.x * at.y * cell.xy +
                                  (curvature * at.y * at.y - 1.0) * cell.yy;
            sum += irradiance(beam, at) * (cell.area + 0.5 * curvature * second);
        }
    }
    return sum;
}

double fractionOf(const MaskAperture& mask, const Profile& beam) {
    const double pixel = mask.pixel / m;
    double sum = 0.0;
    for (std::uint32_t row = 0; row < mask.rows; ++row) {
        const double y = (0.5 * (double(mask.rows) - 1.0) - row) * pixel;
        for (std::uint32_t column = 0; column < mask.columns; ++column) {
            const double x = (column - 0.5 * (double(mask.columns) - 1.0)) * pixel;
            const double amplitude = mask.transmission[std::size_t{row} * mask.columns + column];
            sum += amplitude * amplitude * irradiance(beam, {x, y});
        }
    }
    return sum * pixel * pixel;
}

}  // namespace

double centralIrradiance(double beamWidth, double beamHeight, BeamProfile profile) {
    return irradiance({beamWidth, beamHeight, profile}, dvec2(0.0));
}

double openFraction(const Aperture& aperture, double beamWidth, double beamHeight, BeamProfile profile) {
    const Profile beam{beamWidth, beamHeight, profile};
    return std::visit([&](const auto& opening) { return fractionOf(opening, beam); }, aperture);
}

}  // namespace fringe::optics
