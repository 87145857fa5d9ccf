// Where a straight line lies on the surfaces of a scene: the object under it, the side that is measured, and
// the points on it that samples stand for.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <stdexcept>

#include "scene/scene.hpp"

namespace fringe::profile {

using glm::dvec3;

// The line, or what lies under it, does not do for a profile; the message says what would.
class LineError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The point of a surface that is nearest to another, with the normal there.
struct Foot {
    dvec3 point;
    dvec3 normal;   // unit; outwards for what has an inside
    bool twoSided;  // the surface has no inside: either side can be lit
};

// Nothing where the nearest point of the surface's plane or lateral is beyond its edge. An edge is a
// nanometre wide.
std::optional<Foot> footOn(const scene::Shape& shape, dvec3 point);

// How far a line may be from the surface that it is said to lie on, metres.
inline constexpr double kSurfaceTolerance = 1e-4;

struct SurfaceLine {
    std::size_t object;  // index into Scene::objects
    dvec3 from;          // on the surface
    dvec3 to;
    dvec3 normal;  // unit, of the side that is measured, in the middle of the line

    double length() const;
    dvec3 at(double share) const { return from + share * (to - from); }  // 0 at `from`, 1 at `to`
};

// The surface that all of the line from `from` to `to` lies on, within kSurfaceTolerance; the nearest, if
// several do. Of surfaces without an inside, the side towards `eye` is measured. Throws LineError.
SurfaceLine surfaceUnder(const scene::Scene& scene, dvec3 from, dvec3 to, dvec3 eye);

}  // namespace fringe::profile
