// The original algorithm, as printed: A. J. Watson, "Diffraction Gratings in Ray Tracing", MSc thesis, UC San Diego
// 2009, section "Code". What is wrong with it is set out in docs/thesis-algorithm.md; nothing is mended here except
// that 0/0 is its limit, or a flag where the scene asks for the faults as printed.

// 1 / wavelength for red, green and blue as the listing has them: 450, 550 and 700 nm.
const vec3 PRINTED_WAVENUMBER_per_um = vec3(1.0 / 0.450, 1.0 / 0.550, 1.0 / 0.700);

// Intensity for a deviation of sine `sinTheta`, each channel clamped at 1.
vec3 thesisIntensity(float sinTheta, ThesisAperture aperture) {
    vec3 intensity;
    for (int channel = 0; channel < 3; ++channel) {
        float perTurn = sinTheta * PRINTED_WAVENUMBER_per_um[channel];
        float value = slitFactor(perTurn * aperture.width_um);
        if (decided(aperture.count) > 1u) value *= arrayFactor(perTurn * aperture.period_um, float(aperture.count));
        intensity[channel] = min(value, 1.0);
    }
    return intensity;
}

// Sine of the angle between the normal and the direction with cosines `across` (to the slits) and `along` (the
// normal), both >= 0: the listing's sqrt(1 - dot(theta, n)^2).
float sinFromNormal(float across, float along) {
    return across * inversesqrt(across * across + along * along);
}

// The same, computed as the listing does it. In single precision dot(theta, n) rounds to 1 (then sine and phase are
// 0 and the intensity 0/0) or above (then the root is of a negative number) for angles below about 0.02 degrees.
float sinFromNormalAsPrinted(float across, float along, vec3 x, vec3 normal, out bool nonFinite) {
    precise vec3 theta = across * x + along * normal;
    theta /= length(theta);
    precise float cosine = dot(theta, normal) / (length(theta) * length(normal));
    precise float square = 1.0 - cosine * cosine;
    nonFinite = !(square > 0.0);
    return nonFinite ? 0.0 : sqrt(square);
}

// Whether a point lies on the grating's outgoing side and in the band that the beam's diameter cuts out.
bool reachesBand(ThesisGrating grating, vec3 position) {
    vec3 offset = position - grating.position;
    return dot(offset, grating.normal) > 0.0 && abs(dot(offset, grating.slitDirection)) <= grating.radius;
}

// What a grating adds to the picture at a point of its band, `offset` from it: no BRDF, no cosine, no fall-off.
vec3 thesisGratingValue(ThesisGrating grating, vec3 offset, inout bool nonFinite) {
    float along = dot(offset, grating.normal);
    float height = dot(offset, grating.slitDirection);   // the listing's splinedistance
    float across = abs(dot(offset, grating.across));
    float sinTheta;
    if (HAS_PRINTED_FAULTS != 0u && decided(grating.aperture.asPrinted) != 0u) {
        float perLength = inversesqrt(dot(offset, offset));
        sinTheta = sinFromNormalAsPrinted(across * perLength, along * perLength, grating.across, grating.normal, nonFinite);
    } else {
        sinTheta = sinFromNormal(across, along);
    }
    float ratio = 1.0 - height * height * grating.attenuation;
    return ratio * grating.color * thesisIntensity(sinTheta, grating.aperture);
}

// The CD of the thesis at `local`, the hit point relative to the disc's centre, seen along `view`.
vec3 thesisDiscValue(ThesisAperture aperture, vec3 local, vec3 normal, vec3 view, inout bool nonFinite) {
    vec3 radial = local - normal * dot(local, normal);
    float squared = dot(radial, radial);
    if (squared == 0.0) return vec3(1.0);                  // the very centre of a disc without a hole: the limit
    vec3 x = radial * inversesqrt(squared);
    float across = abs(dot(view, x));
    float along = abs(dot(view, normal));
    float sinTheta;
    if (HAS_PRINTED_FAULTS != 0u && decided(aperture.asPrinted) != 0u) {
        sinTheta = sinFromNormalAsPrinted(across, along, x, normal, nonFinite);
    } else {
        sinTheta = sinFromNormal(across, along);
    }
    return thesisIntensity(sinTheta, aperture);
}
