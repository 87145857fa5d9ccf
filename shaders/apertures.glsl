// Far fields of apertures, relative to their peak: |A|^2/|A(0)|^2 (M. Born, E. Wolf, "Principles of Optics", 7th ed., 8.5).
// u, v are the differences of direction cosines, outgoing less incoming, across the slits and along them; lengths come in
// wavelengths, as (high, low) where one float is too few (phase.glsl, which is included first).
// The includer defines vec2 apertureVertex(uint first, uint index), a polygon's corners about its centroid, in
// micrometres. Masks have a file of their own (masks.glsl).

// sin(pi x)/(pi x) - 1, with all its digits near 0 (coefficients: docs/aperture_coefficients.py).
float sincLessOne(float x) {
    float z = x * x;
    float near = z * (-1.64493407 + z * (0.811742371 + z * (-0.190750075 + z * (0.0261281335 - 0.00225520133 * z))));
    return abs(x) <= 0.5 ? near : sincOf(x) - 1.0;
}

// Few and many slits.
float slitsPattern(float u, float widthInWaves, vec2 periodInWaves, float count) {
    return slitFactor(u * widthInWaves) * fejer(turnsPastOrder(u, periodInWaves), count);
}

// 2 J1(pi x)/(pi x) for x >= 0: a polynomial, then modulus and phase of the Bessel function (DLMF 10.18), fitted by
// docs/aperture_coefficients.py; error 3e-7.
float airyAmplitude(float x) {
    if (x <= 1.25) {
        float z = x * x;
        return 0.999999994 + z * (-1.23370016 + z * (0.507335012 + z * (-0.104301875 +
               z * (0.0128408618 + z * (-0.00103089277 + z * 4.88120857e-05)))));
    }
    float inverse = 1.0 / x;
    float s = inverse * inverse;
    float modulus = 0.286580014 + s * (0.00543600552 + s * (-0.000518243816 + s * 0.000100222958));
    float phase = 0.0379947147 + s * (-0.00167282545 + s * (0.000323085758 - s * 7.74548217e-05));
    // cos(pi (x - 3/4 + phase/x)) = sin(pi (x - 1/4 + phase/x))
    float past = x - 2.0 * roundEven(0.5 * x);             // exact
    float angle = past - 0.25 + phase * inverse;
    float reduced = angle - roundEven(angle);
    float sine = reduced * sinPiOverX(reduced * reduced);
    return inverse * sqrt(inverse) * modulus * ((int(roundEven(angle)) & 1) == 0 ? sine : -sine);
}

// Of round openings at x = diameter * frequency.
float circlePattern(float x) {
    float amplitude = airyAmplitude(x);
    return amplitude * amplitude;
}

// `inner`: the hole's diameter over the ring's. The difference of two discs: error 5e-7/(1 - inner^2).
float ringPattern(float x, float inner) {
    float share = inner * inner;
    float amplitude = (airyAmplitude(x) - share * airyAmplitude(inner * x)) / (1.0 - share);
    return amplitude * amplitude;
}

// An edge of a polygon at one direction, before a wavenumber is chosen: turns per wavenumber at its middle and along it,
// and its weight by Green's theorem (docs/theory.md, "Openings").
vec3 polygonEdge(vec2 uv, vec2 from, vec2 to) {
    vec2 edge = to - from;
    return vec3(0.5 * dot(uv, from + to), dot(uv, edge), uv.x * edge.y - uv.y * edge.x);
}

// ---- means over fringes: the pattern where these are too fine to be told apart --------------------------------------

// Root of the mean of (sin(pi x)/(pi x))^2 over fringes and over a window about x: the main lobe as it is and sin^2 by 1/2
// from where that is as much. Of wide windows side by side, the one that holds the middle gets all but 0.2/window, which
// lies beyond.
float slitMeanRoot(float x, float window) {
    float far = abs(x);
    if (max(far, 0.5) < 0.5 * window) return inversesqrt(window + 0.2);
    return far < 0.75 ? 0.318309886 * sinPiOverX(x * x) : 0.225079079 / far;
}
float airyMean(float x) { return 1.0 / (1.0 + 24.3522727 * x * x * x); }        // pi^4/4: DLMF 10.17.3
// `beat`: what is left of the fringes between the two rims.
float ringMean(float x, float inner, float beat) {
    float share = inner * inner, outside = airyMean(x), inside = airyMean(inner * x);
    float between = (1.0 - inner) * x, past = between - 2.0 * roundEven(0.5 * between), quarter = 0.5 - abs(past);
    float cosine = quarter * sinPiOverX(quarter * quarter);
    float sum = outside + share * share * inside - 2.0 * beat * cosine * share * sqrt(outside * inside);
    return min(sum / ((1.0 - share) * (1.0 - share)), 1.0);
}

// ---- polygons -------------------------------------------------------------------------------------------------------

