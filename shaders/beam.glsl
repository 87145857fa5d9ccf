// How the beam of a grating of slits lands at any distance: its geometric image with Fresnel's edges, from near the grating to
// its focus (docs/theory.md, "Slits").

// A point as a grating sees it.
struct GratingView {
    float x, y, z;       // offset in the grating's frame
    float conical;       // sqrt(1 - betaIn^2)
    float rho;           // distance from the slit
    float range;         // distance along the light's way
    float footY;         // where on the slits the light comes from
    vec2 smear;          // over so much across and along the slits the sample averages: the source's size and the pixel's
};

GratingView viewFrom(SlitGrating g, vec3 offset) {
    GratingView v;
    v.x = dot(offset, g.across);
    v.y = dot(offset, g.along);
    v.z = dot(offset, g.normal);
    v.conical = sqrt(1.0 - g.betaIn * g.betaIn);
    v.rho = sqrt(v.x * v.x + v.z * v.z);
    v.range = v.rho / v.conical;
    v.footY = v.y - v.range * g.betaIn;
    v.smear = vec2(0.0);
    return v;
}

// Beyond this many Fresnel widths an edge's ripple is less than 1e-3 in white light, and its spill less than 1e-4.
const float EDGE_REACH = 16.0;
const float SPILL_REACH = 20.0;
const float LONGEST_WAVE = 0.78e-6;
const float MIDDLE_WAVE = 0.55e-6;

const float MOST_STRIPS = 384.0;    // for one wavelength: enough up to this Fresnel number
const float LARGEST_FRESNEL_NUMBER = 40.0;

// Fresnel's unit of length at the beam's edge, along the slits.
float fresnelWidth(SlitGrating g, GratingView v, float wavelength) {
    return sqrt(0.5 * wavelength * v.range) / v.conical;
}

// How far from its axis the beam reaches along the slits at the point's distance, without diffraction.
float beamEdge(SlitGrating g, GratingView v) {
    float scale = abs(1.0 - g.convergence * v.range);
    return g.halfHeight * (g.profile == GAUSSIAN_BEAM ? 2.2 : 1.0) * scale + 0.5 * g.angularSize * v.range;
}

// The extent of what is averaged over, in widths of the ripple of an edge, or of the main lobe of a narrower opening.
float ripplesIn(float smear, float curvature, float half_, float wavelength) {
    return smear / max(sqrt(wavelength / curvature), 0.5 * wavelength / (half_ * curvature));
}

// Whether that hides the ripple: 0 not at all, 1 wholly.
float hiding(float ripples) {
    return smoothstep(1.0, 2.0, ripples);
}

// The beam's intensity where it lands, relative to where it left, in one of its two dimensions: `offset` from the axis as
// traced back to the grating, `curvature` of the phase per length that straight travel gives (1 / distance where it is
// perpendicular), `half` the extent at the grating, `bandwidth` as in fading(). Tends to 1 inside the geometric image
// of an even beam.
float footprint(SlitGrating g, uint profile, float offset, float curvature, float half_, float wavelength, float bandwidth,
                float smear) {
    float focused = curvature - g.convergence;             // 0 in the focus, where the far field is
    if (HAS_GAUSSIAN_BEAMS != 0u && profile == GAUSSIAN_BEAM) {
        float image = half_ * focused / curvature;
        float spread = wavelength / (3.14159265 * half_ * curvature);
        float square = image * image + spread * spread + smear * smear / 3.0;
        return half_ * inversesqrt(square) * exp(-2.0 * offset * offset / square);
    }
    // The share of a window that the geometric image covers.
    float magnified = abs(1.0 - g.convergence * (1.0 / curvature));   // so written, 1 for a collimated beam before anything is computed
    float image = max(half_ * magnified, 1e-9);
    float window = max(smear, 1e-9);
    float covered = min(abs(offset) + 0.5 * window, image) - max(abs(offset) - 0.5 * window, -image);
    float value = max(covered, 0.0) / window * (half_ / image);

    if (HAS_RIPPLES == 0u) return value;
    float ripples = ripplesIn(smear, curvature, half_, wavelength);
    float hidden = hiding(ripples);
    float samples = hidden < 1.0 ? max(ceil(6.0 * ripples - 0.5), 1.0) : 0.0;
    float sum = 0.0;
    for (float i = 0.5; i < samples; i += 1.0) {
        float direction = (offset + (i / samples - 0.5) * smear) * curvature;
        float bare;
        if (abs(focused) * half_ * half_ < 5e-3 * wavelength) {   // the quotient below loses digits
            bare = curvature * 4.0 * half_ * half_ / wavelength * slitFactor(2.0 * half_ * direction / wavelength);
        } else {
            float scale = sqrt(2.0 * abs(focused) / wavelength);
            float center = direction / focused;
            bare = curvature / abs(focused) * stripIntensity(scale * (-half_ - center), scale * (half_ - center), bandwidth);
        }
        sum += bare / samples;
    }
    return mix(sum, value, hidden);
}

