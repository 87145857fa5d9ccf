#include "optics/amplitude_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "optics/coverage.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {
namespace {

using glm::dvec2;
using std::numbers::pi;
using units::m;

using Outline = std::vector<dvec2>;

// Of the disc's area; 5e-6 of the radius lie between it and the disc.
Outline disc(double radius) {
    constexpr int kSides = 1024;
    constexpr double kAngle = 2.0 * pi / kSides;
    const double corner = radius * std::sqrt(kAngle / std::sin(kAngle));
    Outline outline;
    for (int i = 0; i < kSides; ++i)
        outline.push_back(corner * dvec2(std::cos(kAngle * i), std::sin(kAngle * i)));
    return outline;
}

std::vector<Outline> outlinesOf(const Aperture& aperture) {
    if (const auto* circle = std::get_if<CircularAperture>(&aperture)) {
        std::vector<Outline> outlines{disc(0.5 * (circle->diameter / m))};
        if (const double hole = 0.5 * (circle->innerDiameter / m); hole > 0.0) {
            outlines.push_back(disc(hole));
            std::reverse(outlines.back().begin(), outlines.back().end());
        }
        return outlines;
    }
    if (const auto* rectangle = std::get_if<RectangularAperture>(&aperture))
        return {asPolygon(*rectangle).vertices};
    return {std::get<PolygonalAperture>(aperture).vertices};
}

template <class Use>
void forEdges(const std::vector<Outline>& outlines, const Use& use) {
    for (const Outline& outline : outlines)
        for (std::size_t i = 0; i < outline.size(); ++i) use(outline[i], outline[(i + 1) % outline.size()]);
}

// Where the outlines lie about (0, 0).
struct Surroundings {
    double square;  // of the distance of the nearest edge
    bool isInside;  // (0, 0) itself
};

Surroundings surroundings(const std::vector<Outline>& outlines) {
    Surroundings result{std::numeric_limits<double>::infinity(), false};
    forEdges(outlines, [&](dvec2 from, dvec2 to) {
        const dvec2 edge = to - from;
        const double along = std::clamp(-glm::dot(from, edge) / glm::dot(edge, edge), 0.0, 1.0);
        const dvec2 foot = from + along * edge;
        result.square = std::min(result.square, glm::dot(foot, foot));
        if ((from.y > 0.0) != (to.y > 0.0) && from.x - from.y * edge.x / edge.y > 0.0)
            result.isInside = !result.isInside;
    });
    return result;
}

// The amplitude of a Gaussian beam over that at the distance whose square is `nearest`.
struct Gaussian {
    double radius;  // where it is 1/e
    double nearest;

    double at(dvec2 place) const { return std::exp((nearest - glm::dot(place, place)) / (radius * radius)); }

    // Mean over a small box over the value in its middle, of the amplitude to the power `n`: Taylor's series.
    double mean(dvec2 place, dvec2 box, double n) const {
        const dvec2 x = place / radius, size = box / radius;
        const dvec2 second = 4.0 * n * n * x * x - 2.0 * n;
        return 1.0 + glm::dot(size * size, second) / 24.0;
    }
};

// The squared amplitude varies along an edge.
Edge edgeIn(const Gaussian& gaussian, dvec2 from, dvec2 to) {
    const dvec2 along = to - from;
    const double length = glm::length(along);
    const double pieces = std::ceil(std::clamp(8.0 * length / gaussian.radius, 1.0, 1000.0));
    double sum = 0.0;
    for (double i = 0.5; i < pieces; i += 1.0) sum += std::pow(gaussian.at(from + i / pieces * along), 2);
    return {dvec2(along.y, -along.x) / length, length * sum / pieces};
}

constexpr std::uint32_t kParts = 4;  // of a pixel, along either side

// Hats from the means over parts of pixels, each from fourteen by fourteen. Their sum is the amplitude, as
// hats blur it and means do; the weights make up for both, to the fourth order in the frequency, and leave
// nothing of the frequencies around once and twice per pixel, which would come back as an alias. (Six
// weights, half a pixel apart, with the sum 1, that second moment and a zero of second order; spread by
// 1, 3, 3, 1.)
std::vector<float> hatsOf(const std::vector<double>& means, std::uint32_t columns, std::uint32_t rows) {
    constexpr std::array<double, 14> kWeights{-13, -39, -36, -4, 83,  225, 296,
                                              296, 225, 83,  -4, -36, -39, -13};
    // Those of a line whose entries lie `stride` apart, about the middle of pixel `pixel`.
    const auto weighted = [&](const double* line, std::int64_t pixels, std::size_t stride,
                              std::int64_t pixel) {
        double sum = 0.0;
        for (std::size_t i = 0; i < kWeights.size(); ++i) {
            const std::int64_t at = kParts * pixel - 5 + static_cast<std::int64_t>(i);
            if (at >= 0 && at < kParts * pixels)
                sum += kWeights[i] / 1024.0 * line[static_cast<std::size_t>(at) * stride];
        }
        return sum;
    };
    const std::size_t lines = std::size_t{kParts} * rows;
    std::vector<double> across;  // rows of parts, columns of pixels
    across.reserve(lines * columns);
    for (std::size_t line = 0; line < lines; ++line)
        for (std::uint32_t column = 0; column < columns; ++column)
            across.push_back(weighted(&means[line * kParts * columns], columns, 1, column));
    std::vector<float> values;
    values.reserve(std::size_t{rows} * columns);
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column)
            values.push_back(static_cast<float>(weighted(&across[column], rows, columns, row)));
    return values;
}

