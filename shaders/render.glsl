// The renderer: one invocation takes one sample of one pixel and adds it to the film. Samples are dispatched in their
// order, so the sum depends neither on tiles nor on batches.

#include "bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

// What a variant has none of ends here.
#if !SLITS
#define SLIT_GRATING_COUNT 0u
#endif
#if !OPENINGS
#define OPENING_GRATING_COUNT 0u
#endif
#if !DISCS
#define OPTICAL_DISC_COUNT 0u
#define CASTING_DISC_COUNT 0u
#define HAS_HUBS 0u
#endif

#if !TREE
#define TREE_DEPTH 0u
#endif

#include "sampler.glsl"
#include "phase.glsl"
#include "spectral.glsl"
#include "fresnel.glsl"
#include "thesis.glsl"
#include "shapes.glsl"
#include "trace.glsl"
#include "materials.glsl"
#include "lights.glsl"
#include "beam.glsl"
#include "evaluators.glsl"
#include "pairs.glsl"
#include "slits.glsl"
#include "opening_lights.glsl"
#include "chords.glsl"
#include "disc.glsl"
#include "disc_light.glsl"
#include "path.glsl"
#include "camera.glsl"

void main() {
    uint x = gl_GlobalInvocationID.x;
    uint y = firstRow + gl_GlobalInvocationID.y;
    uint sampleIndex = gl_WorkGroupID.z;
    uint pixel = gl_GlobalInvocationID.y * scene.frame.filmWidth + x;
    uint pixelSeed = hashMix(hashCombine(hashMix(y * scene.frame.width + x), scene.frame.seed));

    vec2 within = vec2(0.5);
    if (HAS_SEVERAL_SAMPLES != 0u) within = samplePair(pixelSeed, sampleIndex, 0u);
    Sample sample_ = Sample(vec3(0.0), false, pixelSeed, sampleIndex, 2u);
    tracePath(cameraRay(vec2(x, y) + within, pixelSeed, sampleIndex), sample_);

    FilmPixel result = film[pixel];
    result.sum += sample_.radiance;
    result.state += 1u;
    if (sample_.nonFinite) result.state |= NON_FINITE;
    film[pixel] = result;
}
