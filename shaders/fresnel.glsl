// Fresnel diffraction by the edges of a strip, without the built-in sin and cos.

// (sin(pi h), cos(pi h)) for h in half turns; error 3e-7 plus that of h itself.
vec2 sinCosPi(float h) {
    float quarter = roundEven(2.0 * h);
    float r = h - 0.5 * quarter;                           // exact, |r| <= 1/4
    float z = r * r;
    float sine = r * sinPiOverX(z);
    float cosine = 1.0 + z * (-4.93480220 + z * (4.05871213 + z * (-1.33526277 + z * 0.23533063)));
    int turn = int(quarter) & 3;
    vec2 both = (turn & 1) == 0 ? vec2(sine, cosine) : vec2(cosine, -sine);
    return turn >= 2 ? -both : both;
}

// The auxiliary functions f and g of the Fresnel integrals (DLMF 7.2.10-11) for a >= 0 as quotients of polynomials, fitted
// by docs/fresnel_coefficients.py; error 5e-7.
vec2 fresnelAuxiliary(float a) {
    float f = (0.500000132 + a * (1.03651317 + a * (0.809689269 + a * (0.717828519 + a * (0.222446471 + a * 0.185384385))))) /
              (1.0 + a * (2.07307621 + a * (3.18868035 + a * (2.61471215 + a * (2.24611122 + a * (0.699241451 + a * 0.582402221))))));
    float g = (0.499999642 + a * (0.176199538 + a * (0.0960100942 + a * 0.0579478831))) /
              (1.0 + a * (2.35228202 + a * (3.32878857 + a * (3.04967901 + a * (2.24254758 + a * (0.900621072 + a * 0.571922682))))));
    return vec2(f, g);
}

// What an edge adds to its geometric shadow: (C(x), S(x)) less +-1/2, a wave of phase pi x^2/2 (DLMF 7.5.3-4).
vec2 edgeWave(float x, vec2 auxiliary) {
    vec2 sc = sinCosPi(0.5 * x * x);
    vec2 wave = vec2(auxiliary.x * sc.x - auxiliary.y * sc.y, -auxiliary.x * sc.y - auxiliary.y * sc.x);
    return x < 0.0 ? -wave : wave;
}

// (C(to), S(to)) - (C(from), S(from)).
vec2 stripAmplitude(float from, float to) {
    float direct = 0.5 * ((to < 0.0 ? -1.0 : 1.0) - (from < 0.0 ? -1.0 : 1.0));
    return vec2(direct) + edgeWave(to, fresnelAuxiliary(abs(to))) - edgeWave(from, fresnelAuxiliary(abs(from)));
}

// How much is left of a wave whose phase, at `turns` of it for one wavelength, depends on wavelength.
// `bandwidth` > 0: the mean over wavelengths weighted by a hat of half width `bandwidth` times the wavelength.
// `bandwidth` < 0: what to give at wavelengths that lie -bandwidth apart, relative to themselves, and are interpolated
// between linearly: that takes a factor sinc^2 from the wave, made good here; near half a turn per step the wave ends,
// before it comes back as an alias.
float fading(float turns, float bandwidth) {
    float perStep = abs(turns * bandwidth);
    float mean = slitFactor(perStep);
    return bandwidth >= 0.0 ? mean : (1.0 - smoothstep(0.3, 0.55, perStep)) / max(mean, 0.1);
}

// Intensity behind a strip in units of the light that falls on it (Born & Wolf, Principles of Optics, 8.7): 1 deep inside
// its shadow's edges, 1/4 at an edge. `from` and `to`: the edges less the point, times sqrt(2 curvature / wavelength).
// `bandwidth`: see fading().
float stripIntensity(float from, float to, float bandwidth) {
    vec2 atFrom = fresnelAuxiliary(abs(from)), atTo = fresnelAuxiliary(abs(to));
    vec2 waveFrom = edgeWave(from, atFrom), waveTo = edgeWave(to, atTo);
    float direct = 0.5 * ((to < 0.0 ? -1.0 : 1.0) - (from < 0.0 ? -1.0 : 1.0));
    float ripple = fading(0.25 * to * to, bandwidth) * (waveTo.x + waveTo.y) -
                   fading(0.25 * from * from, bandwidth) * (waveFrom.x + waveFrom.y);
    float beat = fading(0.25 * (to * to - from * from), bandwidth) * dot(waveTo, waveFrom);
    return direct * direct + direct * ripple + 0.5 * (dot(atFrom, atFrom) + dot(atTo, atTo)) - beat;
}
