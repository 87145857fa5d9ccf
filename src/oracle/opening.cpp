#include "oracle/opening.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "oracle/beam.hpp"
#include "oracle/quadrature.hpp"
#include "oracle/sinc.hpp"

namespace fringe::oracle {
namespace {

using Complex = std::complex<double>;
using glm::dvec2;
using std::numbers::pi;

// A panel of Gauss's rule takes a turn and a half, to 1e-14.
std::size_t panels(double length, double turnsPerMetre) {
    return 1 + static_cast<std::size_t>(length * turnsPerMetre / 1.5);
}

void addChords(std::vector<Chord>& chords, const optics::RectangularAperture& rectangle,
               double turnsPerMetre) {
    const double half = 0.5 * rectangle.width.si;
    const double halfHeight = 0.5 * rectangle.height.si;
    forNodes(-half, half, panels(2.0 * half, turnsPerMetre), [&](double x, double weight) {
        chords.push_back({x, -halfHeight, halfHeight, weight});
    });
}

// Even steps of the angle, where the chord's length has no root.
void addDisc(std::vector<Chord>& chords, double radius, double sign, double turnsPerMetre) {
    forNodes(-0.5 * pi, 0.5 * pi, 1 + panels(pi * radius, turnsPerMetre), [&](double angle, double weight) {
        const double half = radius * std::cos(angle);
        chords.push_back({radius * std::sin(angle), -half, half, sign * half * weight});
    });
}

void addChords(std::vector<Chord>& chords, const optics::CircularAperture& circle, double turnsPerMetre) {
    addDisc(chords, 0.5 * circle.diameter.si, 1.0, turnsPerMetre);
    if (circle.innerDiameter.si > 0.0) addDisc(chords, 0.5 * circle.innerDiameter.si, -1.0, turnsPerMetre);
}

// Between the heights where the line at `x` crosses the outline, by turns inside and outside.
void addChordsAt(std::vector<Chord>& chords, const std::vector<dvec2>& vertices, double x, double weight) {
    std::vector<double> crossings;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const dvec2& from = vertices[i];
        const dvec2& to = vertices[(i + 1) % vertices.size()];
        if ((from.x < x) == (to.x < x)) continue;
        crossings.push_back(from.y + (x - from.x) / (to.x - from.x) * (to.y - from.y));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        chords.push_back({x, crossings[i], crossings[i + 1], weight});
}

// Between neighbouring vertices the chords' ends are straight.
void addChords(std::vector<Chord>& chords, const optics::PolygonalAperture& polygon, double turnsPerMetre) {
    std::vector<double> stops;
    for (const dvec2& vertex : polygon.vertices) stops.push_back(vertex.x);
    std::sort(stops.begin(), stops.end());
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const double length = stops[i + 1] - stops[i];
        if (length <= 1e-12 * (stops.back() - stops.front())) continue;
        forNodes(stops[i], stops[i + 1], panels(length, turnsPerMetre),
                 [&](double x, double weight) { addChordsAt(chords, polygon.vertices, x, weight); });
    }
}

void addChords(std::vector<Chord>& chords, const optics::LatticeAperture& lattice, double turnsPerMetre) {
    std::visit([&](const auto& cell) { addChords(chords, cell, turnsPerMetre); }, lattice.cell);
}

void addChords(std::vector<Chord>&, const optics::MaskAperture&, double) {}

// Waves of `count` points `step` apart, about their middle.
Complex row(std::uint32_t count, double turnsPerStep) {
    const Complex turn = std::polar(1.0, -2.0 * pi * turnsPerStep);
    Complex wave = std::polar(1.0, pi * turnsPerStep * (count - 1.0));
    Complex sum = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) {
        sum += wave;
        wave *= turn;
    }
    return sum;
}

// A panel sees three quarters of a Gaussian beam's radius, over which the rule has its amplitude to 1e-15.
double turnsAcross(const scene::Beam& beam) {
    return beam.profile == scene::BeamProfile::gaussian ? 4.0 / beam.width.si : 0.0;
}

