// Evaluates one pattern of apertures.glsl, or one function of phase.glsl, at many directions (probe.hpp says which and
// with what parameters).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
layout(constant_id = 0) const uint PATTERN = 0u;

layout(scalar, set = 0, binding = 0) readonly buffer Parameters { float parameters[]; };
layout(scalar, set = 0, binding = 1) readonly buffer Directions { vec2 directions[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer Results { float results[]; };

vec2 apertureVertex(uint index) { return vec2(parameters[2u * index], parameters[2u * index + 1u]); }

#include "phase.glsl"
#include "apertures.glsl"

vec2 pair(uint at) { return vec2(parameters[at], parameters[at + 1u]); }

float pattern(vec2 uv) {
    if (PATTERN == 0u) return productError(uv.x, uv.y, uv.x * uv.y);
    if (PATTERN == 1u) return slitsPattern(uv.x, parameters[0], pair(1u), parameters[3]);
    if (PATTERN == 2u) return rectanglePattern(uv, pair(0u));
    if (PATTERN == 3u) return circlePattern(uv, parameters[0]);
    if (PATTERN == 4u) return ringPattern(uv, parameters[0], parameters[1]);
    if (PATTERN == 5u) return polygonPattern(uv * parameters[0], 1u, uint(parameters.length() / 2 - 1), parameters[1]);
    return latticeFactor(uv, vec4(pair(0u), pair(2u)), vec4(pair(4u), pair(6u)), pair(8u));
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(directions.length())) results[i] = pattern(directions[i]);
}
