// Light from slits in a beam, at any distance where the far field of a single slit holds (docs/theory.md, "Slits").
// Across the slits the beam spreads by their diffraction, along them it stays the beam, with Fresnel's edges.
// What a continuous spectrum makes is evaluators.glsl's; the lines of a spectrum are followed one by one.

const float ROUND_PIECES = 24.0;    // that a disc-shaped beam is cut into for a continuous spectrum
const float GAUSSIAN_PIECES = 8.0;  // likewise a Gaussian beam across wide slits

// On the grating's outgoing side and within the beam along the slits: nothing else of it gets there.
bool reachesSlits(SlitGrating g, vec3 position) {
    vec3 offset = position - g.position;
    if (dot(offset, g.normal) <= 0.0) return false;
    GratingView v = viewFrom(g, offset);
    float beyond = abs(v.footY) - beamEdge(g, v);
    // beyond <= SPILL_REACH fresnelWidth(), squared twice: without a root where a beam neither slants nor spreads.
    const float SPILL = 0.5 * SPILL_REACH * SPILL_REACH * LONGEST_WAVE;
    float square = beyond * beyond, conical2 = v.conical * v.conical;
    return beyond <= 0.0 || square * square * (conical2 * conical2 * conical2) <= SPILL * SPILL * (v.x * v.x + v.z * v.z);
}

// Half of the width across the slits that is lit.
float halfLit(SlitGrating g) {
    return min(g.halfSlits, g.profile == GAUSSIAN_BEAM ? 2.2 * g.halfWidth : g.halfWidth);   // exp(-2 2.2^2) = 6e-5
}

// The wavelength of the order nearest to the visible range's middle.
float nearestWave(SlitGrating g, GratingView v) {
    float waves = abs(v.conical * v.x / v.rho - g.alphaIn) * g.period_um / (1e6 * MIDDLE_WAVE);
    return clamp(MIDDLE_WAVE * waves / max(roundEven(waves), 1.0), 0.4e-6, 0.7e-6);
}

// Wavelength and bandwidth, as footprint() takes them, of one band's light: where orders are narrower than the band it is
// their wavelength that counts.
vec2 waveInBand(SlitGrating g, float u, uint band) {
    float wavelength_um = bandMiddle_um(band);
    float step_um = bandMiddle_um(band + 1u) - wavelength_um;
    float order = roundEven(abs(u) * g.period_um / wavelength_um);
    float line_um = abs(u) * g.period_um / max(order, 1.0);
    float width_um = line_um / (max(order, 1.0) * g.count);
    bool isLine = order > 0.0 && width_um < step_um && abs(line_um - wavelength_um) < step_um;
    float center_um = isLine ? line_um : wavelength_um;
    return vec2(center_um * 1e-6, (isLine ? width_um : -step_um) / center_um);
}

// How the beam lands along the slits.
struct Landing {
    uint profile;
    float halfHeight;
    vec2 wave;           // wavelength and bandwidth that stand for all
    bool rippled;        // each band has its own instead
    bool inside;         // far from the edges: it lands as it left
};

