// Optical discs: a track of pits under a clear cover, as a reflection grating that turns with the place (docs/optical-discs.md).
// In the local frame (radial, along the track, normal) order m changes the direction cosine across the track by m wavelength /
// pitch and none else, and radiance per projected solid angle stays what it is. So at each wavelength a point of the disc shows
// the light source at another place of the line `along` = const through it, and light of all wavelengths is one integral over
// the chord that the source cuts out of this line: exact, noise-free, with the source's own size.

const float SHORTEST_WAVE_um = 0.38;
const float LONGEST_WAVE_um = 0.78;

bool isOnTrack(OpticalDisc disc, float squaredRadius) {
    return squaredRadius >= disc.innerRadiusSquared && squaredRadius <= disc.outerRadiusSquared;
}

// The matt part: the back, or the middle of both sides where there is no metal.
bool isLabel(OpticalDisc disc, float squaredRadius, bool isBack) {
    bool isHub = squaredRadius < disc.hubRadiusSquared;
    return decided(disc.metal) == NO_METAL ? isHub : isBack && !isHub;
}

// Share that a clear sheet reflects at both of its faces, all that goes to and fro between them included.
float clearSheet(float cosine, float index) {
    float ignored;
    float once = fresnelDielectric(cosine, index, ignored);
    return 2.0 * once / (1.0 + once);
}

// ---- what the disc does to a wavelength -----------------------------------------------------------------------------

// Cosine of a direction within the medium over the track, from the sum of squares of its other two cosines.
float cosineInside(OpticalDisc disc, float sineSquared) { return sqrt(max(1.0 - sineSquared / (disc.bend * disc.bend), 0.0)); }

// |e^{i phase} - 1|^2 for light that comes and goes under these cosines, both together.
float phaseContrast(OpticalDisc disc, float wavelength_um, float cosines) {
    float halfTurns = disc.depth_um * cosines / wavelength_um;
    float r = halfTurns - roundEven(halfTurns);
    float sine = r * sinPiOverX(r * r);
    return 4.0 * sine * sine;
}

// Of a table with an entry per spectral band.
float bandValue(uint table, float wavelength_um) {
    float place = bandPlace(wavelength_um);
    uint k = uint(place);
    return mix(tables[table + k], tables[table + k + 1u], place - float(k));
}

float metalReflectance(OpticalDisc disc, float wavelength_um, float cosine) {
    float place = bandPlace(wavelength_um);
    uint at = scene.frame.metals + 2u * (disc.metal * BANDS + uint(place));
    vec2 index = mix(vec2(tables[at], tables[at + 1u]), vec2(tables[at + 2u], tables[at + 3u]), fract(place)) / disc.bend;
    return fresnelConductor(cosine, index.x, index.y);
}

// Share of the light that comes under `cosIn` and leaves under `cosOut` with the mirror in between, without what the track
// makes of it. Light that the cover's surface throws back meets the mirror again.
float mirrorShare(OpticalDisc disc, float wavelength_um, float cosIn, float cosOut) {
    float ignored;
    if (decided(disc.metal) == NO_METAL) return fresnelDielectric(0.5 * (cosIn + cosOut), disc.index, ignored);
    float in_ = fresnelDielectric(cosIn, disc.index, ignored);
    float out_ = fresnelDielectric(cosOut, disc.index, ignored);
    float inside = 0.5 * (cosineInside(disc, 1.0 - cosIn * cosIn) + cosineInside(disc, 1.0 - cosOut * cosOut));
    float metal = metalReflectance(disc, wavelength_um, inside);
    return (1.0 - in_) * (1.0 - out_) * metal / (1.0 - metal * sqrt(in_ * out_));
}

