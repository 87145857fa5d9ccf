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

// |e^{i phase} - 1|^2 by half the phase in turns.
float contrastOf(float halfTurns) {
    float r = halfTurns - roundEven(halfTurns);
    float sine = r * sinPiOverX(r * r);
    return 4.0 * sine * sine;
}

// The same for light that comes and goes under these cosines, both together.
float phaseContrast(OpticalDisc disc, float wavelength_um, float cosines) {
    return contrastOf(disc.depth_um * cosines / wavelength_um);
}

// What order 0 carries, with what is scattered.
float undeviated(OpticalDisc disc, float contrast) { return 1.0 - contrast * disc.pits * (1.0 - disc.pits); }

// What an order, not 0, carries at a contrast of 1 (src/optics/track.hpp).
float orderStrength(OpticalDisc disc, float order) {
    return disc.pits * disc.pits * slitFactor(order * disc.pitWidth_um / disc.pitch_um);
}

// The same of orders 1, 2, ... one after the other: (pit share/(pi m))^2 sin^2(pi m width/pitch), with 1 - cos(m x) by the
// recurrence that keeps its digits at small x (C. Reinsch, in J. Stoer, R. Bulirsch, "Introduction to Numerical Analysis", 1.3).
struct OrderStrengths {
    float scale;
    float first;         // 1 - cos x, x = 2 pi width/pitch
    float here;          // 1 - cos(m x)
    float change;        // from m - 1 to m
};

OrderStrengths orderStrengths(OpticalDisc disc) {
    float share = disc.pitWidth_um / disc.pitch_um;
    float r = share - roundEven(share);
    float sine = r * sinPiOverX(r * r);
    float first = 2.0 * sine * sine;
    float pitShare = disc.pits / share;
    return OrderStrengths(0.5 * pitShare * pitShare * 0.101321184, first, first, first);   // 1/pi^2
}
float strengthOf(OrderStrengths s, float m) { return s.scale * s.here / (m * m); }
void advance(inout OrderStrengths s) {
    s.change += 2.0 * s.first * (1.0 - s.here);
    s.here += s.change;
}

// Of a table with an entry per spectral band.
float bandValue(uint table, float wavelength_um) {
    float place = bandPlace(wavelength_um);
    uint k = uint(place);
    return mix(tables[table + k], tables[table + k + 1u], place - float(k));
}

// n + ik of the metal at the middle of a band, seen from within the medium over the track.
vec2 metalIndex(OpticalDisc disc, uint band) {
    if (decided(disc.metal) == NO_METAL) return vec2(0.0);
    uint at = scene.frame.metals + 2u * (disc.metal * BANDS + band);
    return vec2(tables[at], tables[at + 1u]) / disc.bend;
}
vec2 metalIndex(OpticalDisc disc, float wavelength_um) {
    float place = bandPlace(wavelength_um);
    return mix(metalIndex(disc, uint(place)), metalIndex(disc, uint(place) + 1u), fract(place));
}

// Share of the light that comes under `cosIn` and leaves under `cosOut` with the mirror in between, without what the track
// makes of it. Light that the cover's surface throws back meets the mirror again.
float mirrorShare(OpticalDisc disc, vec2 metalIndex_, float cosIn, float cosOut) {
    float ignored;
    if (decided(disc.metal) == NO_METAL) return fresnelDielectric(0.5 * (cosIn + cosOut), disc.index, ignored);
    float in_ = fresnelDielectric(cosIn, disc.index, ignored);
    float out_ = fresnelDielectric(cosOut, disc.index, ignored);
    float inside = 0.5 * (cosineInside(disc, 1.0 - cosIn * cosIn) + cosineInside(disc, 1.0 - cosOut * cosOut));
    float metal = fresnelConductor(inside, metalIndex_.x, metalIndex_.y);
    return (1.0 - in_) * (1.0 - out_) * metal / (1.0 - metal * sqrt(in_ * out_));
}

