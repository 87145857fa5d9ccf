// The variants of the shader: each has no more code than scenes of its kind need (shaders/CMakeLists.txt).
#pragma once

#include <cstdint>
#include <span>

#include "compile/compiled_scene.hpp"

namespace fringe::render {

struct Variant {
    bool banded, slits, openings, discs, tree;  // the definitions of shaders/render.comp

    bool operator==(const Variant&) const = default;
};

Variant variantFor(const compile::CompiledScene& scene);

// The one for what of a scene no grating reaches.
Variant withoutGratings(Variant variant);

// Its SPIR-V, as it was when the library was built.
std::span<const std::uint32_t> embeddedShader(const Variant& variant);

}  // namespace fringe::render