// Scalar shares of the orders have the sum 1 with the evanescent ones, which carry nothing: this is what the others are
// multiplied by. `alpha`, `betaSquared`: the cosine of the light's way across the track, and that along it squared.
float renormalisation(OpticalDisc disc, float wavelength_um, float alpha, float betaSquared) {
    if (decided(disc.isCoarse) != 0u) return 1.0;
    float inside = cosineInside(disc, alpha * alpha + betaSquared);
    float contrast = phaseContrast(disc, wavelength_um, 2.0 * inside);
    float sum = 1.0 - contrast * disc.pits * (1.0 - disc.pits);
    float step_ = wavelength_um / disc.pitch_um;
    uint last = min(disc.orderCount, uint(2.0 / step_));
    for (uint m = 1u; m <= last; ++m) {
        float strength = tables[disc.orders + m - 1u];
        float up = alpha + float(m) * step_;
        float down = alpha - float(m) * step_;
        float upSquared = up * up + betaSquared;
        float downSquared = down * down + betaSquared;
        if (upSquared < 1.0) sum += strength * phaseContrast(disc, wavelength_um, inside + cosineInside(disc, upSquared));
        if (downSquared < 1.0) sum += strength * phaseContrast(disc, wavelength_um, inside + cosineInside(disc, downSquared));
    }
    float scattered = HAS_SCATTERING != 0u ? contrast * disc.scattering * bandValue(disc.scatteringShares, wavelength_um) : 0.0;
    return (1.0 - scattered) / sum;
}

// Share of the light per unit of the change `u` of the cosine across a wide groove, by the slope that reflects it there: a
// parabola has all slopes equally often (src/optics/track.hpp).
float grooveDensity(OpticalDisc disc, float u, float cosines) {
    float reach = disc.grooveSlope * cosines;
    return abs(u) < reach ? 0.5 * disc.pits / reach : 0.0;
}

// Share of the light that order `order`, not 0, sends to the eye.
float orderShare(OpticalDisc disc, TrackView v, float order, float wavelength_um) {
    float alpha = order * wavelength_um / disc.pitch_um - v.out_.x;
    float betaSquared = v.out_.y * v.out_.y;
    float cosSquared = 1.0 - alpha * alpha - betaSquared;
    if (cosSquared <= 0.0) return 0.0;
    float share;
    if (decided(disc.isGiven) != 0u) {
        uint row = uint(int(disc.orderCount) + int(order));
        share = bandValue(disc.orders + row * SPECTRAL_BANDS, wavelength_um);
    } else if (HAS_GROOVES != 0u && disc.grooveSlope > 0.0) {
        float cosines = cosineInside(disc, 1.0 - cosSquared) + cosineInside(disc, 1.0 - v.cosOut * v.cosOut);
        share = grooveDensity(disc, order * wavelength_um / disc.pitch_um, cosines) * wavelength_um / disc.pitch_um;
    } else {
        float cosines = cosineInside(disc, 1.0 - cosSquared) + cosineInside(disc, 1.0 - v.cosOut * v.cosOut);
        share = tables[disc.orders + uint(abs(order)) - 1u] * phaseContrast(disc, wavelength_um, cosines) *
                renormalisation(disc, wavelength_um, alpha, betaSquared);
    }
    return share * mirrorShare(disc, wavelength_um, sqrt(cosSquared), v.cosOut);
}

// Share of the light that is reflected as by a mirror, at the cover's surface and in order 0 of the track. `isTrack`: false
// for plain metal.
float undeviatedShare(OpticalDisc disc, vec2 out_, float cosine, float wavelength_um, bool isTrack) {
    float share = 1.0;
    if (isTrack && decided(disc.isGiven) != 0u) {
        share = bandValue(disc.orders + disc.orderCount * SPECTRAL_BANDS, wavelength_um);
    } else if (HAS_GROOVES != 0u && isTrack && disc.grooveSlope > 0.0) {
        share = 1.0 - disc.pits;
    } else if (isTrack) {
        float contrast = phaseContrast(disc, wavelength_um, 2.0 * cosineInside(disc, 1.0 - cosine * cosine));
        share = (1.0 - contrast * disc.pits * (1.0 - disc.pits)) * renormalisation(disc, wavelength_um, out_.x, out_.y * out_.y);
    }
    float ignored;
    float cover = disc.metal == NO_METAL ? 0.0 : fresnelDielectric(cosine, disc.index, ignored);
    return cover + share * mirrorShare(disc, wavelength_um, cosine, cosine);
}

// ---- all wavelengths ------------------------------------------------------------------------------------------------

// A spectrum off a reflectance: [density, prefix sum][nanometre][xyz], lines [wavelength_um, xyz] (src/compile/discs.hpp).
const uint SPECTRUM_ENTRIES = 401u;