// Scalar shares of the orders have the sum 1 with the evanescent ones, which carry nothing: this is what the others are
// multiplied by. `alpha`, `betaSquared`: the cosine of the light's way across the track, and that along it squared.
// `scatteringShare`: of what the pits scatter, the part that propagates.
float renormalisation(OpticalDisc disc, float wavelength_um, float alpha, float betaSquared, float scatteringShare) {
    if (decided(disc.isCoarse) != 0u) return 1.0;
    float inside = cosineInside(disc, alpha * alpha + betaSquared);
    float contrast = phaseContrast(disc, wavelength_um, 2.0 * inside);
    float sum = undeviated(disc, contrast);
    float perOrder = wavelength_um / disc.pitch_um, halfTurns = disc.depth_um / wavelength_um;
    float perBendSquared = 1.0 / (disc.bend * disc.bend);
    float most = min(float(disc.orderCount), (1.0 + abs(alpha)) / perOrder);
    OrderStrengths s = orderStrengths(disc);
    for (float m = 1.0; m <= most; m += 1.0) {
        vec2 alphas = alpha + vec2(m, -m) * perOrder;
        vec2 squares = alphas * alphas + betaSquared;
        vec2 insides = inside + sqrt(max(1.0 - squares * perBendSquared, 0.0));
        sum += strengthOf(s, m) * ((squares.x < 1.0 ? contrastOf(halfTurns * insides.x) : 0.0) +
                                   (squares.y < 1.0 ? contrastOf(halfTurns * insides.y) : 0.0));
        advance(s);
    }
    return (1.0 - contrast * disc.scattering * scatteringShare) / sum;
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
        share = orderStrength(disc, order) * phaseContrast(disc, wavelength_um, cosines) *
                renormalisation(disc, wavelength_um, alpha, betaSquared,
                                HAS_SCATTERING != 0u ? bandValue(disc.scatteringShares, wavelength_um) : 0.0);
    }
    return share * mirrorShare(disc, metalIndex(disc, wavelength_um), sqrt(cosSquared), v.cosOut);
}

