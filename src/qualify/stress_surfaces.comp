// What surfaces do to light: Fresnel's equations (materials.glsl). VARIANT says which (stress_surfaces.cpp).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "probe.glsl"
#include "materials.glsl"

void main() {
    if (VARIANT == 0u) {
        float cosTransmitted;
        give(0u, fresnelDielectric(given(0u), given(1u), cosTransmitted));
        give(1u, cosTransmitted);
    } else {
        give(0u, fresnelConductor(given(0u), given(1u), given(2u)));
    }
}