// All below a wavelength: the integral of the piecewise linear density, exact.
vec3 spectrumBelow(uint table, float wavelength_um) {
    float at = clamp((wavelength_um - SHORTEST_WAVE_um) * 1e3, 0.0, float(SPECTRUM_ENTRIES) - 1.001);
    uint i = uint(at);
    float f = at - float(i);
    vec3 left = tableColor(table + 3u * i);
    vec3 right = tableColor(table + 3u * i + 3u);
    return tableColor(table + 3u * (SPECTRUM_ENTRIES + i)) + f * (left + 0.5 * f * (right - left));
}

// In a window of less than 2 nm, where a difference of the above would lose its digits.
vec3 spectrumAround(uint table, float middle_um, float width_um) {
    float at = clamp((middle_um - SHORTEST_WAVE_um) * 1e3, 0.0, float(SPECTRUM_ENTRIES) - 1.001);
    uint i = uint(at);
    return (width_um * 1e3) * mix(tableColor(table + 3u * i), tableColor(table + 3u * i + 3u), at - float(i));
}

// Within such a piece of the spectrum shares count as even: 3e-4 of the peak. Sources that fill a large part of the sky, whose
// pieces are wider, are no more off, since there the ends of the pieces cancel.
const float PIECE_um = 0.01;
const float MOST_PIECES = 20.0;

// Beyond this order of a wide groove twelve and more overlap, and make white.
const float GROOVE_ORDERS = 24.0;

// Radiance that all orders but 0 send to the eye, from a source of radiance 1 on the chord, off a matt surface if
// `reflectance` is not 0.
vec3 diffractedOrders(OpticalDisc disc, TrackView v, Chord chord, uint spectrum, uint reflectance) {
    uint entry = scene.frame.discSpectra + 3u * (spectrum * scene.frame.reflectanceCount + reflectance);
    uint table = scene.frame.discSpectra + uint(tables[entry]);
    uint lines = scene.frame.discSpectra + uint(tables[entry + 1u]);
    uint lineCount = uint(tables[entry + 2u]);
    vec3 sum = vec3(0.0);
    if (HAS_GROOVES != 0u && disc.grooveSlope > 0.0 &&
        disc.pitch_um * (abs(v.out_.x + chord.center) + chord.half_) > GROOVE_ORDERS * SHORTEST_WAVE_um) {
        float cosIn = sqrt(max(1.0 - chord.center * chord.center - v.out_.y * v.out_.y, 0.0));
        float cosines = cosineInside(disc, 1.0 - cosIn * cosIn) + cosineInside(disc, 1.0 - v.cosOut * v.cosOut);
        return 2.0 * chord.half_ * grooveDensity(disc, v.out_.x + chord.center, cosines) *
               mirrorShare(disc, MIDDLE_WAVE * 1e6, cosIn, v.cosOut) * seen(spectrum, reflectance);
    }
    for (float side = -1.0; side <= 1.0; side += 2.0) {
        float center = side * (v.out_.x + chord.center);   // order times wavelength / pitch, in the chord's middle
        float least = disc.pitch_um * (center - chord.half_);
        float most = disc.pitch_um * (center + chord.half_);
        if (HAS_DISC_CONTINUUM != 0u) {
            float last = min(float(disc.orderCount), floor(most / SHORTEST_WAVE_um));
            for (float order = max(1.0, ceil(least / LONGEST_WAVE_um)); order <= last; order += 1.0) {
                float from = least / order, to = most / order;
                bool whole = from >= SHORTEST_WAVE_um && to <= LONGEST_WAVE_um;
                from = max(from, SHORTEST_WAVE_um);
                to = min(to, LONGEST_WAVE_um);
                float middle = whole ? disc.pitch_um * center / order : 0.5 * (from + to);
                float width = whole ? 2.0 * disc.pitch_um * chord.half_ / order : to - from;
                float pieces = clamp(ceil(width / PIECE_um), 1.0, MOST_PIECES);
                bool isNarrow = width < 0.002;
                vec3 below = spectrumBelow(table, middle - 0.5 * width);
                for (float i = 0.5; i < pieces; i += 1.0) {
                    float wavelength_um = middle + width * (i / pieces - 0.5);
                    float share = orderShare(disc, v, side * order, wavelength_um) * throughputAt(wavelength_um);
                    vec3 next = spectrumBelow(table, wavelength_um + 0.5 * width / pieces);
                    sum += share * (isNarrow ? spectrumAround(table, middle, width) : next - below);
                    below = next;
                }
            }
        }
        if (HAS_DISC_LINES != 0u) {
            for (uint i = 0u; i < lineCount; ++i) {
                float wavelength_um = tables[lines + 4u * i];
                float last = min(float(disc.orderCount), floor(most / wavelength_um));
                for (float order = max(1.0, ceil(least / wavelength_um)); order <= last; order += 1.0) {
                    float share = orderShare(disc, v, side * order, wavelength_um) * throughputAt(wavelength_um);
                    sum += share * tableColor(lines + 4u * i + 1u);
                }
            }
        }
    }
    return sum;
}

