#include "preview/camera_motion.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace fringe::preview {
namespace {

using glm::dvec3;

// Highest and lowest view, so that up stays defined.
constexpr double kSteepest = 1.55;  // radians; 89 degrees

struct Axes {
    dvec3 right, up, forward;
};

Axes axesOf(const scene::Camera& camera) {
    const dvec3 forward = glm::normalize(camera.target - camera.position);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    return {right, glm::cross(right, forward), forward};
}

// Metres at the target that the picture's height shows.
double heightAtTarget(const scene::Camera& camera) {
    if (const auto* orthographic = std::get_if<scene::Orthographic>(&camera.projection))
        return orthographic->height;
    const double fov = std::get<scene::Perspective>(camera.projection).fov / units::rad;
    return 2.0 * std::tan(0.5 * fov) * glm::distance(camera.position, camera.target);
}

void move(scene::Camera& camera, const dvec3& by) {
    camera.position += by;
    camera.target += by;
}

}  // namespace

scene::Camera orbited(scene::Camera camera, double right, double up) {
    const dvec3 pole = glm::normalize(camera.up);
    const dvec3 offset = camera.position - camera.target;
    const double distance = glm::length(offset);
    const double elevation = std::asin(std::clamp(glm::dot(offset, pole) / distance, -1.0, 1.0));
    // The direction away from the target without its height, turned about the pole.
    const dvec3 level = -glm::cross(pole, axesOf(camera).right);
    const dvec3 outward = glm::dot(level, offset) >= 0.0 ? level : -level;
    const dvec3 turned = std::cos(right) * outward + std::sin(right) * glm::cross(pole, outward);
    const double steepest = std::max(kSteepest, std::abs(elevation));
    const double raised = std::clamp(elevation + up, -steepest, steepest);
    camera.position = camera.target + distance * (std::cos(raised) * turned + std::sin(raised) * pole);
    return camera;
}

scene::Camera panned(scene::Camera camera, double right, double up) {
    const Axes axes = axesOf(camera);
    move(camera, -heightAtTarget(camera) * (right * axes.right + up * axes.up));
    return camera;
}

scene::Camera dollied(scene::Camera camera, double factor) {
    camera.position = camera.target + factor * (camera.position - camera.target);
    if (auto* orthographic = std::get_if<scene::Orthographic>(&camera.projection))
        orthographic->height *= factor;
    return camera;
}

scene::Camera flown(scene::Camera camera, const dvec3& rightUpForward) {
    const Axes axes = axesOf(camera);
    move(camera,
         rightUpForward.x * axes.right + rightUpForward.y * axes.up + rightUpForward.z * axes.forward);
    return camera;
}

scene::Camera seenFrom(scene::Camera camera, Side side) {
    const auto outward = [&]() -> dvec3 {
        switch (side) {
            case Side::front:
                return {0, 0, 1};
            case Side::back:
                return {0, 0, -1};
            case Side::left:
                return {-1, 0, 0};
            case Side::right:
                return {1, 0, 0};
            case Side::top:
                return {0, 1, 0};
            case Side::bottom:
                return {0, -1, 0};
        }
        return {0, 0, 1};
    }();
    camera.position = camera.target + glm::distance(camera.position, camera.target) * outward;
    camera.up = std::abs(outward.y) > 0.0 ? dvec3(0, 0, -outward.y) : dvec3(0, 1, 0);
    return camera;
}

}  // namespace fringe::preview
