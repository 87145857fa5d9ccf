// The renderer: one invocation takes `sampleCount` samples of one pixel and adds them to the film, in order, so that
// the sum does not depend on how the samples were split into dispatches.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#include "bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform TileBlock { Tile tile; };

#include "sampler.glsl"
#include "phase.glsl"
#include "thesis.glsl"
#include "shapes.glsl"
#include "trace.glsl"
#include "materials.glsl"
#include "lights.glsl"
#include "path.glsl"
#include "camera.glsl"

void main() {
    if (gl_GlobalInvocationID.x >= tile.width || gl_GlobalInvocationID.y >= tile.height) return;
    uint x = tile.x + gl_GlobalInvocationID.x;
    uint y = tile.y + gl_GlobalInvocationID.y;
    uint pixel = (y - tile.firstRow) * scene.frame.width + x;
    uint pixelSeed = hashMix(hashCombine(hashMix(y * scene.frame.width + x), scene.frame.seed));

    FilmPixel result = FilmPixel(vec3(0.0), 0u);
    if (tile.firstSample != 0u) result = film[pixel];
    for (uint i = 0u; i < tile.sampleCount; ++i) {
        uint index = tile.firstSample + i;
        vec2 within = vec2(0.5);
        if (HAS_SEVERAL_SAMPLES != 0u) within = samplePair(pixelSeed, index, 0u);
        Sample sample_ = Sample(vec3(0.0), false, pixelSeed, index, 2u);
        tracePath(cameraRay(vec2(x, y) + within, pixelSeed, index), sample_);
        result.sum += sample_.radiance;
        if (sample_.nonFinite) result.state |= NON_FINITE;
    }
    result.state += tile.sampleCount;
    film[pixel] = result;
}
