#include "profile/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <limits>

namespace fringe::profile {
namespace {

using MaybeFoot = std::optional<Foot>;

constexpr double kEdge = 1e-9;  // metres

Foot onPlane(dvec3 point, dvec3 through, dvec3 normal) {
    return {point - glm::dot(point - through, normal) * normal, normal, true};
}

MaybeFoot foot(const scene::Plane& plane, dvec3 point) {
    return onPlane(point, plane.point, plane.normal);
}

MaybeFoot foot(const scene::Rectangle& rectangle, dvec3 point) {
    const Foot found = onPlane(point, rectangle.center, glm::normalize(glm::cross(rectangle.u, rectangle.v)));
    const auto within = [&](dvec3 halfEdge) {
        const double half = glm::length(halfEdge);
        return std::abs(glm::dot(found.point - rectangle.center, halfEdge / half)) <= half + kEdge;
    };
    return within(rectangle.u) && within(rectangle.v) ? MaybeFoot(found) : MaybeFoot();
}

MaybeFoot foot(const scene::Disc& disc, dvec3 point) {
    const Foot found = onPlane(point, disc.center, disc.normal);
    const double radius = glm::distance(found.point, disc.center);
    return radius >= disc.innerRadius - kEdge && radius <= disc.radius + kEdge ? MaybeFoot(found)
                                                                               : MaybeFoot();
}

MaybeFoot foot(const scene::Triangle& triangle, dvec3 point) {
    const auto& corner = triangle.vertices;
    const dvec3 normal = glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
    const Foot found = onPlane(point, corner[0], normal);
    for (int i = 0; i < 3; ++i) {
        const dvec3 edge = corner[(i + 1) % 3] - corner[i];
        const dvec3 inwards = glm::normalize(glm::cross(normal, edge));
        if (glm::dot(found.point - corner[i], inwards) < -kEdge) return {};
    }
    return found;
}

MaybeFoot foot(const scene::Sphere& sphere, dvec3 point) {
    const dvec3 offset = point - sphere.center;
    if (glm::length(offset) == 0.0) return {};
    const dvec3 normal = glm::normalize(offset);
    return Foot{sphere.center + sphere.radius * normal, normal, false};
}

// The nearest of several, as parts of one closed surface or of an open one.
MaybeFoot nearestOf(dvec3 point, bool closed, std::initializer_list<MaybeFoot> feet) {
    MaybeFoot nearest;
    for (const MaybeFoot& each : feet) {
        if (each && (!nearest || glm::distance(each->point, point) < glm::distance(nearest->point, point)))
            nearest = each;
    }
    if (nearest) nearest->twoSided = !closed;
    return nearest;
}

MaybeFoot foot(const scene::Box& box, dvec3 point) {
    // The face in the direction of `out`, spanned so that its normal points there.
    const auto face = [&](dvec3 out, dvec3 a, dvec3 b) {
        if (glm::dot(glm::cross(a, b), out) < 0.0) std::swap(a, b);
        return foot(scene::Rectangle{box.center + out, a, b}, point);
    };
    return nearestOf(point, true,
                     {face(box.u, box.v, box.w), face(-box.u, box.v, box.w), face(box.v, box.w, box.u),
                      face(-box.v, box.w, box.u), face(box.w, box.u, box.v), face(-box.w, box.u, box.v)});
}

// The lateral of a cylinder or cone: radius `first` at `base`, `last` at `top`.
MaybeFoot footOnLateral(dvec3 base, dvec3 top, double first, double last, dvec3 point) {
    const double height = glm::distance(base, top);
    const dvec3 axis = (top - base) / height;
    const dvec3 offset = point - base;
    const dvec3 radial = offset - glm::dot(offset, axis) * axis;
    if (glm::length(radial) == 0.0) return {};
    const dvec3 outwards = glm::normalize(radial);
    // In the half plane of the axis and the point the lateral is a straight line.
    const dvec3 start = base + first * outwards;
    const dvec3 along = height * axis + (last - first) * outwards;
    const double share = glm::dot(point - start, along) / glm::dot(along, along);
    const double edge = kEdge / glm::length(along);
    if (share < -edge || share > 1.0 + edge) return {};
    const dvec3 normal = glm::normalize(height * outwards - (last - first) * axis);
    return Foot{start + share * along, normal, true};
}

MaybeFoot foot(const scene::Cylinder& cylinder, dvec3 point) {
    const dvec3 axis = glm::normalize(cylinder.top - cylinder.base);
    const MaybeFoot lateral =
        footOnLateral(cylinder.base, cylinder.top, cylinder.radius, cylinder.radius, point);
    if (!cylinder.capped) return lateral;
    return nearestOf(point, true,
                     {lateral, foot(scene::Disc{cylinder.base, -axis, cylinder.radius, 0.0}, point),
                      foot(scene::Disc{cylinder.top, axis, cylinder.radius, 0.0}, point)});
}

MaybeFoot foot(const scene::Cone& cone, dvec3 point) {
    const MaybeFoot lateral = footOnLateral(cone.base, cone.apex, cone.radius, 0.0, point);
    if (!cone.capped) return lateral;
    const dvec3 axis = glm::normalize(cone.apex - cone.base);
    return nearestOf(point, true, {lateral, foot(scene::Disc{cone.base, -axis, cone.radius, 0.0}, point)});
}

std::string textOf(dvec3 p) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z);
}