// Radiance of what the pits scatter, from one direction that brings an irradiance of 1.
vec3 scatteredLight(OpticalDisc disc, TrackView v, vec3 normal, vec3 toLight, uint spectrum) {
    vec2 change = v.out_ + cosines(v, toLight);
    float cosIn = dot(toLight, normal);
    float inside = cosineInside(disc, 1.0 - cosIn * cosIn) + cosineInside(disc, 1.0 - v.cosOut * v.cosOut);
    uint colors = colorsOf(spectrum, 0u);
    vec3 sum = vec3(0.0);
    [[dont_unroll]] for (uint k = 0u; k < BANDS; ++k) {
        float wavelength_um = bandMiddle_um(k);
        float width = disc.pitWidth_um / wavelength_um, length_ = disc.correlation_um / wavelength_um;
        float along = 6.28318531 * length_ * change.y;
        float density = width * slitFactor(width * change.x) * 2.0 * length_ / (1.0 + along * along);
        float share = disc.scattering * phaseContrast(disc, wavelength_um, inside) * mirrorShare(disc, wavelength_um, cosIn, v.cosOut);
        sum += (inBand(k) * share * density) * bandColor(colors, k);
    }
    return sum;
}

// A disc sees the sky in so many parts of the chord, each hidden or not, and once more for what it scatters.
const uint SKY_PARTS = 8u;

uint partsOf(Light light) { return HAS_ENVIRONMENT != 0u && decided(light.kind) == ENVIRONMENT_LIGHT ? SKY_PARTS + 1u : 1u; }

// Radiance towards the eye from one part of a light that nothing hides, but for its mirror image. `incident` is a sample of
// the light; for parts of the sky its direction becomes one of them, by `random`.
vec3 discValue(OpticalDisc disc, TrackView v, vec3 normal, Light light, vec3 position, uint part, float random,
               inout Incident incident) {
    vec3 offset = light.position - position;
    Chord chord = chordOf(v, normal, light, offset, incident.direction, incident.irradiance, 1.0);
    bool isSky = partsOf(light) > 1u;
    bool isScattered = !isSky || part == SKY_PARTS;
    if (isSky) {
        float rim = chord.half_;
        chord.half_ = rim / float(SKY_PARTS);
        chord.center = (2.0 * float(part) + 1.0) * chord.half_ - rim;
        if (isScattered) {
            chord.radiance = 0.0;
        } else {
            float alpha = chord.center + (2.0 * random - 1.0) * chord.half_;
            incident.direction = alpha * v.radial - v.out_.y * v.along + sqrt(max(rim * rim - alpha * alpha, 0.0)) * normal;
        }
    }
    vec3 sum = vec3(0.0);
    if (chord.radiance > 0.0) sum = chord.radiance * diffractedOrders(disc, v, chord, light.spectrum, 0u);
    if (HAS_DISC_LIGHTS != 0u && decided(light.kind) == DISC_LIGHT && light.innerRatioSquared > 0.0) {
        Chord hole = chordOf(v, normal, light, offset, incident.direction, incident.irradiance, sqrt(light.innerRatioSquared));
        if (hole.radiance > 0.0) sum -= hole.radiance * diffractedOrders(disc, v, hole, light.spectrum, 0u);
    }
    if (HAS_SCATTERING != 0u && isScattered && disc.scattering > 0.0) {
        sum += incident.irradiance * scatteredLight(disc, v, normal, incident.direction, light.spectrum);
    }
    return sum;
}