double chordPower(const std::vector<Chord>& chords, const dvec2& middle, const scene::Beam& beam) {
    double power = 0.0;
    for (const Chord& chord : chords) {
        forNodes(chord.low, chord.high, panels(chord.high - chord.low, turnsAcross(beam)),
                 [&](double y, double weight) {
                     power +=
                         chord.weight * weight * relativeIrradiance(beam, middle.x + chord.x, middle.y + y);
                 });
    }
    return power;
}

// Middles of the cells.
std::vector<dvec2> places(const OpeningShape& shape) {
    const auto* lattice = std::get_if<optics::LatticeAperture>(&shape);
    if (!lattice) return {dvec2(0.0)};
    std::vector<dvec2> result;
    for (std::uint32_t i = 0; i < lattice->firstCount; ++i) {
        for (std::uint32_t j = 0; j < lattice->secondCount; ++j) {
            result.push_back((i - 0.5 * (lattice->firstCount - 1.0)) * lattice->first +
                             (j - 0.5 * (lattice->secondCount - 1.0)) * lattice->second);
        }
    }
    return result;
}

}  // namespace

dvec2 pixelMiddle(const optics::MaskAperture& mask, std::uint32_t column, std::uint32_t row) {
    return mask.pixel.si * dvec2(column - 0.5 * (mask.columns - 1.0), 0.5 * (mask.rows - 1.0) - row);
}

std::vector<Chord> chords(const OpeningShape& shape, double turnsPerMetre) {
    std::vector<Chord> result;
    std::visit([&](const auto& s) { addChords(result, s, turnsPerMetre); }, shape);
    return result;
}

double openArea(const OpeningShape& shape) {
    if (const auto* mask = std::get_if<optics::MaskAperture>(&shape)) {
        double sum = 0.0;
        for (const float amplitude : mask->transmission) sum += double{amplitude} * amplitude;
        return sum * mask->pixel.si * mask->pixel.si;
    }
    double sum = 0.0;
    for (const Chord& chord : chords(shape, 0.0)) sum += chord.weight * (chord.high - chord.low);
    if (const auto* lattice = std::get_if<optics::LatticeAperture>(&shape))
        sum *= 1.0 * lattice->firstCount * lattice->secondCount;
    return sum;
}

double openArea(const OpeningShape& shape, const scene::Beam& beam) {
    if (beam.profile != scene::BeamProfile::gaussian) return openArea(shape);
    double sum = 0.0;
    if (const auto* mask = std::get_if<optics::MaskAperture>(&shape)) {
        for (std::uint32_t row = 0; row < mask->rows; ++row) {
            for (std::uint32_t column = 0; column < mask->columns; ++column) {
                const double amplitude = mask->transmission[std::size_t{row} * mask->columns + column];
                const dvec2 middle = pixelMiddle(*mask, column, row);
                sum += amplitude * amplitude * relativeIrradiance(beam, middle.x, middle.y);
            }
        }
        return sum * mask->pixel.si * mask->pixel.si;
    }
    const std::vector<Chord> strips = chords(shape, turnsAcross(beam));
    for (const dvec2& middle : places(shape)) sum += chordPower(strips, middle, beam);
    return sum;
}

double cellExtent(const OpeningShape& shape) {
    if (const auto* mask = std::get_if<optics::MaskAperture>(&shape))
        return mask->pixel.si * std::hypot(mask->columns, mask->rows);
    double radius = 0.0;
    for (const Chord& chord : chords(shape, 0.0))
        radius = std::max(radius, std::hypot(chord.x, std::max(-chord.low, chord.high)));
    // The outermost nodes lie a hundredth of a panel inside.
    return 2.02 * radius;
}

