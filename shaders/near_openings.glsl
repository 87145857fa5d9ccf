// Rectangles, circles and rings at distances where the phase of their light is still curved across them: Fresnel's integral,
// relative to the peak of the far field, to which all of it tends as the curvature goes to 0 (docs/theory.md, "Openings").

// Below this Fresnel number the far field differs by less than 1e-4, and Fresnel's integral loses digits.
const float LEAST_FRESNEL_NUMBER = 0.005;
const float MOST_RIM_NODES = 160.0;

// A point as an opening sees it in its near field.
struct NearView {
    float curvature;     // 1 / m: of the phase, without its sign, as the conjugate has the same intensity
    vec2 out_;           // direction cosines
    vec2 smear;          // change of these over what the sample averages: its share of a pixel and the source
};

NearView nearView(OpeningGrating g, OpeningView v) {
    NearView near;
    near.curvature = max(abs(v.nearness - g.convergence), 1e-9);
    near.out_ = v.uv + g.incoming;
    vec2 pixel = abs(v.perPixel[0]) + abs(v.perPixel[1]);
    near.smear = sqrt(pixel * pixel + g.sourceBlur * g.sourceBlur);
    return near;
}

// What is left of a wave against another one whose ways differ by `turns` of it: the difference changes from one wavenumber
// of the list to the next by the part `step_`, and over the sample by `perSample` turns.
float nearContrast(float turns, float step_, float perSample) {
    return (1.0 - smoothstep(0.3, 0.5, turns * step_)) * sincOf(min(perSample, 1.0));
}

// Two sides, `x` their difference of ways in turns, as fringeContrast() has them.
float sidesContrast(float x, float step_, float perSample) {
    return (1.0 - smoothstep(0.3, 0.5, abs(x) * step_)) * (1.0 - smoothstep(0.3, 0.6, perSample));
}

// The share of a window about `offset` that lies within +-half_.
float covered(float offset, float half_, float window) {
    return max(min(abs(offset) + 0.5 * window, half_) - max(abs(offset) - 0.5 * window, -half_), 0.0) / window;
}

float nearStrip(float u, float curvature, float half_, float smear, float wavelength, float step_) {
    float scale = sqrt(2.0 * curvature / wavelength);
    float center = u / curvature, window = max(smear / curvature, 1e-9);
    float from = scale * (-half_ - center), to = scale * (half_ - center);
    vec2 atFrom = fresnelAuxiliary(abs(from)), atTo = fresnelAuxiliary(abs(to));
    vec2 waveFrom = edgeWave(from, atFrom), waveTo = edgeWave(to, atTo);
    float direct = 0.5 * ((to < 0.0 ? -1.0 : 1.0) - (from < 0.0 ? -1.0 : 1.0));
    float perSample = 0.5 * scale * window;                // turns of an edge's wave per unit of its place
    float ripple = nearContrast(0.25 * to * to, step_, perSample * abs(to)) * (waveTo.x + waveTo.y) -
                   nearContrast(0.25 * from * from, step_, perSample * abs(from)) * (waveFrom.x + waveFrom.y);
    float beat = sidesContrast(0.25 * (to * to - from * from), step_, perSample * (to - from)) * dot(waveTo, waveFrom);
    float value = direct * direct + direct * ripple + 0.5 * (dot(atFrom, atFrom) + dot(atTo, atTo)) - beat;

    // Where the sample hides the ripples: the image, and the mean of what spills.
    vec2 farFrom = fresnelAuxiliary(abs(from) + scale * window), farTo = fresnelAuxiliary(abs(to) + scale * window);
    float soft = covered(center, half_, window) + 0.5 * (dot(farFrom, farFrom) + dot(farTo, farTo));
    value = mix(value, soft, hiding(ripplesIn(window, curvature, half_, wavelength)));
    return value * wavelength / (4.0 * half_ * half_ * curvature);
}

