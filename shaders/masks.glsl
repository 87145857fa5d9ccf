// Far fields of masks, looked up (src/optics/mask_spectrum.hpp). The includer defines float maskEntry(uint at), the table,
// and includes apertures.glsl first.

// What a sample averages over, in turns from a pixel of the mask to the next: the parallelogram of its own pixel, and the
// line from one wavenumber of the list to the next. The table has levels that are averages already.
struct MaskBlur {
    mat3x2 sides;
    vec3 taps;           // points along each
    float level;
    float next;          // share of the next level
};

const MaskBlur SHARP_MASK = MaskBlur(mat3x2(0.0), vec3(1.0), 0.0, 0.0);

// `extent`: of the mask in pixels, so that 1/extent is the finest fringe. `source`: width of a Gaussian besides.
MaskBlur maskBlur(mat3x2 sides, float source, float extent, vec2 tableSize) {
    vec3 lengths = vec3(length(sides[0]), length(sides[1]), length(sides[2]));
    // Two points a quarter from the middle and 0.3 around them are a pixel with soft edges; such pixels side by side add up
    // to the same everywhere, to 6 %.
    float narrow = abs(determinant(mat2(sides[0], sides[1]))) / max(max(lengths.x, lengths.y), 1e-20);
    float sigma = sqrt(0.09 * narrow * narrow + source * source);
    MaskBlur blur;
    blur.sides = sides;
    vec3 wanted = clamp(ceil(lengths / max(0.9 / extent, 1.6 * sigma) - 0.1), 2.0, 8.0);
    blur.taps = mix(vec3(1.0), wanted, greaterThan(lengths * extent, vec3(0.02)));
    // Level k is as wide as 2^k steps; the first has none instead of one.
    float largest = max(tableSize.x, tableSize.y), steps = sigma * largest, last = log2(largest) - 1.0;
    blur.level = steps < 2.0 ? 0.0 : min(floor(log2(steps)), last);
    float from = blur.level == 0.0 ? 0.0 : exp2(2.0 * blur.level), to = exp2(2.0 * blur.level + 2.0);
    blur.next = blur.level == last ? 0.0 : clamp((steps * steps - from) / (to - from), 0.0, 1.0);
    return blur;
}

// The four cubic B-splines around a point `t` behind the second.
vec4 splineWeights(float t) {
    float s = 1.0 - t;
    return vec4(s * s * s, 4.0 + t * t * (3.0 * t - 6.0), 4.0 + s * s * (3.0 * s - 6.0), t * t * t) * 0.166666667;
}

// One level, of which half of the plane is there (the other half is its mirror image): entry (i, j) is at
// first + (j + 1) (columns / 2 + 4) + i + 1, from one before the first to two past the last.
float maskLevel(vec2 frequency, uint first, vec2 tableSize) {
    vec2 place = vec2(frequency.x, -frequency.y);          // rows run down, y up
    place = (place - roundEven(place)) * tableSize;
    if (place.x < 0.0) place = -place;
    if (place.y < 0.0) place.y += tableSize.y;
    vec2 whole = floor(place);
    vec4 across = splineWeights(place.x - whole.x), down = splineWeights(place.y - whole.y);
    uint stride = uint(tableSize.x) / 2u + 4u;
    uint at = first + uint(whole.y) * stride + uint(whole.x);
    float sum = 0.0;
    for (uint j = 0u; j < 4u; ++j) {
        sum += down[j] * dot(across, vec4(maskEntry(at), maskEntry(at + 1u), maskEntry(at + 2u), maskEntry(at + 3u)));
        at += stride;
    }
    return sum;
}

// `frequency`: in turns from a pixel to the next. Without what the pixels themselves make of it.
float maskPattern(vec2 frequency, uint first, vec2 tableSize, MaskBlur blur) {
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
                    mean += maskLevel(frequency + blur.sides * (vec3(i, j, k) / taps - 0.5), first, tableSize);
            }
        }
        sum += weight / (blur.taps.x * blur.taps.y * blur.taps.z) * mean;
        first += (uint(tableSize.x) / 2u + 4u) * (uint(tableSize.y) + 3u);
        largest *= 0.5;
        tableSize = min(tableSize, vec2(largest));
    }
    return sum;
}
