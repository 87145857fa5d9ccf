// Colour: spectra of lights times reflectances, integrated on the host against the colour-matching functions
// (src/compile/spectral.hpp). Light that passed a metal is followed in bands.

// Throughput of the path that is followed, at the bands' middles. While nothing on the way had a colour of its own, the first
// number stands for all: what is seen directly in a scene with a metal needs no loop over bands. A variable of its own and
// no parameter, as every function that is called would get a copy of it.
struct Throughput {
    float band[BANDS];
    uint bands;          // 0: one number for all; else BANDS
};
Throughput throughput;

float inBand(uint band) { return throughput.band[throughput.bands > 0u ? band : 0u]; }

// Where the colours of a spectrum off a reflectance are: of the whole, and then, where paths may have bands, of each.
uint colorsOf(uint spectrum, uint reflectance) {
    return (spectrum * scene.frame.reflectanceCount + reflectance) * (BANDS > 1u ? BANDS + 1u : 1u) * 3u;
}
vec3 bandColor(uint colors, uint band) { return tableColor(colors + 3u * (BANDS > 1u ? band + 1u : band)); }

// The light of a spectrum, one unit of it, off a surface of reflectance row `reflectance`, after the path: XYZ.
vec3 seen(uint spectrum, uint reflectance) {
    uint colors = colorsOf(spectrum, reflectance);
    if (BANDS == 1u) return throughput.band[0] * tableColor(colors);
    vec3 sum = throughput.bands == 0u ? throughput.band[0] * tableColor(colors) : vec3(0.0);
    [[dont_unroll]] for (uint k = 0u; k < throughput.bands; ++k) sum += throughput.band[k] * bandColor(colors, k);
    return sum;
}

void scaleThroughput(float factor) {
    throughput.band[0] *= factor;
    if (BANDS == 1u) return;
    [[dont_unroll]] for (uint k = 1u; k < throughput.bands; ++k) throughput.band[k] *= factor;
}

float largestThroughput() {
    float value = throughput.band[0];
    if (BANDS == 1u) return value;
    [[dont_unroll]] for (uint k = 1u; k < throughput.bands; ++k) value = max(value, throughput.band[k]);
    return value;
}

float bandMiddle_um(uint band) {
    return FIRST_BAND_um + LOW_STEP_um * float(min(band, LOW_STEPS)) +
           MIDDLE_STEP_um * float(clamp(band, LOW_STEPS, LOW_STEPS + MIDDLE_STEPS) - LOW_STEPS) +
           HIGH_STEP_um * float(max(band, LOW_STEPS + MIDDLE_STEPS) - LOW_STEPS - MIDDLE_STEPS);
}

// How many bands' middles a wavelength lies behind the first one: from 0 to a little less than that of the last.
float bandPlace(float wavelength_um) {
    float low = (wavelength_um - FIRST_BAND_um) / LOW_STEP_um;
    float middle = (wavelength_um - FIRST_BAND_um - LOW_STEP_um * float(LOW_STEPS)) / MIDDLE_STEP_um;
    float high = (middle - float(MIDDLE_STEPS)) * (MIDDLE_STEP_um / HIGH_STEP_um);
    return min(clamp(low, 0.0, float(LOW_STEPS)) + clamp(middle, 0.0, float(MIDDLE_STEPS)) + max(high, 0.0),
               float(SPECTRAL_BANDS) - 1.00001);
}

// At one wavelength: linear between the bands' middles.
float throughputAt(float wavelength_um) {
    if (BANDS == 1u) return throughput.band[0];
    float place = bandPlace(wavelength_um);
    uint k = uint(place);
    return mix(inBand(k), inBand(k + 1u), place - float(k));
}

// For values that are linear sRGB by definition (thesis): each channel at its primary's dominant wavelength.
vec3 throughputOfPrimaries() {
    if (BANDS == 1u) return vec3(throughput.band[0]);
    return vec3(throughputAt(0.6114), throughputAt(0.5491), throughputAt(0.4642));
}

// IEC 61966-2-1, primaries of Rec. 709; white is D65 as the film has it (optics::xyzFromLinearSrgb, 380 to 780 nm).
vec3 xyzFromLinearSrgb(vec3 rgb) {
    return vec3(dot(rgb, vec3(0.412440142, 0.357589801, 0.180389874)),
                dot(rgb, vec3(0.212664448, 0.715179602, 0.0721559498)),
                dot(rgb, vec3(0.0193331316, 0.1191966, 0.950053339)));
}
