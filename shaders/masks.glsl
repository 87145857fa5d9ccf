// Far fields of masks, looked up (src/optics/mask_spectrum.hpp). The includer defines float maskEntry(uint at), the table,
// and includes apertures.glsl first.

// What a sample averages over, in turns from a pixel of the mask to the next: the parallelogram of its own pixel, and the
// line from one wavenumber of the list to the next. The table has levels that are averages already.
struct MaskBlur {
    mat3x2 sides;
    vec3 taps;           // points along each
    vec3 moments;        // of the narrow sides, which the bends of the table's splines do for: xx, xy, yy
    float level;
    float next;          // share of the next level
};

const MaskBlur SHARP_MASK = MaskBlur(mat3x2(0.0), vec3(1.0), vec3(0.0), 0.0, 0.0);

// `extent`: of the mask in pixels, so that 1/extent is the finest fringe. `source`: width of a Gaussian besides.
MaskBlur maskBlur(mat3x2 sides, float source, float extent, vec2 tableSize) {
    vec3 lengths = vec3(length(sides[0]), length(sides[1]), length(sides[2]));
    // A third of the finest fringe, or less.
    vec3 isNarrow = vec3(lessThan(vec3(max(lengths.x, lengths.y), max(lengths.x, lengths.y), lengths.z) * extent, vec3(0.35)));
    vec3 across = isNarrow * vec3(sides[0].x, sides[1].x, sides[2].x), down = isNarrow * vec3(sides[0].y, sides[1].y, sides[2].y);
    // Two points a quarter from the middle and 0.3 around them are a pixel with soft edges; such pixels side by side add up
    // to the same everywhere, to 6 %.
    float narrow = abs(determinant(mat2(sides[0], sides[1]))) / max(max(lengths.x, lengths.y), 1e-20);
    float sigma = sqrt((1.0 - isNarrow.x) * 0.09 * narrow * narrow + source * source);
    MaskBlur blur;
    blur.sides = sides;
    vec3 wanted = clamp(ceil(lengths / max(0.9 / extent, 1.6 * sigma) - 0.1), 2.0, 8.0);
    blur.taps = mix(wanted, vec3(1.0), isNarrow);
    // Of what is narrow the mean squares of the distances alone count: of two points a quarter from the middle, 1/16, and 0.09
    // around them.
    const vec3 SQUARES = vec3(0.1525, 0.1525, 0.0625);
    blur.moments = vec3(dot(SQUARES, across * across), dot(SQUARES, across * down), dot(SQUARES, down * down));
    // Level k is as wide as 2^k steps; the first has none instead of one.
    float largest = max(tableSize.x, tableSize.y), steps = sigma * largest, last = log2(largest) - 1.0;
    blur.level = steps < 2.0 ? 0.0 : min(floor(log2(steps)), last);
    float from = blur.level == 0.0 ? 0.0 : exp2(2.0 * blur.level), to = exp2(2.0 * blur.level + 2.0);
    blur.next = blur.level == last ? 0.0 : clamp((steps * steps - from) / (to - from), 0.0, 1.0);
    return blur;
}

// The four cubic B-splines around a point `t` behind the second, their slopes and bends.
vec4 splineWeights(float t) {
    float s = 1.0 - t;
    return vec4(s * s * s, 4.0 + t * t * (3.0 * t - 6.0), 4.0 + s * s * (3.0 * s - 6.0), t * t * t) * 0.166666667;
}
vec4 splineSlopes(float t) {
    float s = 1.0 - t;
    return vec4(-s * s, t * (3.0 * t - 4.0), s * (4.0 - 3.0 * s), t * t) * 0.5;
}
vec4 splineBends(float t) { return vec4(1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t); }

uint maskStride(float columns, bool isWhole) { return uint(columns) / (isWhole ? 1u : 2u) + (isWhole ? 3u : 4u); }

// One level, of which half of the plane is there (the other half is its mirror image) unless it `isWhole`: entry (i, j) is
// at first + (j + 1) maskStride() + i + 1, from one before the first to two past the last. A mean over what has the second
// `moments`.
float maskLevel(vec2 frequency, vec3 moments, uint first, vec2 tableSize, bool isWhole) {
    vec2 place = vec2(frequency.x, -frequency.y);          // rows run down, y up
    place = (place - roundEven(place)) * tableSize;
    if (place.x < 0.0) place = isWhole ? place + vec2(tableSize.x, 0.0) : -place;
    if (place.y < 0.0) place.y += tableSize.y;
    vec2 whole = floor(place);
    vec2 rest = place - whole;
    vec4 across = splineWeights(rest.x), down = splineWeights(rest.y);
    vec3 bends = moments * vec3(0.5, -1.0, 0.5) * vec3(tableSize.x, tableSize.x, tableSize.y) * vec3(tableSize, tableSize.y);
    vec4 acrossBent = across + bends.x * splineBends(rest.x), tilted = bends.y * splineSlopes(rest.x);
    vec4 downTilted = splineSlopes(rest.y), downBent = bends.z * splineBends(rest.y);
    uint stride = maskStride(tableSize.x, isWhole);
    uint at = first + uint(whole.y) * stride + uint(whole.x);
    float sum = 0.0;
    for (uint j = 0u; j < 4u; ++j) {
        vec4 weights = down[j] * acrossBent + downTilted[j] * tilted + downBent[j] * across;
        sum += dot(weights, vec4(maskEntry(at), maskEntry(at + 1u), maskEntry(at + 2u), maskEntry(at + 3u)));
        at += stride;
    }
    return sum;
}

// `frequency`: in turns from a pixel to the next. Without what the pixels themselves make of it.
float maskPattern(vec2 frequency, uint first, vec2 tableSize, MaskBlur blur, bool isWhole) {
    float largest = max(tableSize.x, tableSize.y);
    float levels = blur.next > 0.0 ? blur.level + 2.0 : blur.level + 1.0;
    float sum = 0.0;
    for (float level = 0.0; level < levels; level += 1.0) {
        float weight = level < blur.level ? 0.0 : level == blur.level ? 1.0 - blur.next : blur.next;
        vec3 taps = weight > 0.0 ? blur.taps : vec3(0.0);
        float mean = 0.0;
        for (float i = 0.5; i < taps.x; i += 1.0) {
            for (float j = 0.5; j < taps.y; j += 1.0) {
                for (float k = 0.5; k < taps.z; k += 1.0)
                    mean += maskLevel(frequency + blur.sides * (vec3(i, j, k) / taps - 0.5), blur.moments, first, tableSize, isWhole);
            }
        }
        sum += weight / (blur.taps.x * blur.taps.y * blur.taps.z) * mean;
        first += maskStride(tableSize.x, isWhole) * (uint(tableSize.y) + 3u);
        largest *= 0.5;
        tableSize = min(tableSize, vec2(largest));
    }
    return sum;
}
