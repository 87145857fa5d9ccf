// The renderer for scenes where metals colour the light on the way to the eye: paths carry a band of wavelengths.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#define BANDS SPECTRAL_BANDS
#include "render.glsl"
