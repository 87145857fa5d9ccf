// The renderer, in variants (CMakeLists.txt), each with the code that scenes of its kind need and no more: drivers take
// a tenth of a second and more to read past the rest.
//   BANDED    1: metals colour the light on the way to the eye, paths carry a band of wavelengths
//   SLITS, OPENINGS, DISCS  1: the scene has gratings or discs of that kind
//   TREE      1: there are so many shapes that a tree holds them
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_samplerless_texture_functions : require
#if BANDED
#define BANDS SPECTRAL_BANDS
#else
#define BANDS 1u
#endif
#include "render.glsl"
