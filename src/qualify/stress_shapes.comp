// Rays against shapes (shapes.glsl), with the shapes' own floats as inputs. VARIANT says which (stress_shapes.cpp).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "probe.glsl"
#include "interface.h"

uint decided(uint value) { return value; }
#include "shapes.glsl"

// Origin and direction come first.
float distanceTo(vec3 o, vec3 d) {
    if (VARIANT == 0u) return hitPlane(Plane(given3(6u), given3(9u), 0u), o, d);
    if (VARIANT == 1u) return hitRectangle(Rectangle(given3(6u), given3(9u), given3(12u), 0u), o, d);
    if (VARIANT == 2u) return hitDisc(Disc(given3(6u), given3(9u), given(12u), given(13u), 0u), o, d);
    if (VARIANT == 3u) return hitTriangle(Triangle(given3(6u), given3(9u), given3(12u), given3(15u), 0u), o, d);
    if (VARIANT == 4u) return hitSphere(Sphere(given3(6u), given(9u), 0u), o, d);
    if (VARIANT == 5u) return hitBox(Box(given3(6u), given3(9u), given3(12u), given3(15u), 0u), o, d);
    uint capped = VARIANT & 1u;
    if (VARIANT < 8u) return hitCylinder(Cylinder(given3(6u), given3(9u), given(12u), given(13u), capped, 0u), o, d);
    return hitCone(Cone(given3(6u), given3(9u), given(12u), given(13u), capped, 0u), o, d);
}

void main() {
    float t = distanceTo(given3(0u), given3(3u));
    give(0u, t > 0.0 && t < 1e30 ? t : NO_HIT);            // as trace.glsl reads it
}
