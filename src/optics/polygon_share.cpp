// Polygons, by what is evanescent. Along a direction, A is a sum over vertices of W exp(-ik.v)/k^2 with
// weights that depend on the direction alone, so the integral of |A|^2 outwards from the last propagating
// direction is closed, and only the one around is left to quadrature. Its panels narrow towards the normals
// of the edges, where |A|^2 has its spikes.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "optics/integrals.hpp"
#include "optics/shares.hpp"
#include "optics/transform.hpp"

namespace fringe::optics {
namespace {

using glm::dvec2;
using std::numbers::pi;

// The closed form takes time as the cube of the number of vertices.
constexpr std::size_t kMostVertices = 32;

// Kinks at diagonals are left out (1e-6 in what propagates) where there are many, or they are longer than
// this many wavelengths.
constexpr std::size_t kFewVertices = 6;
constexpr std::size_t kMostWithDiagonals = 12;
constexpr double kLargestKink = 40.0;

// z^2 times the integral of cos(t)/t^3 from z on.
double cubeIntegral(double z) {
    if (z < 1e-12) return 0.5;
    const AuxiliaryRests rests = auxiliaryRests(z);
    return 0.5 * (rests.second * std::cos(z) - rests.first * std::sin(z));
}

// (4 pi^2) |A|^2 k integrated over k outwards from `least`, along the direction.
double beyond(const PolygonalAperture& polygon, dvec2 direction, double least, std::vector<double>& weights,
              std::vector<double>& places) {
    const std::size_t count = polygon.vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
        const dvec2 edge = polygon.vertices[(i + 1) % count] - polygon.vertices[i];
        const double slope =
            (direction.x * edge.y - direction.y * edge.x) / glm::dot(direction, edge);  // cross / dot
        weights[i] += slope;
        weights[(i + 1) % count] -= slope;
        places[i] = least * glm::dot(direction, polygon.vertices[i]);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += 0.5 * weights[i] * weights[i];
        for (std::size_t j = 0; j < i; ++j)
            sum += 2.0 * weights[i] * weights[j] * cubeIntegral(std::abs(places[i] - places[j]));
    }
    std::fill(weights.begin(), weights.end(), 0.0);
    return sum / (least * least);
}

// A direction across an edge, or across a diagonal (where two vertices fall into line and the integrand has a
// kink), and the width in radians over which it changes there.
struct Spike {
    double angle;
    double width;
};

// In [0, pi), each followed pi further on by its twin.
std::vector<Spike> spikes(const PolygonalAperture& polygon, double wavelength) {
    std::vector<Spike> found;
    const auto add = [&](dvec2 edge) {
        double angle = std::atan2(-edge.x, edge.y);
        if (angle < 0.0) angle += pi;
        if (angle >= pi) angle -= pi;
        found.push_back({angle, wavelength / (2.0 * pi * glm::length(edge))});
    };
    const std::size_t count = polygon.vertices.size();
    for (std::size_t i = 0; i < count; ++i) add(polygon.vertices[(i + 1) % count] - polygon.vertices[i]);
    if (count <= kMostWithDiagonals) {
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const dvec2 diagonal = polygon.vertices[i] - polygon.vertices[j];
                if (count <= kFewVertices || glm::length(diagonal) < kLargestKink * wavelength) add(diagonal);
            }
    }
    std::sort(found.begin(), found.end(), [](Spike a, Spike b) { return a.angle < b.angle; });
    std::vector<Spike> merged;
    for (const Spike& spike : found) {
        if (!merged.empty() &&
            spike.angle - merged.back().angle < 1e-3 * std::min(spike.width, merged.back().width))
            merged.back().width = std::min(merged.back().width, spike.width);
        else merged.push_back(spike);
    }
    if (merged.size() > 1 && merged.front().angle + pi - merged.back().angle < 1e-3 * merged.front().width)
        merged.pop_back();
    return merged;
}

double evanescentShare(const PolygonalAperture& polygon, const Incidence& in) {
    static const GaussRule rule = gaussLegendre(16);
    std::vector<double> weights(polygon.vertices.size()), places(polygon.vertices.size());
    const auto integrand = [&](double angle) {
        const dvec2 direction(std::cos(angle), std::sin(angle));
        return beyond(polygon, direction, 2.0 * pi / in.wavelength * reach(in, direction), weights, places);
    };
    // From a spike to the middle between it and the next, in panels that double. The innermost holds a
    // logarithm of the distance, which its cube root as the variable takes away.
    const auto flank = [&](double from, double width, double length, double sign) {
        const double innermost = std::min(width, length);
        double sum = 0.0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double t = 0.5 * (1.0 + rule.nodes[i]);
            sum += 1.5 * innermost * rule.weights[i] * t * t * integrand(from + sign * innermost * t * t * t);
        }
        for (double near = innermost; near < length;) {
            const double far = std::min(length, 2.0 * near);
            const double half = 0.5 * (far - near);
            for (std::size_t i = 0; i < rule.nodes.size(); ++i)
                sum +=
                    half * rule.weights[i] * integrand(from + sign * (near + half * (1.0 + rule.nodes[i])));
            near = far;
        }
        return sum;
    };
    const std::vector<Spike> all = spikes(polygon, in.wavelength);
    const bool isEven = in.direction == dvec2(0.0);
    double sum = 0.0;
    for (int turn = 0; turn < (isEven ? 1 : 2); ++turn) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double angle = all[i].angle + turn * pi;
            const double next = i + 1 < all.size() ? all[i + 1].angle : all.front().angle + pi;
            const double previous = i > 0 ? all[i - 1].angle : all.back().angle - pi;
            sum += flank(angle, all[i].width, 0.5 * (next - all[i].angle), 1.0);
            sum += flank(angle, all[i].width, 0.5 * (all[i].angle - previous), -1.0);
        }
    }
    return (isEven ? 2.0 : 1.0) * sum / (4.0 * pi * pi * area(polygon));
}

// What long edges send past the last propagating directions across them, corners left out: for one edge of
// length l, l/(4 pi^2) (1/f + 1/f') with the two frequencies there.
double edgesBeyond(const PolygonalAperture& polygon, const Incidence& in) {
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const dvec2 edge = polygon.vertices[(i + 1) % polygon.vertices.size()] - polygon.vertices[i];
        const dvec2 normal = dvec2(edge.y, -edge.x) / glm::length(edge);
        sum += glm::length(edge) * (1.0 / reach(in, normal) + 1.0 / reach(in, -normal));
    }
    return sum * in.wavelength / (4.0 * pi * pi * area(polygon));
}

}  // namespace

double shareOf(const PolygonalAperture& polygon, const Incidence& in) {
    if (polygon.vertices.size() <= kMostVertices) return 1.0 - evanescentShare(polygon, in);
    double radius = 0.0;
    for (const dvec2& vertex : polygon.vertices) radius = std::max(radius, glm::length(vertex));
    if (2.0 * radius < kLargestExtent * in.wavelength) return shareByQuadrature(polygon, 2.0 * radius, in);
    return 1.0 - edgesBeyond(polygon, in);
}

double shareOf(const RectangularAperture& rectangle, const Incidence& in) {
    return shareOf(asPolygon(rectangle), in);
}

}  // namespace fringe::optics
