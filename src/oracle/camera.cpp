#include "oracle/camera.hpp"

#include <cmath>

#include "oracle/sampler.hpp"

namespace fringe::oracle {

using glm::cross;
using glm::normalize;

Camera::Camera(const scene::Camera& camera, std::uint32_t width, std::uint32_t height)
    : position_(camera.position),
      forward_(normalize(camera.target - camera.position)),
      right_(normalize(cross(forward_, camera.up))),
      up_(cross(right_, forward_)),
      size_(width, height),
      projection_(camera.projection) {}

Ray Camera::ray(const glm::dvec2& point, const glm::dvec2& lens) const {
    // Half the picture's height is the unit of both.
    const double x = (2.0 * point.x - size_.x) / size_.y;
    const double y = (size_.y - 2.0 * point.y) / size_.y;
    const dvec3 offset = x * right_ + y * up_;

    if (const auto* orthographic = std::get_if<scene::Orthographic>(&projection_)) {
        return {position_ + 0.5 * orthographic->height * offset, forward_};
    }

    const auto& perspective = std::get<scene::Perspective>(projection_);
    const dvec3 towards =
        forward_ + std::tan(0.5 * perspective.fov.si) * offset;  // to the plane at distance 1
    if (!perspective.lens) return {position_, normalize(towards)};

    // Every ray of a point in focus meets there, wherever it leaves the lens.
    const glm::dvec2 place = 0.5 * perspective.lens->diameter.si * onUnitDisc(lens);
    const dvec3 onLens = place.x * right_ + place.y * up_;
    return {position_ + onLens, normalize(perspective.lens->focusDistance.si * towards - onLens)};
}

}  // namespace fringe::oracle
