// What two cells of a lattice send into directions together. All their waves together have nothing in common,
// since the cells do not overlap; so it is less by what their evanescent waves have in common, which come
// from the edges. Over many wavelengths only those parts of the two edges count that face each other.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

#include "optics/integrals.hpp"
#include "optics/shares.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {
namespace {

using glm::dvec2;
using std::numbers::pi;
using units::m;
using Complex = std::complex<double>;

// Cells further apart than this many steps along either row are left out, and fade up to there.
constexpr int kFarthest = 64;

// Edges at a greater angle, as its sine, do not face each other.
constexpr double kLargestSlope = 0.2;

// Two edges that face each other when the second's cell is moved: stretches along the first one, from
// `normal`'s point of view its right-hand side, and the distances between them.
struct Facing {
    dvec2 along;
    dvec2 normal;
    double first[2];  // along the first edge
    double second[2];
    double distance;  // from the first edge to the middle of the second, along the normal
    double slope;     // of the second edge
    double sign;      // 1: light lies on the same side of both
    double last[2];   // frequencies of the last propagating directions, along the normal and against it
};

std::vector<Facing> facings(const PolygonalAperture& polygon, const Incidence& in) {
    const std::size_t count = polygon.vertices.size();
    const auto vertex = [&](std::size_t i) { return polygon.vertices[i % count]; };
    std::vector<Facing> found;
    for (std::size_t i = 0; i < count; ++i) {
        const dvec2 along = glm::normalize(vertex(i + 1) - vertex(i));
        const dvec2 normal(along.y, -along.x);
        for (std::size_t j = 0; j < count; ++j) {
            const dvec2 other = vertex(j + 1) - vertex(j);
            if (std::abs(glm::dot(normal, other)) > kLargestSlope * glm::length(other)) continue;
            const double from = glm::dot(along, vertex(j)), to = glm::dot(along, vertex(j + 1));
            found.push_back({along,
                             normal,
                             {glm::dot(along, vertex(i)), glm::dot(along, vertex(i + 1))},
                             {std::min(from, to), std::max(from, to)},
                             glm::dot(normal, 0.5 * (vertex(j) + vertex(j + 1)) - vertex(i)),
                             glm::dot(normal, other) / glm::dot(along, other),
                             std::copysign(1.0, glm::dot(along, other)),
                             {reach(in, normal) / in.wavelength, reach(in, -normal) / in.wavelength}});
        }
    }
    return found;
}

// The integral over frequencies beyond the last propagating ones of what the facing parts have in common: of
// the length l and at the distance g, l cos(2 pi g f)/(4 pi^2 f^2).
double evanescent(const Facing& facing, dvec2 displacement, double wavelength) {
    const double moved = glm::dot(facing.along, displacement);
    const double from = std::max(facing.first[0], facing.second[0] + moved);
    const double to = std::min(facing.first[1], facing.second[1] + moved);
    if (from >= to) return 0.0;
    const double middle = 0.5 * (from + to - facing.second[0] - facing.second[1]) - moved;
    const double distance =
        std::abs(facing.distance + glm::dot(facing.normal, displacement) + facing.slope * middle);
    double sum = 0.0;
    for (const double last : facing.last) {
        const double phase = 2.0 * pi * last * distance;
        sum += inverseSquareTail(phase, std::polar(1.0, phase)) / last;
    }
    // The mean over what the distance varies by.
    const double faded = (to - from) * sinc((to - from) * facing.slope / wavelength);
    return facing.sign * faded * sum / (4.0 * pi * pi);
}

// The integral of exp(i x t) t^(-5/2) from 1 on, by parts until a Fresnel integral is left.
Complex fivePowersTail(double x) {
    const Complex turn = std::polar(1.0, x);
    if (x < 1e-9) return 2.0 / 3.0;
    const Complex rest =
        std::sqrt(2.0 * pi / x) * (Complex(0.5, 0.5) - fresnelIntegrals(std::sqrt(2.0 * x / pi)));
    const Complex ix(0.0, x);
    return 2.0 / 3.0 * (turn + 2.0 * ix * (turn + ix * rest));
}

// The same of round cells: 2 pi f A(f)^2 J0(2 pi d f), by the first terms of the Bessel functions' asymptotic
// series, with the last frequency where the two cells are nearest.
double evanescent(const CircularAperture& circle, dvec2 displacement, const Incidence& in) {
    constexpr double kFarthestRim = 100.0;  // wavelengths; beyond, 1e-3 of what rims that touch have
    const double apart = glm::length(displacement);
    const double last = reach(in, displacement / apart) / in.wavelength;
    const auto wave = [&](double distance, double phase) {
        if (distance > kFarthestRim * in.wavelength) return 0.0;
        return (fivePowersTail(2.0 * pi * last * std::max(distance, 0.0)) * std::polar(1.0, phase)).real();
    };
    const double diameters[2] = {circle.diameter / m, circle.innerDiameter / m};
    double sum = 0.0;
    for (const double a : diameters) {
        for (const double b : diameters) {
            if (a == 0.0 || b == 0.0) continue;
            const double sign = a == b ? 1.0 : -1.0;
            sum += sign * std::sqrt(a * b / apart) *
                   (wave(apart + 0.5 * (a - b), -0.25 * pi) + wave(apart - 0.5 * (a - b), -0.25 * pi) -
                    wave(apart + 0.5 * (a + b), -0.75 * pi) - wave(apart - 0.5 * (a + b), 0.25 * pi));
        }
    }
    return sum / (4.0 * pi * pi * last * std::sqrt(last));
}

// What propagates, where one cell is in the far field of the other: the transform of all propagating
// frequencies, J1(2 pi d/wavelength)/(d wavelength) for large d, with the cell's power in the last direction.
double propagatingFar(const Aperture& cell, dvec2 displacement, const Incidence& in) {
    const double apart = glm::length(displacement);
    const dvec2 f = (displacement / apart - in.direction) / in.wavelength;
    return std::norm(transform(cell, f)) * std::cos(2.0 * pi * glm::dot(f, displacement) - 0.75 * pi) /
           (pi * apart * std::sqrt(apart * in.wavelength));
}

// Calls with all displacements of a cell from another and their numbers among pairs, relative to the number
// of cells.
template <class Visit>
void forEachDisplacement(const LatticeAperture& lattice, Visit visit) {
    const auto most = [](std::uint32_t count) { return std::min(static_cast<int>(count) - 1, kFarthest); };
    const auto pairs = [](int steps, std::uint32_t count) {
        return (1.0 - std::abs(steps) / double(count)) * (1.0 - std::pow(steps / (kFarthest + 1.0), 2));
    };
    const int mostFirst = most(lattice.firstCount), mostSecond = most(lattice.secondCount);
    for (int i = -mostFirst; i <= mostFirst; ++i)
        for (int j = -mostSecond; j <= mostSecond; ++j)
            if (i != 0 || j != 0)
                visit(double(i) * lattice.first + double(j) * lattice.second,
                      pairs(i, lattice.firstCount) * pairs(j, lattice.secondCount));
}

}  // namespace

double shareOfNeighbours(const LatticeAperture& lattice, double extent, const Incidence& in) {
    const Aperture cell = std::visit([](const auto& shape) -> Aperture { return shape; }, lattice.cell);
    const auto* circle = std::get_if<CircularAperture>(&lattice.cell);
    std::vector<Facing> all;
    if (const auto* rectangle = std::get_if<RectangularAperture>(&lattice.cell))
        all = facings(asPolygon(*rectangle), in);
    else if (const auto* polygon = std::get_if<PolygonalAperture>(&lattice.cell)) all = facings(*polygon, in);

    double sum = 0.0;
    forEachDisplacement(lattice, [&](dvec2 displacement, double pairs) {
        if (glm::length(displacement) * in.wavelength > 0.5 * extent * extent)
            sum += pairs * propagatingFar(cell, displacement, in);
        else if (circle != nullptr) sum -= pairs * evanescent(*circle, displacement, in);
        else
            for (const Facing& facing : all) sum -= pairs * evanescent(facing, displacement, in.wavelength);
    });
    return sum / area(cell);
}

}  // namespace fringe::optics
