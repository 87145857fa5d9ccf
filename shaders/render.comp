// The renderer for scenes where the light on the way to the eye keeps its colour: no metals.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#define BANDS 1u
#include "render.glsl"