// The same in both dimensions for the part of an even disc that meets the slits: strip by strip along the slits, each with
// closed ends, at the nodes y = radius sin(theta) that make the sum converge geometrically once they resolve the phase.
float discFootprint(SlitGrating g, vec2 offset, vec2 curvature, float wavelength, float bandwidth, vec2 smear) {
    vec2 focused = curvature - g.convergence;
    vec2 direction = offset * curvature;
    if (focused.x < 0.0) {                                 // the conjugate has the same intensity
        focused = -focused;
        direction = -direction;
    }
    float radius = g.halfWidth;
    vec2 image = max(radius * abs(focused) / curvature, 1e-9);
    float hidden = hiding(ripplesIn(max(smear.x, smear.y), curvature.y, radius, wavelength));
    float soft = min(image.x, image.y) / max(max(smear.x, smear.y), 1e-9);
    float value = clamp(0.5 + (1.0 - length(offset / image)) * soft, 0.0, 1.0) * radius * radius / (image.x * image.y);
    for (bool once = radius * radius * max(focused.x, abs(focused.y)) > LARGEST_FRESNEL_NUMBER * wavelength && hidden < 1.0;
         once; once = false) {
        // The rim of a large disc is a straight edge across the radius.
        float away = max(length(offset), 1e-6 * radius);
        vec2 share = offset * offset / (away * away);
        value = footprint(g, RECTANGULAR_BEAM, away, dot(share, curvature), radius, wavelength, bandwidth,
                          max(smear.x, smear.y));
        hidden = 1.0;
    }
    if (g.halfSlits < radius && abs(offset.x) > image.x * g.halfSlits / radius) value = 0.0;
    bool inFocus = focused.x * radius * radius < 1e-3 * wavelength;
    float scale = sqrt(2.0 * focused.x / wavelength);
    float center = direction.x / max(focused.x, 1e-9);
    vec2 turns = radius * (0.5 * radius * abs(focused) + abs(direction)) / wavelength;
    float nodes = hidden < 1.0 ? min(ceil(12.0 + 3.2 * (turns.x + turns.y)), MOST_STRIPS) : 0.0;
    vec2 sum = vec2(0.0);
    for (float i = 0.5; i < nodes; i += 1.0) {
        vec2 sineCosine = sinCosPi(i / nodes - 0.5);
        float y = radius * sineCosine.x;
        float half_ = min(radius * sineCosine.y, g.halfSlits);
        vec2 wave = sinCosPi(y * (focused.y * y - 2.0 * direction.y) / wavelength);   // (sin, cos)
        vec2 across;
        if (inFocus) {
            across = vec2(2.0 * half_ * sincOf(2.0 * half_ * direction.x / wavelength), 0.0);
        } else {
            across = stripAmplitude(scale * (-half_ - center), scale * (half_ - center)) / scale;
        }
        sum += sineCosine.y * vec2(across.x * wave.y - across.y * wave.x, across.x * wave.x + across.y * wave.y);
    }
    sum *= 3.14159265 * radius / max(nodes, 1.0);
    return mix(dot(sum, sum) * curvature.x * curvature.y / (wavelength * wavelength), value, hidden);
}

// Whether a disc-shaped beam ends at so different heights for the slits in it that no common edge diffracts, or that the
// slits are of unlike length.
bool hasRoundEdge(SlitGrating g, float curvature) {
    if (g.profile != FLAT_BEAM) return false;
    float lit = min(g.halfSlits, g.halfWidth);
    float sag = g.halfHeight - sqrt(g.halfWidth * g.halfWidth - lit * lit);
    return sag > 2e-3 * g.halfHeight || sag * sag * curvature > LONGEST_WAVE;
}

// Along the slits.
float footprintAlong(SlitGrating g, GratingView v, float wavelength, float bandwidth) {
    float curvature = v.conical * v.conical / v.range;
    return footprint(g, g.profile, v.footY, curvature, g.halfHeight, wavelength, bandwidth, v.smear.y);
}