// ---- round openings -------------------------------------------------------------------------------------------------
// Lengths from here on in units of sqrt(wavelength / curvature), so that a way of r has a phase of r^2 half turns. Seen at a
// slant the curvature differs along the two axes, and a round opening is an ellipse in these units.

// Fresnel's integral over an ellipse is that over the whole plane, if the point lies inside, less a wave from the rim.
struct RimWave {
    float lit;           // 1 inside
    vec2 wave;
    float gap;           // to the rim; negative outside
    float power;         // mean of |wave|^2 where fringes between the near and the far side are not seen
};

// `isRound`: the point lies on the first axis of a circle, and half of the rim does for all.
// The integral over the angle around the point becomes one over the angle around the middle. It is peaked next to the rim;
// less what its phase is at the near side, and its slope there, it is smooth, and a sum over even steps converges as soon as
// it resolves the phase. What was taken away has closed forms.
RimWave rimWave(vec2 axes, vec2 point, bool isRound) {
    RimWave rim;
    float away = length(point / axes), distance_ = length(point);
    rim.lit = away < 1.0 ? 1.0 : 0.0;
    rim.gap = distance_ / away - distance_;
    float square = rim.gap * rim.gap;
    vec2 sc = sinCosPi(square);
    vec2 first = vec2(sc.y, sc.x), slope = 3.14159265 * vec2(-sc.x, sc.y);
    vec2 near = fresnelAuxiliary(1.41421356 * abs(rim.gap)), far = fresnelAuxiliary(1.41421356 * (distance_ / away + distance_));
    rim.power = (min(0.5 * dot(near, near) / away, 0.5) + min(0.5 * dot(far, far) / away, 0.5));

    float needed = ceil((isRound ? 1.0 : 2.0) * (10.0 + 3.3 * axes.y * distance_));
    float nodes = needed <= MOST_RIM_NODES ? needed : 0.0;
    vec2 sum = vec2(0.0);
    for (float i = 0.5; i < nodes; i += 1.0) {
        vec2 sineCosine = sinCosPi((isRound ? 1.0 : 2.0) * i / nodes);
        vec2 r = axes * sineCosine.yx - point;
        float r2 = dot(r, r);
        vec2 wave = sinCosPi(r2).yx;
        float swept = axes.x * axes.y - point.x * axes.y * sineCosine.y - point.y * axes.x * sineCosine.x;
        sum += swept / max(r2, 1e-12) * (wave - first - (r2 - square) * slope);
    }
    rim.wave = rim.lit * first + sum / max(nodes, 1.0) + (axes.x * axes.y - square * rim.lit) * slope;
    if (needed > MOST_RIM_NODES) {                         // the near side alone, as a straight edge
        vec2 edge = edgeWave(1.41421356 * rim.gap, near);
        rim.wave = -0.5 * inversesqrt(max(away, 0.25)) * vec2(edge.x + edge.y, edge.y - edge.x);
    }
    return rim;
}

// The share of a square window that the image covers.
float discCovered(RimWave rim, vec2 axes, vec2 point, float window) {
    float round_ = clamp(0.5 + rim.gap / window, 0.0, 1.0);
    vec2 side = 0.886226925 * axes;                        // of a rectangle of the same area
    float coarse = covered(point.x, side.x, window) * covered(point.y, side.y, window);
    return mix(round_, coarse, smoothstep(1.0, 2.0, window / axes.x));
}

