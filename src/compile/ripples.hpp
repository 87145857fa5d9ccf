// Whether the Fresnel ripple at a beam's edges can show in a picture.
#pragma once

#include <span>

#include "compile/interface.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

// False only where it is certain that samples are so coarse, or the source so wide, that wherever light of
// these gratings falls the ripple along the slits averages out (shaders/beam.glsl, hiding()): the shader
// then needs no Fresnel integrals. Certain it is for flat surfaces alone, narrow slits and beams without an
// inclination along the slits.
bool ripplesShow(const scene::Scene& scene, const device::Frame& frame,
                 std::span<const device::SlitGrating> gratings);

}  // namespace fringe::compile
