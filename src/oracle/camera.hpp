// Rays through the picture: perspective, with or without a thin lens, or orthographic.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "oracle/ray.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

class Camera {
public:
    Camera(const scene::Camera& camera, std::uint32_t width, std::uint32_t height);

    // The ray through `point`, in pixels from the picture's upper left corner (x right, y down; pixel centres
    // lie at halves), that leaves the lens where `lens`, uniform in [0, 1]^2 and (0.5, 0.5) in the middle,
    // falls on it. Without a lens `lens` is unused.
    Ray ray(const glm::dvec2& point, const glm::dvec2& lens) const;

private:
    dvec3 position_;
    dvec3 forward_, right_, up_;  // orthonormal
    glm::dvec2 size_;             // of the picture, in pixels
    std::variant<scene::Perspective, scene::Orthographic> projection_;
};

}  // namespace fringe::oracle