// What the slits between `left` and `right` of the middle send to a point: for each band, or for the sum of all, the mean
// response over the window of sines that they fill, times the beam's footprint there.
vec3 fromSlitsBetween(SlitGrating g, GratingView v, float left, float right, uint reflectance,
                      Landing landing, float blur, float facing) {
    // Sine of the direction from either end; their difference without cancellation.
    float x1 = v.x - right, x2 = v.x - left;
    float distance1 = sqrt(x1 * x1 + v.z * v.z), distance2 = sqrt(x2 * x2 + v.z * v.z);
    float both = 1.0 / (distance1 * distance2);
    float sine = (right - left) * v.z * both;
    float cosine = (x1 * x2 + v.z * v.z) * both;
    float perDepth = (distance1 + distance2) * both * sine / (1.0 + cosine);
    float window = v.conical * v.z * perDepth;
    float u = 0.5 * v.conical * (x1 * distance2 + x2 * distance1) * both - g.alphaIn;
    float power = g.irradiance * perDepth * facing * v.rho;

    float focused = window * abs(1.0 - g.convergence * v.range);
    float width = sqrt(focused * focused + blur * blur);
    float curvature = v.conical * v.conical / v.range;
    if (BANDS == 1u && HAS_RIPPLES == 0u) {                // no loop, not even of one turn
        float landed = landing.inside ? 1.0 : footprint(g, landing.profile, v.footY, curvature, landing.halfHeight,
                                                        landing.wave.x, landing.wave.y, v.smear.y);
        return (landed * throughput.band[0] * power) * slitColor(g, reflectance, 0u, u, width);
    }
    bool bandwise = (BANDS > 1u && throughput.bands > 0u) || landing.rippled;
    uint bands = bandwise ? SPECTRAL_BANDS : 1u;
    vec3 sum = vec3(0.0);
    [[dont_unroll]] for (uint k = 0u; k < bands; ++k) {
        vec2 wave = HAS_RIPPLES != 0u && landing.rippled ? waveInBand(g, u, k) : landing.wave;
        float landed = footprint(g, landing.profile, v.footY, curvature, landing.halfHeight, wave.x, wave.y, v.smear.y);
        if (landing.inside) landed = 1.0;
        sum += landed * inBand(k) * slitColor(g, reflectance, bandwise ? k + 1u : 0u, u, width);
    }
    return sum * power;
}

// A continuous spectrum: all orders where the slits are narrow, all but the undeviated one where they are wide.
vec3 continuum(SlitGrating g, GratingView v, uint reflectance, float blur, float facing) {
    float curvature = v.conical * v.conical / v.range;
    bool isGaussian = HAS_GAUSSIAN_BEAMS != 0u && g.profile == GAUSSIAN_BEAM;
    bool isRound = HAS_WIDE_GRATINGS != 0u && decided(g.isWide) != 0u && hasRoundEdge(g, curvature);
    float edge = beamEdge(g, v) - abs(v.footY);
    Landing landing;
    landing.profile = g.profile;
    landing.halfHeight = g.halfHeight;
    landing.wave = vec2(MIDDLE_WAVE, 0.2);
    landing.rippled = HAS_RIPPLES != 0u && HAS_BAND_RESPONSES != 0u && !isGaussian && !isRound && abs(edge) < EDGE_REACH * fresnelWidth(g, v, LONGEST_WAVE) &&
                      ripplesIn(v.smear.y, curvature, g.halfHeight, MIDDLE_WAVE) < 0.7;
    landing.inside = !isRound && !landing.rippled && edge > v.smear.y && !isGaussian && g.convergence == 0.0;

    float half_ = halfLit(g);
    float pieces = isRound ? ROUND_PIECES : isGaussian && decided(g.isWide) != 0u ? GAUSSIAN_PIECES : 1.0;
    float last = isRound ? asin(half_ / g.halfWidth) : 1.0;
    float left = -half_;
    vec3 sum = vec3(0.0);
    for (float i = 1.0; i <= pieces; i += 1.0) {
        float right = half_ * (2.0 * i / pieces - 1.0);
        float weight = 1.0;
        if (isRound) {
            // Each slit has its own height. Pieces of even angle are as fine as the chords change fast.
            right = g.halfWidth * sin(last * (2.0 * i / pieces - 1.0));
            float middle = 0.5 * (left + right);
            landing.profile = RECTANGULAR_BEAM;
            landing.halfHeight = sqrt(g.halfWidth * g.halfWidth - middle * middle);
            landing.wave = vec2(nearestWave(g, v), 0.0);
        } else if (isGaussian && pieces > 1.0) {
            float middle = 0.5 * (left + right) / g.halfWidth;
            weight = exp(-2.0 * middle * middle);
        }
        sum += weight * fromSlitsBetween(g, v, left, right, reflectance, landing, blur, facing);
        left = right;
    }
    return sum;
}

// What of an amplitude grating's light each slit sends in the direction of an order, or a little beside it where the light
// spreads further than its image: `footX`, where the light comes from, then lies beyond the slits.
float openShare(SlitGrating g, float order, float footX, float half_, float curvature, float wavelength_um) {
    if (HAS_ORDER_SHARES != 0u && decided(g.orderCount) != 0u) return 1.0;
    float image = half_ * abs(1.0 - g.convergence / curvature);
    float spread = 0.5e-6 * wavelength_um / (half_ * curvature);
    image *= image / (image + spread);                     // far away directions count from the middle
    float beyond = footX - clamp(footX, -image, image);
    return slitFactor(g.width_um * (order / g.period_um + beyond * curvature / wavelength_um));
}

