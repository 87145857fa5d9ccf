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

vec2 apertureVertex(uint first, uint index) { return vec2(parameters[first + 2u * index], parameters[first + 2u * index + 1u]); }
float maskEntry(uint at) { return parameters[at]; }

#include "phase.glsl"
#include "apertures.glsl"
#include "even_waves.glsl"
#include "masks.glsl"

vec2 pair(uint at) { return vec2(parameters[at], parameters[at + 1u]); }

float symmetricPattern(vec2 uv) {
    float sum = 0.0;
    for (uint i = 0u; i < uint(parameters.length()) / 2u - 2u; ++i)
        sum += pairOfEdges(polygonEdge(uv, apertureVertex(2u, i), apertureVertex(2u, i + 1u)), parameters[0]);
    return symmetricPolygonIntensity(sum, parameters[0] * dot(uv, uv) * parameters[1]);
}

// The same as the last of sixteen wavenumbers, as far apart as a list has them or as fringes are not faded.
float evenSymmetricPattern(vec2 uv) {
    float square = dot(uv, uv), radius = 0.0;
    if (square < 1e-24) return 1.0;
    uint edges = uint(parameters.length()) / 2u - 2u;
    for (uint i = 0u; i < edges; ++i) radius = max(radius, length(apertureVertex(2u, i)));
    float step_ = min(0.084, 0.25 / (radius * sqrt(square))), first = parameters[0] - 15.0 * step_;
    float amplitude = 0.0;
    for (uint i = 0u; i < edges; ++i) {
        vec3 edge = polygonEdge(uv, apertureVertex(2u, i), apertureVertex(2u, i + 1u));
        EvenEdge even = evenEdge(edge, 0.101321184 / (square * parameters[1]), first, step_);
        for (uint j = 0u; j < 15u; ++j) nextPairOfEdges(even);
        amplitude += nextPairOfEdges(even);
    }
    amplitude /= parameters[0] * parameters[0];
    return amplitude * amplitude;
}

float pattern(vec2 uv) {
    if (PATTERN == 0u) return productError(uv.x, uv.y, uv.x * uv.y);
    if (PATTERN == 1u) return slitsPattern(uv.x, parameters[0], pair(1u), parameters[3]);
    if (PATTERN == 2u) return slitFactor(uv.x * parameters[0]) * slitFactor(uv.y * parameters[1]);
    if (PATTERN == 3u) return circlePattern(length(uv) * parameters[0]);
    if (PATTERN == 4u) return ringPattern(length(uv) * parameters[0], parameters[1]);
    if (PATTERN == 5u) return polygonPattern(uv, parameters[0], 2u, uint(parameters.length() / 2 - 1), parameters[1]);
    if (PATTERN == 8u) return symmetricPattern(uv);
    if (PATTERN == 9u) return evenSymmetricPattern(uv);
    if (PATTERN == 7u) {
        vec2 frequency = uv * parameters[0] * pair(3u);
        return maskPattern(frequency, 6u, pair(1u), SHARP_MASK, false) *
               pow(slitFactor(frequency.x) * slitFactor(frequency.y), parameters[5]);
    }
    float first = fejer(turnsPastOrder(parameters[0], wayPerCell(uv, vec4(pair(1u), pair(3u)))), parameters[9]);
    float second = fejer(turnsPastOrder(parameters[0], wayPerCell(uv, vec4(pair(5u), pair(7u)))), parameters[10]);
    return first * second;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(directions.length())) results[i] = pattern(directions[i]);
}