// What an edge adds to the amplitude of a polygon, times 2 pi i wavenumber |uv|^2. 1 is taken from each phase factor,
// which leaves the sum over a closed outline as it is and keeps its digits near the peak.
vec2 edgeWave(vec3 edge, float wavenumber) {
    float turns = edge.x * wavenumber;
    float less = sincLessOne(edge.y * wavenumber);
    // sin and sin^2 of half the phase, pi turns, and its cosine by a quarter turn: sin(2 x) = 2 sin(x) cos(x)
    float half_ = turns - roundEven(turns);
    float sine = half_ * sinPiOverX(half_ * half_);
    float quarter = 0.5 - abs(half_);
    float cosine = quarter * sinPiOverX(quarter * quarter);
    return edge.z * vec2((1.0 + less) * 2.0 * sine * cosine, less - (1.0 + less) * 2.0 * sine * sine);
}

// Half of what an edge and the one opposite add where a polygon has a centre of symmetry: the wave is real then, and no
// digits cancel.
float pairOfEdges(vec3 edge, float wavenumber) {
    float halfTurns = 2.0 * edge.x * wavenumber, along = edge.y * wavenumber;
    float whole = roundEven(halfTurns), wholeAlong = roundEven(along);
    float phase = halfTurns - whole, rest = along - wholeAlong;
    float ratio = wholeAlong == 0.0 ? 1.0 : rest / along;  // no 0/0
    float amplitude = edge.z * ratio * sinPiOverX(rest * rest);
    float value = amplitude * phase * sinPiOverX(phase * phase);
    int odd = (int(whole) + int(wholeAlong)) & 1;
    return odd != 0 ? -value : value;
}

// From the sum over the edges of their waves. `scale`: wavenumber |uv|^2 area in um. Error: 3e-7 times perimeter *
// radius/area, 3 for a disc.
float polygonIntensity(vec2 sum, float scale) {
    if (scale < 1e-24) return 1.0;                         // so near the peak that it would underflow
    vec2 amplitude = 0.159154943 / scale * sum;            // 1/(2 pi)
    return dot(amplitude, amplitude);
}
// pairOfEdges() gives pi / 2 times as much.
float symmetricPolygonIntensity(float sum, float scale) { return polygonIntensity(vec2(0.636619772 * sum, 0.0), scale); }

// The polygon whose `count` vertices begin at `first`.
float polygonPattern(vec2 uv, float wavenumber, uint first, uint count, float area_um2) {
    vec2 sum = vec2(0.0);
    vec2 from = apertureVertex(first, count - 1u);
    for (uint i = 0u; i < count; ++i) {
        vec2 to = apertureVertex(first, i);
        sum += edgeWave(polygonEdge(uv, from, to), wavenumber);
        from = to;
    }
    return polygonIntensity(sum, wavenumber * dot(uv, uv) * area_um2);
}

// Its mean over fringes: the sum of its corners' powers, of the waves of two edges that meet there. Of an edge's own wave,
// whose two ends are alike but for their sign, the mean is taken over what the sample sees: `perPixel` as in OpeningView,
// and `step_` from one wavenumber of the list to the next. The first `corners` of `count` stand for all.
float polygonMean(vec2 uv, mat2 perPixel, float step_, float wavenumber, uint first, uint count, uint corners, float area_um2) {
    float sum = 0.0, before = 0.0, start = 0.0;
    for (uint i = 0u; i < corners; ++i) {
        vec2 from = apertureVertex(first, i), to = apertureVertex(first, i + 1u < count ? i + 1u : 0u);
        vec3 edge = polygonEdge(uv, from, to);
        float along = edge.y * wavenumber;
        float wave = edge.z * slitMeanRoot(along, length((to - from) * perPixel) * wavenumber + abs(edge.y) * step_);
        float end = wave * clamp(2.0 * along, -1.0, 1.0);  // in the main lobe the ends are not told apart
        if (i == 0u) start = end;
        sum += wave * wave - before * end;
        before = end;
    }
    sum -= before * start;
    float perWave = 0.159154943 / max(wavenumber * dot(uv, uv) * area_um2, 1e-18);
    return min(perWave * perWave * float(count) / float(corners) * sum, 1.0);
}

// How much longer the way from one cell of a lattice is than from the next, `step_um` away: (high, low), in micrometres,
// which times the wavenumber is turns. `step_um` is (x, y) high and (x, y) low.
vec2 wayPerCell(vec2 uv, vec4 step_um) {
    precise float x = uv.x * step_um.x, y = uv.y * step_um.y;
    precise float xLow = productError(uv.x, step_um.x, x) + uv.x * step_um.z;
    precise float yLow = productError(uv.y, step_um.y, y) + uv.y * step_um.w;
    return sumOfTwo(vec2(x, xLow), vec2(y, yLow));
}
