#include "preview/picking.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "oracle/camera.hpp"
#include "oracle/shapes.hpp"

namespace fringe::preview {
namespace {

using glm::dvec3;

// The nearest emitting surface of a light.
std::optional<double> distanceOfLights(const scene::Scene& scene, const oracle::Ray& ray) {
    std::optional<double> nearest;
    for (const scene::Light& light : scene.lights) {
        const auto* area = std::get_if<scene::AreaLight>(&light.model);
        if (area == nullptr) continue;
        const auto shape = std::visit([](const auto& s) { return scene::Shape(s); }, area->shape);
        const auto hit = oracle::intersect(ray, shape);
        if (hit && (!nearest || hit->distance < *nearest)) nearest = hit->distance;
    }
    return nearest;
}

}  // namespace

std::optional<Pick> pickAt(const scene::Scene& scene, const scene::Camera& camera, glm::dvec2 place) {
    const oracle::Ray ray =
        oracle::Camera(camera, scene.image.width, scene.image.height).ray(place, {0.5, 0.5});
    std::optional<oracle::Hit> nearest;
    std::size_t object = 0;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const auto hit = oracle::intersect(ray, scene.objects[i].shape);
        if (!hit || (nearest && nearest->distance <= hit->distance)) continue;
        nearest = hit;
        object = i;
    }
    if (!nearest) return std::nullopt;
    const auto light = distanceOfLights(scene, ray);
    if (light && *light < nearest->distance) return std::nullopt;
    const bool faces = glm::dot(nearest->normal, ray.direction) <= 0.0;
    return Pick{object, ray.at(nearest->distance), faces ? nearest->normal : -nearest->normal};
}

scene::Camera withinRoom(const scene::Scene& scene, scene::Camera camera) {
    constexpr double kStart = 1e-3, kLeast = 0.1, kBefore = 0.98;  // of the way
    const dvec3 outward = camera.position - camera.target;
    scene::Camera back = camera;  // from the target, which may be on a surface itself
    back.position = camera.target + kStart * outward;
    back.target = camera.position;
    const auto wall = pickAt(scene, back, 0.5 * glm::dvec2(scene.image.width, scene.image.height));
    if (!wall) return camera;
    const double share = glm::distance(wall->point, camera.target) / glm::length(outward);
    if (share > kLeast && share < 1.0) camera.position = camera.target + kBefore * share * outward;
    return camera;
}

std::optional<glm::dvec2> placeOf(const scene::Image& image, const scene::Camera& camera, dvec3 point) {
    const dvec3 forward = glm::normalize(camera.target - camera.position);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const dvec3 offset = point - camera.position;
    const double depth = glm::dot(offset, forward);
    if (depth <= 0.0) return std::nullopt;
    const auto* perspective = std::get_if<scene::Perspective>(&camera.projection);
    // Metres that half of the picture's height shows there.
    const double half = perspective != nullptr
                            ? depth * std::tan(0.5 * (perspective->fov / units::rad))
                            : 0.5 * std::get<scene::Orthographic>(camera.projection).height;
    const glm::dvec2 size(image.width, image.height);
    const glm::dvec2 seen(glm::dot(offset, right), -glm::dot(offset, glm::cross(right, forward)));
    return 0.5 * size + seen * (0.5 * size.y / half);
}

}  // namespace fringe::preview