double extent(const OpeningShape& shape) {
    double radius = 0.0;
    for (const dvec2& middle : places(shape)) radius = std::max(radius, glm::length(middle));
    return 2.0 * radius + cellExtent(shape);
}

Opening::Opening(const OpeningShape& shape, double turnsPerMetre)
    : shape_(shape), turnsPerMetre_(turnsPerMetre), chords_(chords(shape, turnsPerMetre)) {}

Opening::Opening(const OpeningShape& shape, double turnsPerMetre, const scene::Beam& beam)
    : Opening(shape, turnsPerMetre + turnsAcross(beam)) {
    if (beam.profile == scene::BeamProfile::gaussian) gaussian_ = beam;
}

void Opening::forPoints(const std::function<void(const dvec2&, double)>& use) const {
    if (const auto* mask = std::get_if<optics::MaskAperture>(&shape_)) {
        const double half = 0.5 * mask->pixel.si;
        for (std::uint32_t row = 0; row < mask->rows; ++row) {
            for (std::uint32_t column = 0; column < mask->columns; ++column) {
                const double amplitude = mask->transmission[std::size_t{row} * mask->columns + column];
                if (amplitude == 0.0) continue;
                const dvec2 middle = pixelMiddle(*mask, column, row);
                forNodes(-half, half, 1, [&](double x, double xWeight) {
                    forNodes(-half, half, 1, [&](double y, double yWeight) {
                        use(middle + dvec2(x, y), amplitude * xWeight * yWeight);
                    });
                });
            }
        }
        return;
    }
    for (const dvec2& middle : places(shape_)) {
        for (const auto& [x, low, high, weight] : chords_) {
            forNodes(low, high, panels(high - low, turnsPerMetre_),
                     [&, x = x, weight = weight](double y, double yWeight) {
                         const dvec2 r = middle + dvec2(x, y);
                         const double lit =
                             gaussian_ ? std::sqrt(relativeIrradiance(*gaussian_, r.x, r.y)) : 1.0;
                         use(r, weight * yWeight * lit);
                     });
        }
    }
}

Complex Opening::amplitude(const dvec2& f) const {
    if (const auto* mask = std::get_if<optics::MaskAperture>(&shape_)) return maskAmplitude(*mask, f);
    Complex sum = 0.0;
    if (gaussian_) {
        forPoints([&](const dvec2& r, double weight) {
            sum += weight * std::polar(1.0, -2.0 * pi * glm::dot(f, r));
        });
        return sum;
    }
    for (const auto& [x, low, high, weight] : chords_) {
        const double length = high - low;
        const double turns = f.x * x + 0.5 * f.y * (low + high);
        sum += weight * length * sinc(f.y * length) * std::polar(1.0, -2.0 * pi * turns);
    }
    if (const auto* lattice = std::get_if<optics::LatticeAperture>(&shape_)) {
        sum *= row(lattice->firstCount, glm::dot(f, lattice->first));
        sum *= row(lattice->secondCount, glm::dot(f, lattice->second));
    }
    return sum;
}

// Each pixel is an even square.
Complex Opening::maskAmplitude(const optics::MaskAperture& mask, const dvec2& f) const {
    const double pixel = mask.pixel.si;
    std::vector<Complex> columns;
    for (std::uint32_t column = 0; column < mask.columns; ++column)
        columns.push_back(std::polar(1.0, -2.0 * pi * f.x * pixelMiddle(mask, column, 0).x));
    Complex sum = 0.0;
    for (std::uint32_t row = 0; row < mask.rows; ++row) {
        Complex line = 0.0;
        for (std::uint32_t column = 0; column < mask.columns; ++column)
            line += double{mask.transmission[std::size_t{row} * mask.columns + column]} * columns[column];
        sum += line * std::polar(1.0, -2.0 * pi * f.y * pixelMiddle(mask, 0, row).y);
    }
    return sum * pixel * pixel * sinc(f.x * pixel) * sinc(f.y * pixel);
}

}  // namespace fringe::oracle
