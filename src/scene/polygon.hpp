// Polygons in the plane of a grating: what makes one sound, and what puts it in its place.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace fringe::scene {

using Polygon = std::vector<glm::dvec2>;

// Counter-clockwise, with the first vertex `rotation` radians from x towards y, all on a circle about 0.
Polygon regularPolygon(std::uint32_t sides, double diameter, double rotation);

// Positive where the vertices go counter-clockwise.
double signedArea(const Polygon& polygon);

// Precondition: the area is not 0.
glm::dvec2 centroid(const Polygon& polygon);

// Two sides, by their first vertices, that touch where they should not, if there are any: neighbours that
// fold back, or others that meet.
std::optional<std::pair<std::size_t, std::size_t>> crossing(const Polygon& polygon);

// What copies that should touch may overlap by, in parts of their size: lengths written to six digits do.
inline constexpr double kTouch = 1e-6;

// Whether a polygon about 0 and its copy at `shift` have more than a border in common.
bool overlaps(const Polygon& polygon, const glm::dvec2& shift);

}  // namespace fringe::scene