// Share of the light that is reflected as by a mirror, at the cover's surface and in order 0 of the track. `isTrack`: false
// for plain metal.
float undeviatedShare(OpticalDisc disc, vec2 out_, float cosine, uint band, bool isTrack) {
    float wavelength_um = bandMiddle_um(band);
    float share = 1.0;
    if (isTrack && decided(disc.isGiven) != 0u) {
        share = tables[disc.orders + disc.orderCount * SPECTRAL_BANDS + band];
    } else if (HAS_GROOVES != 0u && isTrack && disc.grooveSlope > 0.0) {
        share = 1.0 - disc.pits;
    } else if (isTrack) {
        float contrast = phaseContrast(disc, wavelength_um, 2.0 * cosineInside(disc, 1.0 - cosine * cosine));
        share = undeviated(disc, contrast) *
                renormalisation(disc, wavelength_um, out_.x, out_.y * out_.y,
                                HAS_SCATTERING != 0u ? tables[disc.scatteringShares + band] : 0.0);
    }
    float ignored;
    float cover = disc.metal == NO_METAL ? 0.0 : fresnelDielectric(cosine, disc.index, ignored);
    return cover + share * mirrorShare(disc, metalIndex(disc, band), cosine, cosine);
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
               mirrorShare(disc, metalIndex(disc, MIDDLE_WAVE * 1e6), cosIn, v.cosOut) * seen(spectrum, reflectance);
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

// ---- the sky --------------------------------------------------------------------------------------------------------
// An even sky lights all orders of a wavelength at once, from the directions alpha = order wavelength / pitch - out_.x. Whichever
// of them is looked from, the others are where its light goes, so at one wavelength they serve as that and as what shares are
// normalised by. Chord by chord and piece by piece, as for lamps, the same takes twice as long.

// The line through the sky in parts, each hidden or not.
const uint SKY_PARTS = 8u;

// With more orders than a pitch of 2.5 um has, and the directions of lines, that is no gain.
bool seesSkyInBands(OpticalDisc disc) {
    return HAS_ENVIRONMENT != 0u && HAS_DISC_LINES == 0u && decided(disc.isGiven) == 0u && decided(disc.isCoarse) == 0u &&
           disc.pitch_um < 2.5;
}

vec3 skyDirection(TrackView v, vec3 normal, float rim, float alpha) {
    return alpha * v.radial - v.out_.y * v.along + sqrt(max(rim * rim - alpha * alpha, 0.0)) * normal;
}

// How much of a stretch of directions across the track, which may reach from one part into the next, is open.
float openShare(uint open, float rim, float low, float high) {
    float perPart = 2.0 * rim / float(SKY_PARTS);
    float first = clamp(floor((low + rim) / perPart), 0.0, float(SKY_PARTS) - 1.0);
    float last = clamp(floor((high + rim) / perPart), 0.0, float(SKY_PARTS) - 1.0);
    float beyond = clamp((high - (first + 1.0) * perPart + rim) / max(high - low, 1e-7), 0.0, 1.0);
    return mix(float(open >> uint(first) & 1u), float(open >> uint(last) & 1u), beyond);
}

// Radiance that all orders but 0 send to the eye from a sky of radiance 1; `open`: a bit for each part of the line, which reaches
// from -rim to rim. An order counts by the share of a band's width for which it has a direction.
vec3 ordersOfSky(OpticalDisc disc, TrackView v, float rim, uint open, uint spectrum) {
    uint colors = colorsOf(spectrum, 0u);
    float rimSquared = rim * rim, betaSquared = v.out_.y * v.out_.y;
    float insideOut = cosineInside(disc, 1.0 - v.cosOut * v.cosOut);
    float perBendSquared = 1.0 / (disc.bend * disc.bend);
    OrderStrengths strengths = orderStrengths(disc);
    vec3 sum = vec3(0.0);
    [[dont_unroll]] for (uint k = 0u; k < BANDS; ++k) {
        float wavelength_um = bandMiddle_um(k);
        float perOrder = wavelength_um / disc.pitch_um;
        float blur = 0.25 * (bandMiddle_um(k + 1u) - bandMiddle_um(max(k, 1u) - 1u)) / disc.pitch_um;
        float halfTurns = disc.depth_um / wavelength_um;
        vec2 metal = metalIndex(disc, k);
        float scattered = HAS_SCATTERING != 0u ? disc.scattering * tables[disc.scatteringShares + k] : 0.0;
        float ofBand = 0.0;
        float last = ceil((v.out_.x + rim) / perOrder);
        for (float order = floor((v.out_.x - rim) / perOrder); order <= last; order += 1.0) {
            float middle = order * perOrder - v.out_.x, half_ = abs(order) * blur;
            float low = max(middle - half_, -rim), high = min(middle + half_, rim);
            if (order == 0.0 || low >= high) continue;
            float alpha = 0.5 * (low + high);
            float inside = sqrt(max(1.0 - (alpha * alpha + betaSquared) * perBendSquared, 0.0));
            float contrast = contrastOf(2.0 * halfTurns * inside);
            float all = undeviated(disc, contrast);
            float most = (rim + abs(middle)) / perOrder + 1.0;
            OrderStrengths s = strengths;
            for (float m = 1.0; m <= most; m += 1.0) {
                vec2 others = order + vec2(m, -m);
                vec2 alphas = others * perOrder - v.out_.x;
                vec2 covered = clamp((rim - abs(alphas)) / (2.0 * blur * abs(others) + 1e-6) + 0.5, 0.0, 1.0);
                vec2 insides = sqrt(max(1.0 - (min(alphas * alphas, vec2(rimSquared)) + betaSquared) * perBendSquared, 0.0));
                all += strengthOf(s, m) * (covered.x * contrastOf(halfTurns * (inside + insides.x)) +
                                           covered.y * contrastOf(halfTurns * (inside + insides.y)));
                advance(s);
            }
            float share = orderStrength(disc, order) * contrastOf(halfTurns * (inside + insideOut));
            ofBand += share * (1.0 - contrast * scattered) / all * (high - low) / (2.0 * half_) * openShare(open, rim, low, high) *
                      mirrorShare(disc, metal, sqrt(max(rimSquared - alpha * alpha, 0.0)), v.cosOut);
        }
        sum += (inBand(k) * ofBand) * bandColor(colors, k);
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
        float share = disc.scattering * phaseContrast(disc, wavelength_um, inside) *
                      mirrorShare(disc, metalIndex(disc, k), cosIn, v.cosOut);
        sum += (inBand(k) * share * density) * bandColor(colors, k);
    }
    return sum;
}

// A disc sees the parts of the sky one by one, and it once more for what it scatters.
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
            incident.direction = skyDirection(v, normal, rim, chord.center + (2.0 * random - 1.0) * chord.half_);
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
