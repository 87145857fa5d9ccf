// The colour that slits send in a direction: CIE XYZ per unit of u, the change of the direction cosine across the slits, as
// the mean over a window of u. There are several ways to it, each with its own time, memory and error; the host chooses one for
// each grating (src/compile/evaluators.hpp; docs/theory.md, "Evaluators"), and what a scene does not use is compiled out.

// The running integral of a response at a place between two entries: what the first one holds, and what comes on top, in
// the table's own unit of it.
struct ResponseIntegral {
    uvec3 whole;
    vec3 rest;
};

// At `offset` entries from the one that is `base` away from the first. Exact for a response that is linear between its
// entries. `slopeUnit` in units of the integral.
ResponseIntegral responseIntegral(uint table, uint entries, float slopeUnit, int base, float offset) {
    float whole = floor(offset);
    int wanted = base + int(whole);
    int i = clamp(wanted, 0, int(entries) - 2);
    float f = i == wanted ? offset - whole : i < wanted ? 1.0 : 0.0;
    uvec4 entry = responseEntry(table + uint(i));
    uvec3 step_ = responseEntry(table + uint(i) + 1u).xyz - entry.xyz;
    vec3 slopes = vec3((ivec3(entry.w) << ivec3(23, 14, 5)) >> 23);
    float scale = slopeUnit * uintBitsToFloat(((entry.w >> 27) + 127u) << 23);
    return ResponseIntegral(entry.xyz, f * vec3(ivec3(step_)) - (0.5 * f * (1.0 - f) * scale) * slopes);
}

// Mean of a response over a window of its argument, of a step of the table at least; `table` is one band's. The window's
// ends are counted from the entry next to its middle: among ten thousand entries a float knows a place to a thousandth of a
// step, and a window of four steps would be wrong by as much.
vec3 meanResponse(SlitGrating g, uint table, float u, float width) {
    float place = u * g.perU;
    float nearest = floor(place);
    int base = int(nearest) + int(g.zeroEntry);
    float steps = max(width * g.perU, 1.0);
    ResponseIntegral from = responseIntegral(table, g.entries, g.slopeUnit, base, (place - nearest) - 0.5 * steps);
    ResponseIntegral to = responseIntegral(table, g.entries, g.slopeUnit, base, (place - nearest) + 0.5 * steps);
    return (vec3(to.whole - from.whole) + (to.rest - from.rest)) * (g.integralUnit / steps);
}

// ---- order expansion ------------------------------------------------------------------------------------------------

// The undeviated light of wide slits is followed apart as far as this (undeviated() in slits.glsl), and left out here.
float lastLobe(SlitGrating g) {
    return ZERO_ORDER_LOBES * LAST_WAVE_um / ((g.count - 1.0) * g.period_um + g.width_um);
}

// Many slits send each wavelength into its orders alone: order m has at u the wavelength period u/m and takes the share
// (width/period) sinc^2(m width/period) of the power that leaves. One table over wavelength serves all orders, however many
// slits there are. Of the undeviated order there are the side lobes further out, as their mean: half of
// (wavelength/(pi count period u))^2. What they are to be multiplied by, the integral of the density times the wavelength,
// follows the table.
vec3 meanOfOrders(SlitGrating g, uint table, float u, float width) {
    float low = max(abs(u) - 0.5 * width, 0.0), high = abs(u) + 0.5 * width;
    float first = max(floor(low * g.period_um / LAST_WAVE_um), 1.0);
    float last = ceil(high * g.period_um / FIRST_WAVE_um);
    float fill = g.width_um / g.period_um;
    vec3 sum = vec3(0.0);
    for (float order = first; order <= last; order += 1.0) {
        float perOrder = g.period_um / order;
        float share = fill * slitFactor(order * fill) * perOrder;
        sum += share * meanResponse(g, table, perOrder * abs(u), perOrder * width);
        // A window about the middle takes in the orders of both sides.
        if (low == 0.0) sum += share * meanResponse(g, table, -perOrder * abs(u), perOrder * width);
    }
    if (low > lastLobe(g)) {
        const float MIDDLE_WAVE_um = 0.55;
        float lobes = fill / (19.7392088 * g.count * g.period_um * low * high) * slitFactor(g.width_um * u / MIDDLE_WAVE_um);
        sum += lobes * uintBitsToFloat(responseEntry(table + g.entries).xyz);
    }
    return sum;
}

// ---- sums over wavelengths ------------------------------------------------------------------------------------------

// The pattern of all slits in one wavelength relative to its peak, by phases in turns (phase.glsl). `period`, as two
// floats, and `width` in wavelengths.
float stablePattern(SlitGrating g, float u, vec2 period, float width, bool withZeroOrder) {
    vec2 past = turnsPastOrder(u, period);
    float value = slitFactor(width * u) * fejer(past, g.count);
    if (!withZeroOrder) {
        // Order 0 is sinc^2(count t): the array factor times (sin(pi t)/(pi t))^2.
        value *= 1.0 - slitFactor(u * period.x);
    }
    return value;
}

// Whether a formula of the scene's choice was 0/0 at this invocation's sample.
bool metNonFinite = false;

// The same as the thesis prints it: phases in radians, the driver's own sine, 0/0 at every order.
float printedPattern(SlitGrating g, float u, float period, float width, bool withZeroOrder) {
    float delta = 3.14159265 * width * u, xi = 3.14159265 * period * u;
    float ofSlit = sin(delta), ofSlits = sin(xi);
    if (delta == 0.0 || ofSlits == 0.0) {
        metNonFinite = true;
        return 0.0;
    }
    float single = ofSlit / delta, many = sin(g.count * xi) / (g.count * ofSlits);
    float value = single * single * many * many;
    if (!withZeroOrder) value *= 1.0 - ofSlits * ofSlits / (xi * xi);
    return value;
}

