#include "optics/transform.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "optics/integrals.hpp"

namespace fringe::optics {
namespace {

using glm::dvec2;
using std::numbers::pi;
using units::m;
using Complex = std::complex<double>;

double cross(dvec2 a, dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

double discArea(double diameter) {
    return 0.25 * pi * diameter * diameter;
}

double discTransform(double diameter, double frequency) {
    const double x = pi * diameter * frequency;
    return discArea(diameter) * (x < 1e-8 ? 1.0 : 2.0 * ::j1(x) / x);
}

// sin(x)/x - 1, with all its digits.
double sincLessOne(double x) {
    const double z = x * x;
    if (z > 0.25) return std::sin(x) / x - 1.0;
    return -z / 6.0 *
           (1.0 - z / 20.0 * (1.0 - z / 42.0 * (1.0 - z / 72.0 * (1.0 - z / 110.0 * (1.0 - z / 156.0)))));
}

double areaOf(const Slits& slits) {
    return slits.count * (slits.width / m);
}
double areaOf(const RectangularAperture& rectangle) {
    return (rectangle.width / m) * (rectangle.height / m);
}
double areaOf(const CircularAperture& circle) {
    return discArea(circle.diameter / m) - discArea(circle.innerDiameter / m);
}
double areaOf(const PolygonalAperture& polygon) {
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
        sum += cross(polygon.vertices[i], polygon.vertices[(i + 1) % polygon.vertices.size()]);
    return 0.5 * sum;
}
double areaOf(const LatticeAperture& lattice) {
    return double(lattice.firstCount) * lattice.secondCount *
           std::visit([](const auto& cell) { return areaOf(cell); }, lattice.cell);
}
double areaOf(const MaskAperture& mask) {
    double sum = 0.0;
    for (const float t : mask.transmission) sum += double(t) * t;
    return sum * (mask.pixel / m) * (mask.pixel / m);
}

Complex transformOf(const Slits& slits, dvec2 f) {
    const double width = slits.width / m;
    return width * sinc(width * f.x) * arrayFactor(slits.count, (slits.period / m) * f.x);
}
Complex transformOf(const RectangularAperture& rectangle, dvec2 f) {
    return areaOf(rectangle) * sinc((rectangle.width / m) * f.x) * sinc((rectangle.height / m) * f.y);
}
Complex transformOf(const CircularAperture& circle, dvec2 f) {
    const double frequency = glm::length(f);
    return discTransform(circle.diameter / m, frequency) - discTransform(circle.innerDiameter / m, frequency);
}

// Green's theorem turns the integral into one around the edge. The edges' vectors add up to 0, so 1 may be
// taken from each phase factor: then no term outgrows the sum at small k, and no series is needed there.
Complex transformOf(const PolygonalAperture& polygon, dvec2 f) {
    const dvec2 k = 2.0 * pi * f;
    const double square = glm::dot(k, k);
    if (square == 0.0) return areaOf(polygon);
    Complex sum = 0.0;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const dvec2 from = polygon.vertices[i];
        const dvec2 to = polygon.vertices[(i + 1) % polygon.vertices.size()];
        const double phase = 0.5 * glm::dot(k, from + to);
        const double less = sincLessOne(0.5 * glm::dot(k, to - from));
        const double half = std::sin(0.5 * phase);
        sum += cross(k, to - from) *
               Complex(less - 2.0 * (1.0 + less) * half * half, -(1.0 + less) * std::sin(phase));
    }
    return Complex(0.0, 1.0) * sum / square;
}

Complex transformOf(const LatticeAperture& lattice, dvec2 f) {
    return std::visit([&](const auto& cell) { return transformOf(cell, f); }, lattice.cell) *
           arrayFactor(lattice.firstCount, glm::dot(f, lattice.first)) *
           arrayFactor(lattice.secondCount, glm::dot(f, lattice.second));
}

Complex transformOf(const MaskAperture& mask, dvec2 f) {
    const double pixel = mask.pixel / m;
    const Complex perColumn = std::polar(1.0, -2.0 * pi * pixel * f.x);
    Complex sum = 0.0;
    for (std::uint32_t row = 0; row < mask.rows; ++row) {
        const float* transmission = mask.transmission.data() + std::size_t{row} * mask.columns;
        Complex rowSum = 0.0;
        for (std::uint32_t column = mask.columns; column-- > 0;)
            rowSum = rowSum * perColumn + double(transmission[column]);
        const double x = 0.5 * (1.0 - double(mask.columns)) * pixel;
        const double y = (0.5 * (double(mask.rows) - 1.0) - row) * pixel;
        sum += rowSum * std::polar(1.0, -2.0 * pi * (f.x * x + f.y * y));
    }
    return sum * (pixel * pixel * sinc(pixel * f.x) * sinc(pixel * f.y));
}

}  // namespace

double area(const Aperture& aperture) {
    return std::visit([](const auto& shape) { return areaOf(shape); }, aperture);
}

Complex transform(const Aperture& aperture, dvec2 f_per_m) {
    return std::visit([&](const auto& shape) { return transformOf(shape, f_per_m); }, aperture);
}

PolygonalAperture asPolygon(const RectangularAperture& rectangle) {
    const double x = 0.5 * (rectangle.width / m), y = 0.5 * (rectangle.height / m);
    return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
}

Moments moments(const Cell& cell) {
    if (const auto* circle = std::get_if<CircularAperture>(&cell)) {
        const double outer = std::pow(circle->diameter / m, 4),
                     inner = std::pow(circle->innerDiameter / m, 4);
        const double second = pi / 64.0 * (outer - inner);
        return {areaOf(*circle), second, 0.0, second};
    }
    const auto* given = std::get_if<PolygonalAperture>(&cell);
    const PolygonalAperture polygon =
        given != nullptr ? *given : asPolygon(std::get<RectangularAperture>(cell));
    Moments sum{0.0, 0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const dvec2 a = polygon.vertices[i];
        const dvec2 b = polygon.vertices[(i + 1) % polygon.vertices.size()];
        const double twice = cross(a, b);
        sum.area += twice / 2.0;
        sum.xx += twice * (a.x * a.x + a.x * b.x + b.x * b.x) / 12.0;
        sum.yy += twice * (a.y * a.y + a.y * b.y + b.y * b.y) / 12.0;
        sum.xy += twice * (2.0 * (a.x * a.y + b.x * b.y) + a.x * b.y + b.x * a.y) / 24.0;
    }
    return sum;
}

}  // namespace fringe::optics
