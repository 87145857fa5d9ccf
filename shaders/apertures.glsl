// Far fields of apertures, relative to their peak: |A|^2/|A(0)|^2 (M. Born, E. Wolf, "Principles of Optics", 7th ed., 8.5).
// u, v are the differences of direction cosines, outgoing less incoming, across the slits and along them; lengths come in
// wavelengths, as (high, low) where one float is too few (phase.glsl, which is included first).
// The includer defines vec2 apertureVertex(uint index): a polygon's corners about its centroid, in micrometres.

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

float rectanglePattern(vec2 uv, vec2 sizeInWaves) {
    return slitFactor(uv.x * sizeInWaves.x) * slitFactor(uv.y * sizeInWaves.y);
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

float circlePattern(vec2 uv, float diameterInWaves) {
    float amplitude = airyAmplitude(length(uv) * diameterInWaves);
    return amplitude * amplitude;
}

// `inner`: the hole's diameter over the ring's. The difference of two discs: error 5e-7/(1 - inner^2).
float ringPattern(vec2 uv, float diameterInWaves, float inner) {
    float x = length(uv) * diameterInWaves;
    float share = inner * inner;
    float amplitude = (airyAmplitude(x) - share * airyAmplitude(inner * x)) / (1.0 - share);
    return amplitude * amplitude;
}

// The polygon of vertices first..first + count - 1 at a frequency of uv/wavelength. By Green's theorem a sum over its
// edges; 1 is taken from each phase factor, which leaves the sum as it is and keeps its digits near the peak.
// Error: 3e-7 times perimeter * radius/area, 3 for a disc.
float polygonPattern(vec2 f_per_um, uint first, uint count, float area_um2) {
    float square = dot(f_per_um, f_per_um);
    if (square < 1e-24) return 1.0;                        // under 1e-12 of a turn per um: it would underflow
    vec2 sum = vec2(0.0);
    vec2 from = apertureVertex(first + count - 1u);
    for (uint i = first; i < first + count; ++i) {
        vec2 to = apertureVertex(i);
        vec2 edge = to - from;
        float turns = 0.5 * dot(f_per_um, from + to);
        float less = sincLessOne(dot(f_per_um, edge));
        // sin and sin^2 of half the phase, pi turns, and its cosine by a quarter turn: sin(2 x) = 2 sin(x) cos(x)
        float half_ = turns - roundEven(turns);
        float sine = half_ * sinPiOverX(half_ * half_);
        float quarter = 0.5 - abs(half_);
        float cosine = quarter * sinPiOverX(quarter * quarter);
        float weight = f_per_um.x * edge.y - f_per_um.y * edge.x;
        sum += weight * vec2((1.0 + less) * 2.0 * sine * cosine, less - (1.0 + less) * 2.0 * sine * sine);
        from = to;
    }
    vec2 amplitude = sum * (0.159154943 / (square * area_um2));   // 1/(2 pi)
    return dot(amplitude, amplitude);
}

// What many cells make of one cell's pattern, their vectors `first` and `second` in wavelengths, (x, y) high and (z, w) low.
float latticeFactor(vec2 uv, vec4 first, vec4 second, vec2 counts) {
    return fejer(turnsPastOrder(uv, first.xz, first.yw), counts.x) *
           fejer(turnsPastOrder(uv, second.xz, second.yw), counts.y);
}
