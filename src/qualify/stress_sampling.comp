// Samples, camera rays and colours: sampler.glsl, lights.glsl, camera.glsl, spectral.glsl. VARIANT says which
// (stress_sampling.cpp).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#define BANDS SPECTRAL_BANDS
#include "probe.glsl"
#include "interface.h"

// A scene for each evaluation.
struct SceneAtHand {
    Frame frame;
};
SceneAtHand scene;
const uint IS_SPECTRUM = 0u, IS_ORTHOGRAPHIC = 0u, HAS_LENS = 1u, HAS_SEVERAL_SAMPLES = 1u;
const uint HAS_POINT_LIGHTS = 1u, HAS_SPOT_LIGHTS = 1u, HAS_DIRECTIONAL_LIGHTS = 1u, HAS_RECTANGLE_LIGHTS = 1u,
           HAS_DISC_LIGHTS = 1u, HAS_SPHERE_LIGHTS = 1u;
const float INFINITY = 1e30;
uint decided(uint value) { return value; }
vec3 tableColor(uint at) { return vec3(0.0); }

#include "sampler.glsl"
#include "lights.glsl"
#include "spectral.glsl"
struct Path {
    vec3 origin;
    vec3 direction;
    uint depth;
    float travelled;
};
#include "camera.glsl"

void give2(uint i, vec2 v) { give(i, v.x); give(i + 1u, v.y); }
void give3(uint i, vec3 v) { give2(i, v.xy); give(i + 2u, v.z); }

uint seedAt(uint i) { return uint(given(i)) << 16 | uint(given(i + 1u)); }

void main() {
    if (VARIANT == 0u) {
        give2(0u, samplePair(seedAt(0u), uint(given(2u)), uint(given(3u))));
    } else if (VARIANT == 1u) {
        give2(0u, sampleRing(given2(0u), given(2u)));
    } else if (VARIANT == 2u) {
        vec3 t, b;
        completeFrame(given3(0u), t, b);
        give3(0u, t);
        give3(3u, b);
    } else if (VARIANT == 3u) {
        Light light;
        light.kind = SPHERE_LIGHT;
        light.radius = given(8u);
        light.emission = 1.0;
        light.twoSided = 1u;
        Incident incident = fromSphere(light, given3(0u), given3(3u), given2(6u));
        give3(0u, incident.direction);
        give(3u, incident.distance);
        give(4u, incident.irradiance);
    } else if (VARIANT == 4u) {
        scene.frame.width = 1000u;
        scene.frame.height = 1000u;
        scene.frame.camera = Camera(given3(5u), given3(8u), given3(11u), given3(14u), given3(17u), given3(20u), given(23u));
        Path path = cameraRay(given2(3u), seedAt(0u), uint(given(2u)));
        give3(0u, path.origin);
        give3(3u, path.direction);
    } else if (VARIANT == 5u) {
        for (uint k = 0u; k < BANDS; ++k) throughput.band[k] = bandMiddle_um(k);
        throughput.bands = BANDS;
        give(0u, throughputAt(given(0u)));
    } else {
        give3(0u, xyzFromLinearSrgb(given3(0u)));
    }
}
