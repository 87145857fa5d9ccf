// Validated JSON -> Scene, with the checks that take more than one value or some geometry: directions that
// are zero or parallel, edges that are not perpendicular, names that are taken or lead nowhere.
#pragma once

#include "scene/findings.hpp"
#include "scene/node.hpp"
#include "scene/scene.hpp"
#include "scene/validate.hpp"

namespace fringe::scene {

// The scene, without the parts that are unsound. What is wrong with the others is added to the findings; the
// scene may be used only if there are none, from the validation or from here.
Scene extractScene(const Json::Value& root, const Unsound& unsound, Surroundings& surroundings);

// ---- parts of it, for sound nodes ----------------------------------------------------------------

// Metres. Smaller is no surface to any light, and its square would leave the range of single precision.
inline constexpr double kSmallestSize = 1e-9;

// The value at unit length; zero, with a problem recorded, if it is zero.
dvec3 unitDirection(const Node& node);

// Records a problem at `node` if its unit vector `direction` is parallel to `axis`, which comes from `other`;
// `what` says so in words. True if it is; a zero vector, which has its own problem, is not.
bool refuseParallel(const Node& node, const dvec3& direction, const Node& other, const dvec3& axis,
                    std::string_view what);

// A vector for messages: [0, 0.5, 1]
std::string written(const dvec3& vector);

Rectangle rectangleOf(const Node& node);
Disc discOf(const Node& node);
Sphere sphereOf(const Node& node);
Shape shapeOf(const Node& object);

// Slits with a width that fits the period.
Slits slitsOf(const Node& node);
Faults faultsOf(const Node& node);
Material materialOf(const std::string& name, const Node& node);
optics::Aperture apertureOf(const Node& node);
ThesisGrating thesisGratingOf(const Node& light);
Grating gratingOf(const Node& light);
Light lightOf(const Node& node);

}  // namespace fringe::scene