// `inner`: the hole's diameter over the ring's, 0 for a circle.
float nearDisc(NearView near, vec2 uv, float radius, float inner, float wavelength, float step_) {
    float slant2 = dot(near.out_, near.out_);
    vec2 squeezed = sqrt(near.curvature / wavelength * vec2(1.0 - slant2, 1.0));
    vec2 axes = radius * squeezed;
    bool isRound = (axes.y - axes.x) * axes.y < 3e-4;
    vec2 along = isRound ? uv : near.out_;
    along *= inversesqrt(max(dot(along, along), 1e-30));
    vec2 point = abs(vec2(dot(uv, along), along.x * uv.y - along.y * uv.x)) / (wavelength * squeezed);
    point.x = max(point.x, 1e-4 * axes.x);
    float smear = max(near.smear.x, near.smear.y);
    float window = max(smear / (wavelength * squeezed.x), 1e-6);
    float beats = sidesContrast(2.0 * axes.y * point.x, step_, 2.0 * axes.y * window);

    RimWave rim = rimWave(axes, point, isRound);
    float direct = rim.lit, power = rim.power;
    float ripple = nearContrast(0.5 * rim.gap * rim.gap, step_, abs(rim.gap) * window) * rim.wave.x;
    vec2 wave = rim.wave;
    float soft = discCovered(rim, axes, point, window);
    if (inner > 0.0) {
        RimWave hole = rimWave(inner * axes, point, isRound);
        direct -= hole.lit;
        power += hole.power;
        ripple -= nearContrast(0.5 * hole.gap * hole.gap, step_, abs(hole.gap) * window) * hole.wave.x;
        wave -= hole.wave;
        soft -= discCovered(hole, inner * axes, point, window);
    }
    float value = direct * direct - 2.0 * direct * ripple + mix(power, dot(wave, wave), beats);
    vec2 far = fresnelAuxiliary(1.41421356 * (abs(rim.gap) + window));
    soft += dot(far, far) * min(axes.x / point.x, 1.0);
    value = mix(value, soft, hiding(ripplesIn(smear / near.curvature, near.curvature, radius, wavelength)));
    float peak = 3.14159265 * axes.x * axes.y * (1.0 - inner * inner);
    return value / (peak * peak);
}

// Relative to the far field's peak; false where that is what is to be taken.
bool nearPattern(OpeningGrating g, uint opening, NearView near, Fading fading, vec2 uv, float wavenumber, out float pattern) {
    float wavelength = 1e-6 / wavenumber, step_ = g.wavenumberStep / wavenumber;
    vec2 half_ = 0.5e-6 * g.size_um;
    if (opening == RECTANGULAR_OPENING) {
        vec2 curvature = near.curvature * (1.0 - near.out_ * near.out_);
        vec2 number = half_ * half_ * curvature / wavelength;
        vec2 far = sidePatterns(fading, opening, uv * wavenumber * g.size_um, wavenumber);
        pattern = number.x > LEAST_FRESNEL_NUMBER ? nearStrip(uv.x, curvature.x, half_.x, near.smear.x, wavelength, step_)
                                                  : far.x;
        pattern *= number.y > LEAST_FRESNEL_NUMBER ? nearStrip(uv.y, curvature.y, half_.y, near.smear.y, wavelength, step_)
                                                   : far.y;
        return true;
    }
    pattern = nearDisc(near, uv, half_.x, opening == RING_OPENING ? g.size_um.y : 0.0, wavelength, step_);
    return half_.x * half_.x * near.curvature > LEAST_FRESNEL_NUMBER * wavelength;
}

// Where in the opening the light of a point comes from, by rays; the middle where it is no image of the opening.
vec3 nearFoot(OpeningGrating g, vec3 offset) {
    float nearness = inversesqrt(dot(offset, offset));
    vec2 uv = vec2(dot(offset, g.across), dot(offset, g.along)) * nearness - g.incoming;
    vec2 half_ = g.opening == RECTANGULAR_OPENING ? 0.5e-6 * g.size_um : vec2(0.5e-6 * g.size_um.x);
    float curvature = nearness - g.convergence;
    if (max(half_.x, half_.y) * max(half_.x, half_.y) * abs(curvature) < 0.25 * MIDDLE_WAVE) return vec3(0.0);
    vec2 foot = clamp(uv / curvature, -half_, half_);
    if (g.opening != RECTANGULAR_OPENING) foot *= min(half_.x * inversesqrt(max(dot(foot, foot), 1e-30)), 1.0);
    return foot.x * g.across + foot.y * g.along;
}
