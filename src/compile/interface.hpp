// The bytes shared with the device, as C++ sees them (shaders/interface.h), and the pipeline constants
// (shaders/specialisation.h).
#pragma once

#include <compare>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <type_traits>

namespace fringe::device {

using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;

#include "../../shaders/interface.h"
#include "../../shaders/specialisation.h"

// Scalar block layout has no padding, and neither may these have.
static_assert(sizeof(Camera) == 76 && sizeof(GratingGrid) == 52 && sizeof(Frame) == 176);
static_assert(sizeof(FilmPixel) == 16);
static_assert(sizeof(Plane) == 28 && sizeof(Rectangle) == 40 && sizeof(Disc) == 36 && sizeof(Sphere) == 20);
static_assert(sizeof(Box) == 52 && sizeof(Cylinder) == 40 && sizeof(Cone) == 40 && sizeof(Triangle) == 52);
static_assert(sizeof(TreeNode) == 64);
static_assert(sizeof(Material) == 44 && sizeof(Light) == 84);
static_assert(sizeof(ThesisAperture) == 16 && sizeof(ThesisGrating) == 84 && sizeof(SlitGrating) == 160 &&
              sizeof(ResponseEntry) == 16);
static_assert(sizeof(OpeningGrating) == 208 && sizeof(OpeningSample) == 16);
static_assert(sizeof(LayerRow) == LAYER_ROW_SIZE * sizeof(float));
static_assert(sizeof(OpticalDisc) == 76);
// What every device can bind (the least that Vulkan allows for maxUniformBufferRange).
static_assert(sizeof(SceneBlock) <= 16384);
static_assert(std::is_trivially_copyable_v<Frame> && std::is_trivially_copyable_v<Light>);

// Constants compiled into the pipeline; equal values mean the same pipeline.
struct Specialisation {
#define DECLARE(id, name) uint name = 0;
    FRINGE_SPECIALISATION(DECLARE)
#undef DECLARE

    bool operator==(const Specialisation&) const = default;
};

inline constexpr uint kSpecialisationCount = sizeof(Specialisation) / sizeof(uint);

}  // namespace fringe::device