AmplitudeGrid litMask(MaskAperture mask, double beamRadius) {
    const dvec2 middle = 0.5 * dvec2(mask.columns - 1.0, mask.rows - 1.0);
    Gaussian gaussian{beamRadius, std::numeric_limits<double>::infinity()};
    const auto place = [&](std::uint32_t column, std::uint32_t row) {
        return (mask.pixel / m) * (dvec2(column, row) - middle);
    };
    const auto forPixels = [&](const auto& use) {
        for (std::uint32_t row = 0; row < mask.rows; ++row)
            for (std::uint32_t column = 0; column < mask.columns; ++column)
                use(mask.transmission[std::size_t{row} * mask.columns + column], place(column, row));
    };
    forPixels([&](float transmission, dvec2 at) {
        if (transmission > 0.0F) gaussian.nearest = std::min(gaussian.nearest, glm::dot(at, at));
    });
    forPixels([&](float& transmission, dvec2 at) { transmission *= static_cast<float>(gaussian.at(at)); });
    return gridOf(mask);
}

}  // namespace

AmplitudeGrid gridOf(const MaskAperture& mask) {
    const double pixel = mask.pixel / m;
    Edge upright{{1.0, 0.0}, 0.0}, level{{0.0, 1.0}, 0.0};
    const auto at = [&](std::int64_t column, std::int64_t row) {
        const bool isInside = column >= 0 && column < mask.columns && row >= 0 && row < mask.rows;
        return isInside ? double(mask.transmission[static_cast<std::size_t>(row * mask.columns + column)])
                        : 0.0;
    };
    for (std::int64_t row = 0; row <= mask.rows; ++row) {
        for (std::int64_t column = 0; column <= mask.columns; ++column) {
            upright.weight += pixel * std::pow(at(column, row) - at(column - 1, row), 2);
            level.weight += pixel * std::pow(at(column, row) - at(column, row - 1), 2);
        }
    }
    return {mask.columns, mask.rows, dvec2(pixel), mask.transmission, area(mask), {upright, level}, false};
}

double clearance(const Aperture& aperture) {
    const auto [square, isInside] = surroundings(outlinesOf(aperture));
    return isInside ? std::sqrt(square) : 0.0;
}

AmplitudeGrid gaussianGrid(const Aperture& aperture, double beamWidth, std::uint32_t across) {
    if (const auto* mask = std::get_if<MaskAperture>(&aperture)) return litMask(*mask, 0.5 * beamWidth);
    // Beyond this many radii of the beam lie 2e-7 of a whole Gaussian's amplitude along either side.
    constexpr double kReach = 3.7;
    std::vector<Outline> outlines = outlinesOf(aperture);
    const auto [square, isInside] = surroundings(outlines);
    const Gaussian gaussian{0.5 * beamWidth, isInside ? 0.0 : square};
    const dvec2 reach(std::sqrt(gaussian.nearest + std::pow(kReach * gaussian.radius, 2)));
    dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
    AmplitudeGrid grid{across, across, {}, {}, 0.0, {}, true};
    forEdges(outlines, [&](dvec2 from, dvec2 to) {
        low = glm::min(low, from);
        high = glm::max(high, from);
        grid.edges.push_back(edgeIn(gaussian, from, to));
    });
    low = glm::max(low, -reach);
    high = glm::min(high, reach);
    // Two pixels on either side stay empty but for what the weights put there.
    grid.pixel = (high - low) / (across - 4.0);
    const dvec2 corner(low.x - 2.0 * grid.pixel.x, high.y + 2.0 * grid.pixel.y);
    const dvec2 part = grid.pixel / double{kParts}, step(part.x, -part.y);
    for (Outline& outline : outlines)
        for (dvec2& vertex : outline) vertex = (vertex - corner) / step;

    std::vector<double> means;
    const std::uint32_t parts = kParts * across;
    const std::vector<Covered> covered = coverage(outlines, parts, parts);
    means.reserve(covered.size());
    for (std::uint32_t row = 0; row < parts; ++row) {
        for (std::uint32_t column = 0; column < parts; ++column) {
            const auto& [share, centroid] = covered[means.size()];
            if (share == 0.0) {
                means.push_back(0.0);
                continue;
            }
            const dvec2 place = corner + step * (dvec2(column, row) + 0.5 + centroid);
            const double amplitude = gaussian.at(place);
            means.push_back(share * amplitude * gaussian.mean(place, part, 1.0));
            grid.area += share * amplitude * amplitude * gaussian.mean(place, part, 2.0);
        }
    }
    grid.area *= part.x * part.y;
    grid.amplitudes = hatsOf(means, across, across);
    return grid;
}

}  // namespace fringe::optics
