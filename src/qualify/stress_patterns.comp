// Far fields and Fresnel's edges: a function of phase.glsl, apertures.glsl or fresnel.glsl at many inputs.
// VARIANT says which (stress_patterns.cpp).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "probe.glsl"
#include "phase.glsl"

vec2 apertureVertex(uint first, uint index) { return given2(first + 2u * index); }
float maskEntry(uint at) { return 0.0; }
#include "apertures.glsl"
#include "fresnel.glsl"

// Slits by the formula as printed in the thesis, phases in radians and the driver's own sine, relative to the peak.
float slitsAsPrinted(float u, float width, float period, float count) {
    float x = 3.14159265 * width * u, y = 3.14159265 * period * u;
    float single = sin(x) / x, many = sin(count * y) / sin(y);
    return single * single * many * many / (count * count);
}

// One half of a polygon with a centre of symmetry: three edges, four vertices.
float symmetricPolygon(vec2 uv, float wavenumber, float area) {
    float sum = 0.0;
    for (uint i = 0u; i < 3u; ++i)
        sum += pairOfEdges(polygonEdge(uv, apertureVertex(4u, i), apertureVertex(4u, i + 1u)), wavenumber);
    return symmetricPolygonIntensity(sum, wavenumber * dot(uv, uv) * area);
}

float lattice(vec2 uv, float wavenumber) {
    float first = fejer(turnsPastOrder(wavenumber, wayPerCell(uv, given4(3u))), given(11u));
    return first * fejer(turnsPastOrder(wavenumber, wayPerCell(uv, given4(7u))), given(12u));
}

float evaluate() {
    if (VARIANT == 0u) return slitFactor(given(0u));
    if (VARIANT == 1u) return arrayFactor(given(0u), given(1u)) / (given(1u) * given(1u));
    if (VARIANT == 2u) return slitsPattern(given(0u), given(1u), given2(2u), given(4u));
    if (VARIANT == 3u) return slitsAsPrinted(given(0u), given(1u), given(2u), given(4u));
    if (VARIANT == 4u) return slitFactor(given(0u) * given(2u)) * slitFactor(given(1u) * given(3u));
    if (VARIANT == 5u) return circlePattern(given(0u));
    if (VARIANT == 6u) return ringPattern(given(0u), given(1u));
    if (VARIANT == 7u) return stripIntensity(given(0u), given(1u), 0.0);
    if (VARIANT == 10u) return polygonPattern(given2(0u), given(2u), 4u, 6u, given(3u));
    if (VARIANT == 11u) return symmetricPolygon(given2(0u), given(2u), given(3u));
    return lattice(given2(0u), given(2u));
}

void main() { give(0u, evaluate()); }