// One wavelength in order `order` of wide slits: an image of the beam along the order's direction.
float orderIrradiance(SlitGrating g, GratingView v, vec3 offset, vec3 normal, float order, float share, float wavelength_um,
                      float bandwidth) {
    float alpha = g.alphaIn + order * wavelength_um / g.period_um;
    float gamma2 = 1.0 - alpha * alpha - g.betaIn * g.betaIn;
    if (gamma2 <= 0.0) return 0.0;                         // evanescent: carries no power
    float gamma = sqrt(gamma2);
    float range = v.z / gamma;
    vec3 direction = alpha * g.across + g.betaIn * g.along + gamma * g.normal;
    float facing = -dot(direction, normal);
    if (facing <= 0.0) return 0.0;
    float footX = v.x - range * alpha;
    float footY = v.y - range * g.betaIn;
    float curvatureX = (1.0 - alpha * alpha) / range;
    float wavelength = wavelength_um * 1e-6;
    float curvatureY = v.conical * v.conical / range;
    float value = share * openShare(g, order, footX, halfLit(g), curvatureX, wavelength_um) * g.irradiance * facing / gamma;
    if (hasRoundEdge(g, curvatureY)) {
        // Far from the disc there is nothing, and no strip need be summed.
        if (max(abs(footX), abs(footY)) > 1.5 * g.halfWidth + SPILL_REACH * sqrt(0.5 * wavelength / curvatureX)) return 0.0;
        return value * discFootprint(g, vec2(footX, footY), vec2(curvatureX, curvatureY), wavelength, bandwidth, v.smear);
    }
    bool isGaussianAcross = g.profile == GAUSSIAN_BEAM && g.halfSlits > g.halfWidth;
    GratingView there = v;
    there.range = range;
    there.footY = footY;
    return value * footprintAlong(g, there, wavelength, bandwidth) *
           footprint(g, isGaussianAcross ? GAUSSIAN_BEAM : RECTANGULAR_BEAM, footX, curvatureX,
                     isGaussianAcross ? g.halfWidth : halfLit(g), wavelength, bandwidth, v.smear.x);
}

// Share of the light on line `line` that the slits send into an order.
float orderShare(SlitGrating g, uint line, float order) {
    float place = order - g.firstOrder;
    if (HAS_ORDER_SHARES == 0u || decided(g.orderCount) == 0u) {
        return g.width_um / g.period_um;                   // times each slit's own pattern, openShare()
    }
    return place >= 0.0 && place < float(g.orderCount) ? tables[g.shares + line * g.orderCount + uint(place)] : 0.0;
}

// The colour of a wavelength followed on its own: record `i` of a list, after the path.
vec3 waveColor(uint record, float wavelength_um) {
    return throughputAt(wavelength_um) * tableColor(record + 1u);
}

// Irradiance for a density of 1 per u, from slits that are all seen under the same sine.
float fromRow(SlitGrating g, GratingView v, float facing) {
    return g.irradiance * 2.0 * g.halfSlits * v.z / (v.rho * v.rho) * facing;
}

vec3 spectralLines(SlitGrating g, GratingView v, vec3 offset, vec3 normal, uint reflectance,
                   float blur, float facing) {
    float u = v.conical * v.x / v.rho - g.alphaIn;
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < g.lineCount; ++i) {
        uint record = g.lines + 4u * (reflectance * g.lineCount + i);
        float wavelength_um = tables[record];
        float value = 0.0;
        if (HAS_WIDE_GRATINGS != 0u && decided(g.linesAreImages) != 0u) {
            float nearest = roundEven(u * g.period_um / wavelength_um);
            float others = g.count < 16.0 ? 3.0 : 1.0;     // the rest is 1/(pi^2 count^2 others) of the peak
            for (float order = nearest - others; order <= nearest + others; order += 1.0) {
                value += orderIrradiance(g, v, offset, normal, order, orderShare(g, i, order), wavelength_um, 0.0);
            }
        } else {
            if (HAS_PAIRS_EVALUATOR != 0u && decided(g.evaluator) == PAIRS_EVALUATOR) {
                float slit = g.width_um / wavelength_um;
                value = slit * g.count * pairPattern(g, u, curvatureAcross(g, v), g.period_um / wavelength_um, slit, 0.0, g.count, blur);
            } else {
                value = lineDensity(g, u, blur, wavelength_um);
            }
            value *= fromRow(g, v, facing) * footprintAlong(g, v, wavelength_um * 1e-6, 0.0);
        }
        sum += value * waveColor(record, wavelength_um);
    }
    return sum;
}

