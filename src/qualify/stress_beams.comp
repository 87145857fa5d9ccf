// Beams behind slits and openings, and what is looked up in tables: a function of beam.glsl, slits.glsl or masks.glsl at
// many inputs. VARIANT says which (stress_beams.cpp).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#define BANDS 1u
#include "probe.glsl"
#include "interface.h"

struct SceneAtHand {
    Frame frame;
};
SceneAtHand scene;
const uint HAS_RIPPLES = 1u, HAS_BAND_RESPONSES = 1u, HAS_GAUSSIAN_BEAMS = 1u, HAS_ORDER_SHARES = 1u, HAS_WIDE_GRATINGS = 1u, HAS_SLIT_CONTINUUM = 1u,
           HAS_SLIT_LINES = 1u, HAS_TABLE_EVALUATOR = 1u, HAS_ORDERS_EVALUATOR = 1u, HAS_DIRECT_EVALUATOR = 1u,
           HAS_SMALL_ANGLE_EVALUATOR = 1u, HAS_NAIVE_EVALUATOR = 1u, HAS_PAIRS_EVALUATOR = 1u;
uint decided(uint value) { return value; }
float tables[1];
vec3 tableColor(uint at) { return vec3(0.0); }
vec2 apertureVertex(uint first, uint index) { return vec2(0.0); }
float maskEntry(uint at) { return given(4u + at); }

// Six entries of a response table from number `given(4u)` on; integers come in halves, which are exact as floats.
uint wordAt(uint i) { return uint(given(i)) << 16 | uint(given(i + 1u)); }
uvec4 responseEntry(uint number) {
    uint at = min(number - uint(given(4u)), 5u);
    return uvec4(wordAt(5u + 8u * at), wordAt(7u + 8u * at), wordAt(9u + 8u * at), wordAt(11u + 8u * at));
}

#include "phase.glsl"
#include "spectral.glsl"
#include "apertures.glsl"
#include "masks.glsl"
#include "fresnel.glsl"
#include "beam.glsl"
#include "evaluators.glsl"
#include "pairs.glsl"
#include "slits.glsl"

void main() {
    SlitGrating g;
    if (VARIANT <= 1u) {
        g.convergence = given(4u);
        uint profile = VARIANT == 0u ? RECTANGULAR_BEAM : GAUSSIAN_BEAM;
        give(0u, footprint(g, profile, given(0u), given(1u), given(2u), given(3u), 0.0, 0.0));
    } else if (VARIANT == 2u) {
        g.convergence = given(6u);
        g.halfWidth = given(4u);
        g.halfSlits = given(4u);
        give(0u, discFootprint(g, given2(0u), given2(2u), given(5u), 0.0, vec2(0.0)));
    } else if (VARIANT == 3u) {
        vec2 frequency = given2(0u) * given(2u);
        give(0u, maskPattern(frequency, 0u, vec2(4.0), SHARP_MASK, false) * slitFactor(frequency.x) * slitFactor(frequency.y));
    } else if (VARIANT == 4u) {
        g.zeroEntry = uint(given(2u));
        g.perU = given(3u);
        g.entries = uint(given(4u)) + 6u;
        g.slopeUnit = 1.0;
        g.integralUnit = 1.0;
        vec3 mean = meanResponse(g, 0u, given(0u), given(1u));
        give(0u, mean.x);
        give(1u, mean.y);
        give(2u, mean.z);
    } else {
        // Order given(0u) of slits along y that light comes straight through, where no ripple shows.
        g.across = vec3(1.0, 0.0, 0.0);
        g.along = vec3(0.0, 1.0, 0.0);
        g.normal = vec3(0.0, 0.0, 1.0);
        g.alphaIn = given(3u);
        g.betaIn = given(4u);
        g.profile = RECTANGULAR_BEAM;
        g.halfWidth = g.halfHeight = g.halfSlits = given(5u);
        g.convergence = 0.0;
        g.irradiance = 1.0;
        g.width_um = given(2u);
        g.period_um = given(2u);
        g.orderCount = 1u;
        vec3 offset = given3(6u);
        GratingView v = viewFrom(g, offset);
        v.smear = vec2(given(9u));
        give(0u, orderIrradiance(g, v, offset, vec3(0.0, 0.0, -1.0), given(0u), 1.0, given(1u), 0.0));
    }
}