std::string nameOf(const scene::Scene& scene, std::size_t object) {
    const std::string& name = scene.objects[object].name;
    return name.empty() ? fmt::format("objects[{}]", object) : fmt::format("\"{}\"", name);
}

double distanceTo(const scene::Shape& shape, dvec3 point) {
    const MaybeFoot found = footOn(shape, point);
    return found ? glm::distance(found->point, point) : std::numeric_limits<double>::infinity();
}

// The object nearest to a point, wherever that is.
std::optional<std::size_t> nearestObject(const scene::Scene& scene, dvec3 point) {
    std::optional<std::size_t> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const double distance = distanceTo(scene.objects[i].shape, point);
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

// Why no surface has all of the line.
std::string complaint(const scene::Scene& scene, dvec3 from, dvec3 to) {
    constexpr double kMillimetres = 1e3;
    for (const double share : {0.0, 1.0, 0.5}) {
        const dvec3 point = from + share * (to - from);
        const std::optional<std::size_t> object = nearestObject(scene, point);
        const char* which = share == 0.0   ? "the beginning of the line,"
                            : share == 1.0 ? "the end of the line,"
                                           : "the middle of the line,";
        if (!object) {
            return fmt::format("{} {} is above no surface of the scene; give points on one", which,
                               textOf(point));
        }
        const Foot foot = *footOn(scene.objects[*object].shape, point);
        const double distance = glm::distance(foot.point, point);
        if (distance > kSurfaceTolerance) {
            return fmt::format(
                "{} {} is {:.3g} mm from the nearest surface, {}; points within {:g} mm count as on it, the "
                "nearest is {}",
                which, textOf(point), distance * kMillimetres, nameOf(scene, *object),
                kSurfaceTolerance * kMillimetres, textOf(foot.point));
        }
    }
    return fmt::format("the line from {} to {} does not stay on one surface; give a line for each",
                       textOf(from), textOf(to));
}

// Flat faces have no holes but those of discs; a thousand points find these and every curvature.
constexpr int kChecks = 1000;

bool liesOn(const scene::Shape& shape, dvec3 from, dvec3 to) {
    for (int i = 0; i <= kChecks; ++i) {
        const dvec3 point = from + (static_cast<double>(i) / kChecks) * (to - from);
        if (distanceTo(shape, point) > kSurfaceTolerance) return false;
    }
    return true;
}

}  // namespace

std::optional<Foot> footOn(const scene::Shape& shape, dvec3 point) {
    return std::visit([&](const auto& s) { return foot(s, point); }, shape);
}

double SurfaceLine::length() const {
    return glm::distance(from, to);
}

SurfaceLine surfaceUnder(const scene::Scene& scene, dvec3 from, dvec3 to, dvec3 eye) {
    if (glm::distance(from, to) < kEdge)
        throw LineError(
            fmt::format("the line begins and ends at the same point {}; give its two ends", textOf(from)));
    const dvec3 middle = 0.5 * (from + to);
    std::optional<std::size_t> object;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Shape& shape = scene.objects[i].shape;
        const bool nearer =
            !object || distanceTo(shape, middle) < distanceTo(scene.objects[*object].shape, middle);
        if (nearer && liesOn(shape, from, to)) object = i;
    }
    if (!object) throw LineError(complaint(scene, from, to));

    const scene::Object& under = scene.objects[*object];
    if (std::holds_alternative<scene::Emissive>(scene.materials[under.material].model)) {
        throw LineError(
            fmt::format("{} glows; give a line on a surface that does not", nameOf(scene, *object)));
    }
    const Foot foot = *footOn(under.shape, middle);
    const bool faces = !foot.twoSided || glm::dot(eye - foot.point, foot.normal) >= 0.0;
    return {*object, footOn(under.shape, from)->point, footOn(under.shape, to)->point,
            faces ? foot.normal : -foot.normal};
}

}  // namespace fringe::profile