// u by the small-angle approximation: the offset over the distance from the grating's plane stands for the sine.
float smallAngle(SlitGrating g, float u) {
    float sine = u + g.alphaIn;
    float cosine2 = max(1.0 - sine * sine / (1.0 - g.betaIn * g.betaIn), 1e-6);
    return sine * inversesqrt(cosine2) - g.alphaIn;
}

// Mean over a window by Gauss's rule of two points, six to a fringe but no more than `most`; what is a small part of a fringe
// is its middle.
float meanPattern(SlitGrating g, float u, float width, vec2 period, float slit, bool withZeroOrder, float most) {
    bool isSmallAngle = HAS_SMALL_ANGLE_EVALUATOR != 0u && decided(g.evaluator) == SMALL_ANGLE_EVALUATOR;
    bool isNaive = HAS_NAIVE_EVALUATOR != 0u && decided(g.evaluator) == NAIVE_EVALUATOR;
    float fringes = width * g.count * period.x;
    float samples = fringes < 0.02 ? 1.0 : min(2.0 * ceil(3.0 * fringes), most);
    float sum = 0.0;
    for (float i = 0.0; i < samples; i += 1.0) {
        float node = samples == 1.0 ? 0.5 : 2.0 * floor(0.5 * i) + (i - 2.0 * floor(0.5 * i) == 0.0 ? 0.422649731 : 1.577350269);
        float at = u + (node / samples - 0.5) * width;
        if (isSmallAngle) at = smallAngle(g, at);
        if (isNaive) sum += printedPattern(g, at, period.x, slit, withZeroOrder);
        else sum += stablePattern(g, at, period, slit, withZeroOrder);
    }
    return sum / samples;
}

// What one line sends out per unit of u and of its power. More than sixty-four points are not needed for the mean of many
// fringes.
float lineDensity(SlitGrating g, float u, float width, float wavelength_um) {
    // The quotient and what its rounding leaves out.
    precise float period = g.period_um / wavelength_um;
    precise float product = period * wavelength_um;
    precise float rest = (g.period_um - product) - productError(period, wavelength_um, product);
    float slit = g.width_um / wavelength_um;
    return slit * g.count * meanPattern(g, u, width, vec2(period, rest / wavelength_um), slit, true, 64.0);
}

// Wave i of a list of `g.entries` even steps over the visible range: period (two floats) and width of the slits in its
// wavelength, and how many bands' middles it lies behind the first. The colours for each reflectance follow the list.
vec3 meanOfWaves(SlitGrating g, uint reflectance, bool isBand, uint band, float u, float width) {
    uint from = 0u, to = decided(g.entries);
    if (isBand) {
        // Only waves between the neighbouring bands' middles belong to a band.
        float perWave = float(g.entries - 1u) / (LAST_WAVE_um - FIRST_WAVE_um);
        if (band > 0u) from = uint(max(floor((bandMiddle_um(band - 1u) - FIRST_WAVE_um) * perWave), 0.0));
        if (band + 1u < SPECTRAL_BANDS) to = min(to, uint(ceil((bandMiddle_um(band + 1u) - FIRST_WAVE_um) * perWave)) + 1u);
    }
    // Thousands of waves and points together would exceed the turns that lavapipe lets a loop take.
    const float MOST_POINTS = 16.0;
    bool withZeroOrder = decided(g.isWide) == 0u || abs(u) > lastLobe(g);
    vec3 sum = vec3(0.0);
    for (uint i = from; i < to; ++i) {
        vec4 wave = uintBitsToFloat(responseEntry(g.response + i));
        vec3 color = uintBitsToFloat(responseEntry(g.response + (reflectance + 1u) * g.entries + i).xyz);
        float weight = isBand ? max(1.0 - abs(wave.w - float(band)), 0.0) : 1.0;
        sum += (weight * meanPattern(g, u, width, wave.xy, wave.z, withZeroOrder, MOST_POINTS)) * color;
    }
    return sum;
}

// ---- any of them ----------------------------------------------------------------------------------------------------

// A scene whose gratings all have the same evaluator need not ask for it.
bool isChosen(uint others, bool isIts) { return others == 0u || isIts; }

// `row`: 0 for the whole spectrum, band + 1 for one band, if the scene's responses have bands.
vec3 slitColor(SlitGrating g, uint reflectance, uint row, float u, float width) {
    uint place = HAS_BAND_RESPONSES != 0u ? reflectance * (SPECTRAL_BANDS + 1u) + row : reflectance;
    if (HAS_DIRECT_EVALUATOR != 0u &&
        isChosen(HAS_TABLE_EVALUATOR + HAS_ORDERS_EVALUATOR, decided(g.evaluator) >= DIRECT_EVALUATOR)) {
        return meanOfWaves(g, reflectance, row > 0u, max(row, 1u) - 1u, u, width);
    }
    if (HAS_ORDERS_EVALUATOR != 0u && isChosen(HAS_TABLE_EVALUATOR, decided(g.evaluator) == ORDERS_EVALUATOR)) {
        return meanOfOrders(g, g.response + place * (g.entries + 1u), u, width);
    }
    if (HAS_TABLE_EVALUATOR != 0u) return meanResponse(g, g.response + place * g.entries, u, width);
    return vec3(0.0);
}
