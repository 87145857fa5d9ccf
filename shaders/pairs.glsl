// A few coarse slits in even light, pair by pair (docs/theory.md, "Few coarse slits"). Where periods are tens of micrometres
// the far field of the row begins beyond the room, and orders are too wide for images of the beam that do not interfere. But
// two slits make Young's fringes at any distance, as if seen from the middle between them: Fresnel's phase is quadratic across
// the row. Pairs k periods apart add up to one harmonic of the pattern, in closed form.

// sinc(s), its slope and its curvature.
vec3 sincAndSlopes(float s) {
    float value = sincOf(s);
    float z = s * s;
    float slope = -3.28986813 * s * (1.0 - 0.98696044 * z), curve = -3.28986813 * (1.0 - 2.96088132 * z);   // to s^5
    if (abs(s) > 0.1) {
        slope = (sinCosPi(s).y - value) / s;
        curve = -9.86960440 * value - 2.0 * slope / s;
    }
    return vec3(value, slope, curve);
}

// The pattern of all slits in one wavelength, as a mean over a window `blur` of u, relative to the peak of the far field.
// `curvature`: change of u per metre across the slits. `period` and `width` in wavelengths. `step_`: to the next wavelength of
// the list that holds this one, relative to it; colours in a list are means over hats of this half width, which takes
// sinc^2 off a harmonic, to be given back. `furthest`: so many periods apart are the last pairs that count.
float pairPattern(SlitGrating g, float u, float curvature, float period, float width, float step_, float furthest,
                  float blur) {
    float perSlit = curvature * 1e-6 * g.period_um;        // change of u
    float chirp = perSlit * period;
    float drift = perSlit * width;                         // of a slit's own pattern from one to the next, in its units
    // That pattern to the second order about the row's middle: the product of two slits' values.
    vec3 slit = sincAndSlopes(width * u);
    float even = slit.x * slit.x;
    float squares = 0.25 * drift * drift;
    float bent = slit.x * slit.z, tilted = slit.y * slit.y;
    float leaning = 2.0 * slit.x * slit.y * drift;
    // How it changes across the window: what a fringe's mean there leaves of its product with that.
    float across = width * blur;
    float rising = 2.0 * slit.x * slit.y * across / 6.28318531, bending = (tilted + bent) * across * across / 39.4784176;

    float turns = period * u;
    vec2 turn = sinCosPi(2.0 * (turns - roundEven(turns))).yx;   // (cos, sin)
    vec2 wave = turn;
    float sum = g.count * (even + squares * (g.count * g.count - 1.0) / 3.0 * (tilted + bent) + 3.28986813 * bending);
    for (float k = 1.0; k < g.count; k += 1.0) {
        if (k > furthest) break;
        float ofStep = k * turns * step_;
        // The sum over the pairs' middles j of cos(2 pi j k chirp), of j sin(2 pi j k chirp) and of 4 j^2 cos(2 pi j k chirp).
        float pairs = g.count - k;
        float t = k * chirp - roundEven(k * chirp);
        bool isOdd = (int(roundEven(k * chirp)) * int(pairs - 1.0) & 1) != 0;
        float cosines = pairs * sincOf(pairs * t) / sincOf(t);
        float sines = 0.52359878 * pairs * (pairs * pairs - 1.0) * t;
        float wides = cosines * (pairs * pairs - 1.0) / 3.0;
        if (abs(pairs * t) > 0.05) {
            vec2 sc = sinCosPi(t);
            sines = -0.5 * (pairs * sinCosPi(pairs * t).y - cosines * sc.y) / sc.x;
            wides = cosines * (pairs * pairs - 1.0) - 4.0 * sines * sc.y / sc.x;
        }
        float share = (even + squares * k * k * (bent - tilted)) * cosines + squares * wides * (tilted + bent);
        vec3 window = sincAndSlopes(k * period * blur);
        float harmonic = (share * wave.x - leaning * sines * wave.y) * window.x +
                         cosines * (rising * window.y * wave.y - bending * window.z * wave.x);
        if (isOdd) harmonic = -harmonic;
        sum += 2.0 * harmonic / slitFactor(ofStep);
        wave = vec2(wave.x * turn.x - wave.y * turn.y, wave.x * turn.y + wave.y * turn.x);
    }
    return max(sum, 0.0) / (g.count * g.count);
}

// Change of u per metre across the slits: 0 in the focus.
float curvatureAcross(SlitGrating g, GratingView v) {
    return v.conical * v.z * v.z / (v.rho * v.rho * v.rho) * (1.0 - g.convergence * v.range);
}

// What a continuous spectrum makes, per unit of u and of the power: a list of waves (src/compile/wave_tables.hpp).
vec3 pairColor(SlitGrating g, GratingView v, uint reflectance, float u, float blur) {
    float curvature = curvatureAcross(g, v);
    float step_um = (LAST_WAVE_um - FIRST_WAVE_um) / float(g.entries - 1u);
    // Ways so unlike that white light has no fringes left: half a turn from one of the shortest waves to the next. The same for
    // all waves, for a spectrum that ends in its middle has fringes of its own.
    float furthest = 0.5 * FIRST_WAVE_um * FIRST_WAVE_um / (step_um * g.period_um * max(abs(u), 1e-9));
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < decided(g.entries); ++i) {
        vec4 wave = uintBitsToFloat(responseEntry(g.response + i));
        vec3 color = uintBitsToFloat(responseEntry(g.response + (reflectance + 1u) * g.entries + i).xyz);
        float wavelength_um = g.period_um / wave.x;
        float step_ = step_um / wavelength_um;
        float value = pairPattern(g, u, curvature, wave.x, wave.z, step_, furthest, blur);
        sum += value * footprintAlong(g, v, 1e-6 * wavelength_um, -step_) * throughputAt(wavelength_um) * color;
    }
    return sum;
}
