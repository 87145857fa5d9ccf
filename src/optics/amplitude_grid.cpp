#include "optics/amplitude_grid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <span>

#include "optics/coverage.hpp"
#include "optics/integrals.hpp"
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

// Values in the middles of pixels, from the means over their parts: each a sum with `weights`, an even number
// of them, about the middle.
std::vector<float> reduced(const std::vector<double>& means, std::span<const double> weights,
                           std::uint32_t columns, std::uint32_t rows) {
    const std::int64_t before = static_cast<std::int64_t>(weights.size() - kParts) / 2;
    // Those of a line whose entries lie `stride` apart, about the middle of pixel `pixel`.
    const auto weighted = [&](const double* line, std::int64_t pixels, std::size_t stride,
                              std::int64_t pixel) {
        double sum = 0.0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const std::int64_t at = kParts * pixel - before + static_cast<std::int64_t>(i);
            if (at >= 0 && at < kParts * pixels)
                sum += weights[i] * line[static_cast<std::size_t>(at) * stride];
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

// For hats. Their sum is the amplitude, as hats blur it and means do; the weights make up for both, to the
// fourth order in the frequency, and leave nothing of the frequencies around once and twice per pixel, which
// would come back as an alias. (Six weights, half a pixel apart, with the sum 1, that second moment and a
// zero of second order; spread by 1, 3, 3, 1.)
std::vector<double> hatWeights() {
    std::vector<double> weights{-13, -39, -36, -4, 83, 225, 296, 296, 225, 83, -4, -36, -39, -13};
    for (double& weight : weights) weight /= 1024.0;
    return weights;
}

// For samples: a sinc in a Gaussian window stops what turns more than half a time per pixel.
std::vector<double> sampleWeights() {
    constexpr int kHalf = 32;
    constexpr double kWindow = 9.0;  // parts
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = -kHalf; i < kHalf; ++i) {
        const double place = i + 0.5;
        weights.push_back(sinc(place / kParts) * std::exp(-0.5 * std::pow(place / kWindow, 2)));
        sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

// Means over a part of a pixel, of the amplitude and of its square.
struct Lit {
    double mean;
    double square;
};

// Of `parts` x `parts` parts of the size `part`, the first of them in the upper left `corner`.
std::vector<Lit> litParts(std::vector<Outline> outlines, const std::optional<Gaussian>& gaussian,
                          dvec2 corner, dvec2 part, std::uint32_t parts) {
    const dvec2 step(part.x, -part.y);
    for (Outline& outline : outlines)
        for (dvec2& vertex : outline) vertex = (vertex - corner) / step;
    std::vector<Lit> lit;
    const std::vector<Covered> covered = coverage(outlines, parts, parts);
    lit.reserve(covered.size());
    for (std::uint32_t row = 0; row < parts; ++row) {
        for (std::uint32_t column = 0; column < parts; ++column) {
            const auto& [share, centroid] = covered[lit.size()];
            if (share == 0.0 || !gaussian) {
                lit.push_back({share, share});
                continue;
            }
            const dvec2 place = corner + step * (dvec2(column, row) + 0.5 + centroid);
            const double amplitude = gaussian->at(place);
            lit.push_back({share * amplitude * gaussian->mean(place, part, 1.0),
                           share * amplitude * amplitude * gaussian->mean(place, part, 2.0)});
        }
    }
    return lit;
}

MaskAperture inGaussian(MaskAperture mask, double beamRadius) {
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
    return mask;
}

// Means of a mask over `parts` x `parts` squares of the size `part` about its middle.
std::vector<double> partsOf(const MaskAperture& mask, double part, std::uint32_t parts) {
    struct Overlap {
        std::size_t pixel;
        double share;  // of the part
    };
    const auto overlaps = [&](std::uint32_t pixels, std::uint32_t i) {
        const double perPart = part / (mask.pixel / m);
        const double from = 0.5 * pixels + (i - 0.5 * parts) * perPart, to = from + perPart;
        std::vector<Overlap> result;
        for (double at = std::max(std::floor(from), 0.0); at < std::min<double>(pixels, to); at += 1.0)
            result.push_back(
                {static_cast<std::size_t>(at), (std::min(to, at + 1.0) - std::max(from, at)) / perPart});
        return result;
    };
    std::vector<std::vector<Overlap>> across, down;
    for (std::uint32_t i = 0; i < parts; ++i) {
        across.push_back(overlaps(mask.columns, i));
        down.push_back(overlaps(mask.rows, i));
    }
    std::vector<double> lines(std::size_t{mask.rows} * parts, 0.0);
    for (std::size_t row = 0; row < mask.rows; ++row)
        for (std::size_t i = 0; i < parts; ++i)
            for (const auto& [pixel, share] : across[i])
                lines[row * parts + i] += share * mask.transmission[row * mask.columns + pixel];
    std::vector<double> means(std::size_t{parts} * parts, 0.0);
    for (std::size_t j = 0; j < parts; ++j)
        for (const auto& [pixel, share] : down[j])
            for (std::size_t i = 0; i < parts; ++i) means[j * parts + i] += share * lines[pixel * parts + i];
    return means;
}

// The outlines of an opening in a Gaussian beam, and the box that holds what of it is lit.
struct LitOutlines {
    std::vector<Outline> outlines;
    Gaussian gaussian;
    dvec2 low, high;
};

// Without a width the beam is even.
LitOutlines litOutlines(const Aperture& aperture, const std::optional<double>& beamWidth) {
    // Beyond this many radii of the beam lie 2e-7 of a whole Gaussian's amplitude along either side.
    constexpr double kReach = 3.7;
    const double width = beamWidth.value_or(std::numeric_limits<double>::infinity());
    LitOutlines lit{outlinesOf(aperture), {0.5 * width, 0.0}, {}, {}};
    const auto [square, isInside] = surroundings(lit.outlines);
    if (!isInside) lit.gaussian.nearest = square;
    const dvec2 reach(std::sqrt(lit.gaussian.nearest + std::pow(kReach * lit.gaussian.radius, 2)));
    lit.low = dvec2(std::numeric_limits<double>::infinity());
    lit.high = -lit.low;
    forEdges(lit.outlines, [&](dvec2 from, dvec2) {
        lit.low = glm::min(lit.low, from);
        lit.high = glm::max(lit.high, from);
    });
    lit.low = glm::max(lit.low, -reach);
    lit.high = glm::min(lit.high, reach);
    return lit;
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
    if (const auto* mask = std::get_if<MaskAperture>(&aperture))
        return gridOf(inGaussian(*mask, 0.5 * beamWidth));
    LitOutlines lit = litOutlines(aperture, beamWidth);
    AmplitudeGrid grid{across, across, {}, {}, 0.0, {}, true};
    forEdges(lit.outlines,
             [&](dvec2 from, dvec2 to) { grid.edges.push_back(edgeIn(lit.gaussian, from, to)); });
    // Two pixels on either side stay empty but for what the weights put there.
    grid.pixel = (lit.high - lit.low) / (across - 4.0);
    const dvec2 corner(lit.low.x - 2.0 * grid.pixel.x, lit.high.y + 2.0 * grid.pixel.y);
    const dvec2 part = grid.pixel / double{kParts};
    std::vector<double> means;
    for (const auto& [mean, square] :
         litParts(std::move(lit.outlines), lit.gaussian, corner, part, kParts * across)) {
        means.push_back(mean);
        grid.area += square;
    }
    grid.area *= part.x * part.y;
    grid.amplitudes = reduced(means, hatWeights(), across, across);
    return grid;
}

double litHalf(const Aperture& aperture, const std::optional<double>& beamWidth) {
    if (const auto* mask = std::get_if<MaskAperture>(&aperture))
        return 0.5 * std::max(mask->columns, mask->rows) * (mask->pixel / m);
    const LitOutlines lit = litOutlines(aperture, beamWidth);
    const dvec2 farthest = glm::max(glm::abs(lit.low), glm::abs(lit.high));
    return std::max(farthest.x, farthest.y);
}

AmplitudeSamples samplesOf(const Aperture& aperture, const std::optional<double>& beamWidth,
                           std::uint32_t across) {
    constexpr std::uint32_t kMargin = 6;  // pixels, for what the weights put beyond the opening
    const std::uint32_t parts = kParts * across;
    const double half = litHalf(aperture, beamWidth), pixel = 2.0 * half / (across - 2.0 * kMargin);
    std::vector<double> means;
    if (const auto* mask = std::get_if<MaskAperture>(&aperture)) {
        means = partsOf(beamWidth ? inGaussian(*mask, 0.5 * *beamWidth) : *mask, pixel / kParts, parts);
    } else {
        LitOutlines lit = litOutlines(aperture, beamWidth);
        const dvec2 corner = 0.5 * across * pixel * dvec2(-1.0, 1.0);
        const std::optional gaussian = beamWidth ? std::optional(lit.gaussian) : std::nullopt;
        for (const Lit& part :
             litParts(std::move(lit.outlines), gaussian, corner, dvec2(pixel / kParts), parts))
            means.push_back(part.mean);
    }
    return {across, half, pixel, reduced(means, sampleWeights(), across, across)};
}

}  // namespace fringe::optics
