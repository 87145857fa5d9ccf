// How the pictures of a scene are developed.
#pragma once

#include <optional>

#include "image/develop.hpp"
#include "scene/scene.hpp"

namespace fringe::render {

image::ColorSpace colorSpaceOf(const scene::Image& image);

// Colour space and white balance of the scene, without exposure, which may yet have to be found. Nothing when
// the white balance is for a light too saturated to look white.
std::optional<image::Development> developmentOf(const scene::Scene& scene);

}  // namespace fringe::render
