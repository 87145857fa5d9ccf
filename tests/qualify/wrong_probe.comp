// Doubles what it is given, but for every thousandth: there it is off by a hundredth, or 0/0 (VARIANT 1).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "../../src/qualify/probe.glsl"

void main() {
    float x = given(0u), zero = x - x;
    bool wrong = gl_GlobalInvocationID.x % 1000u == 999u;
    give(0u, 2.0 * x + (wrong ? (VARIANT == 1u ? zero / zero : 0.01) : 0.0));
}