vec3 undeviated(SlitGrating g, GratingView v, vec3 offset, vec3 normal, uint reflectance) {
    vec3 sum = vec3(0.0);
    float gamma = sqrt(1.0 - g.alphaIn * g.alphaIn - g.betaIn * g.betaIn);
    float range = v.z / gamma;
    float footX = v.x - range * g.alphaIn;
    float half_ = halfLit(g);
    float spill = max(SPILL_REACH * sqrt(0.5 * LONGEST_WAVE * range), 0.5 * ZERO_ORDER_LOBES * LONGEST_WAVE * range / half_);
    if (abs(footX) > half_ + spill / (gamma * gamma) + 0.5 * g.angularSize * range) return sum;
    for (uint i = 0u; i < g.zeroOrderCount; ++i) {
        uint record = g.zeroOrder + 4u * (reflectance * g.zeroOrderCount + i);
        float wavelength_um = tables[record];
        sum += orderIrradiance(g, v, offset, normal, 0.0, 1.0, wavelength_um, -ZERO_ORDER_STEP_um / wavelength_um) *
               waveColor(record, wavelength_um);
    }
    return sum;
}

// By how much something with this gradient changes per length on a surface across the line of sight `view`; `slant`: view
// over its cosine with the normal.
float changeOnSurface(vec3 gradient, vec3 normal, vec3 slant) {
    return length(gradient - normal * dot(gradient, slant));
}

// Light reflected towards the eye by a diffuse surface of reflectance row `reflectance`, times pi, XYZ. `normal` is on the
// eye's side; `view` and `pixel`, direction and width of what the sample sees, say over how many fringes to average.
vec3 slitGratingValue(SlitGrating g, vec3 offset, vec3 normal, vec3 view, float pixel, uint reflectance) {
    GratingView v = viewFrom(g, offset);
    float nearness = 1.0 / v.rho;
    vec3 direction = (v.conical * nearness) * (v.x * g.across + v.z * g.normal) + g.betaIn * g.along;
    float facing = -dot(direction, normal);
    vec3 slant = view * (1.0 / dot(normal, view));
    // How fast the sine and the places on the grating that light comes from change across the picture.
    float slope = v.conical * v.z * nearness * nearness * nearness;
    float ofSine = pixel * changeOnSurface(slope * (v.z * g.across - v.x * g.normal), normal, slant);
    float blur = sqrt(ofSine * ofSine + g.angularSize * g.angularSize);
    v.smear = pixel * vec2(changeOnSurface(g.across - (v.x / v.z) * g.normal, normal, slant),
                           changeOnSurface(g.along - (g.betaIn * v.rho / (v.conical * v.z)) * g.normal, normal, slant)) +
              g.angularSize * v.range;
    vec3 sum = vec3(0.0);
    bool byPairs = HAS_PAIRS_EVALUATOR != 0u && decided(g.evaluator) == PAIRS_EVALUATOR;
    if (byPairs && g.entries > 0u && facing > 0.0) {
        float u = v.conical * v.x / v.rho - g.alphaIn;
        sum += fromRow(g, v, facing) * pairColor(g, v, reflectance, u, blur);
    }
    if (HAS_SLIT_CONTINUUM != 0u && !byPairs && g.entries > 0u && facing > 0.0) {
        sum += continuum(g, v, reflectance, blur, facing);
        if (HAS_WIDE_GRATINGS != 0u && decided(g.isWide) != 0u) {
            sum += undeviated(g, v, offset, normal, reflectance);
        }
    }
    if (HAS_SLIT_LINES != 0u) sum += spectralLines(g, v, offset, normal, reflectance, blur, max(facing, 0.0));
    return sum;
}
