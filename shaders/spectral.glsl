// Colour: spectra of lights times reflectances, integrated on the host against the colour-matching functions
// (src/compile/spectral.hpp). Light that passed a metal is followed in bands.

// Throughput of a path at the band's middles; one number where nothing on the way has a colour of its own.
struct Throughput {
    float band[BANDS];
};

// The light of a spectrum, one unit of it, off a surface of reflectance row `reflectance`, after the path: XYZ.
vec3 seen(Throughput throughput, uint spectrum, uint reflectance) {
    uint first = (spectrum * scene.frame.reflectanceCount + reflectance) * BANDS * 3u;
    vec3 sum = vec3(0.0);
    [[dont_unroll]] for (uint k = 0u; k < BANDS; ++k) sum += throughput.band[k] * tableColor(first + 3u * k);
    return sum;
}

Throughput scaled(Throughput throughput, float factor) {
    [[dont_unroll]] for (uint k = 0u; k < BANDS; ++k) throughput.band[k] *= factor;
    return throughput;
}

float largest(Throughput throughput) {
    float value = throughput.band[0];
    [[dont_unroll]] for (uint k = 1u; k < BANDS; ++k) value = max(value, throughput.band[k]);
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
float throughputAt(Throughput throughput, float wavelength_um) {
    if (BANDS == 1u) return throughput.band[0];
    float place = bandPlace(wavelength_um);
    uint k = uint(place);
    return mix(throughput.band[k], throughput.band[k + 1u], place - float(k));
}

// For values that are linear sRGB by definition (thesis): each channel at its primary's dominant wavelength.
vec3 throughputOfPrimaries(Throughput throughput) {
    if (BANDS == 1u) return vec3(throughput.band[0]);
    return vec3(throughputAt(throughput, 0.6114), throughputAt(throughput, 0.5491), throughputAt(throughput, 0.4642));
}

// IEC 61966-2-1, primaries of Rec. 709; white is D65 as the film has it (optics::xyzFromLinearSrgb, 380 to 780 nm).
vec3 xyzFromLinearSrgb(vec3 rgb) {
    return vec3(dot(rgb, vec3(0.412440142, 0.357589801, 0.180389874)),
                dot(rgb, vec3(0.212664448, 0.715179602, 0.0721559498)),
                dot(rgb, vec3(0.0193331316, 0.1191966, 0.950053339)));
}
