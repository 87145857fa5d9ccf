// The colour of slits at many changes of the direction cosine, by the evaluator that the scene's one grating has, as the
// renderer computes it: the continuous spectrum, and lines, seen from their far field.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_samplerless_texture_functions : require
#define BANDS 1u
#include "bindings.glsl"
layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 19) readonly buffer InputBlock { vec2 inputs[]; };       // u, width of the window
layout(scalar, set = 0, binding = 20) writeonly buffer ResultBlock { vec4 results[]; };    // X, Y, Z, and 1 where it was 0/0
#include "phase.glsl"
#include "spectral.glsl"
#include "fresnel.glsl"
#include "beam.glsl"
#include "evaluators.glsl"
#include "pairs.glsl"

void main() {
    SlitGrating g = slitGratingAt(0u);
    vec2 window = inputs[gl_GlobalInvocationID.x];
    vec3 color = vec3(0.0);
    if (HAS_PAIRS_EVALUATOR != 0u) {
        // In the middle of the beam, and so far away that pairs have their far field: two slits' Fresnel phase for half a
        // millimetre is 5e-5 of a turn, while the beam's edges are still ten Fresnel widths off.
        GratingView v = viewFrom(g, 1e4 * g.normal);
        throughput.band[0] = 1.0;
        throughput.bands = 0u;
        v.smear = vec2(0.0);
        color += pairColor(g, v, 0u, window.x, window.y);
    } else if (HAS_SLIT_CONTINUUM != 0u) color += slitColor(g, 0u, 0u, window.x, window.y);
    if (HAS_SLIT_LINES != 0u) {
        for (uint i = 0u; i < decided(g.lineCount); ++i) {
            uint record = g.lines + 4u * i;
            color += lineDensity(g, window.x, window.y, tables[record]) * tableColor(record + 1u);
        }
    }
    results[gl_GlobalInvocationID.x] = vec4(color, metNonFinite ? 1.0 : 0.0);
}
