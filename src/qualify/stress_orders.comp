// Orders of optical discs: which there are, and what each takes of the light (disc.glsl). VARIANT says of which track
// (stress_orders.cpp).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#define BANDS SPECTRAL_BANDS
#include "probe.glsl"
#include "interface.h"

struct SceneAtHand {
    Frame frame;
};
SceneAtHand scene;
const uint HAS_POINT_LIGHTS = 1u, HAS_SPOT_LIGHTS = 1u, HAS_DIRECTIONAL_LIGHTS = 1u, HAS_RECTANGLE_LIGHTS = 1u,
           HAS_DISC_LIGHTS = 1u, HAS_SPHERE_LIGHTS = 1u, HAS_ENVIRONMENT = 1u, HAS_GROOVES = 1u, HAS_SCATTERING = 0u,
           HAS_DISC_CONTINUUM = 1u, HAS_DISC_LINES = 1u, IS_ORTHOGRAPHIC = 0u;
const float INFINITY = 1e30, MIDDLE_WAVE = 0.55e-6;
float tables[1];
vec3 tableColor(uint at) { return vec3(0.0); }
uint decided(uint value) { return value; }

#include "phase.glsl"
#include "fresnel.glsl"
#include "sampler.glsl"
#include "shapes.glsl"
#include "spectral.glsl"
#include "materials.glsl"
#include "lights.glsl"
#include "chords.glsl"
#include "disc.glsl"

void main() {
    OpticalDisc disc;
    disc.metal = NO_METAL;
    disc.pitch_um = given(1u);
    disc.depth_um = given(2u);
    disc.bend = disc.index = given(3u);
    disc.pitWidth_um = given(7u);
    disc.pits = 0.25;                      // so that the undeviated light never vanishes
    disc.grooveSlope = 0.0;
    disc.isGiven = 0u;
    disc.isCoarse = VARIANT;
    disc.orderCount = 6u;
    TrackView view;
    view.out_ = given2(5u);
    view.cosOut = sqrt(max(1.0 - dot(view.out_, view.out_), 0.0));
    give(0u, orderShare(disc, view, given(0u), given(4u)));
}
