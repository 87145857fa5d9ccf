// Light from an opening of any shape in its far field, of rectangles and round ones at any distance (docs/theory.md,
// "Openings"): the radiant intensity is power * gamma * |A|^2 / (wavelength^2 * area * share), and falls off with the squared distance.
// A spectrum is a list of wavenumbers whose colours hold all but the pattern (src/compile/openings.hpp).

vec2 apertureVertex(uint first, uint index) { return vec2(tables[first + 2u * index], tables[first + 2u * index + 1u]); }
float maskEntry(uint at) { return tables[at]; }
const float MIDDLE_WAVENUMBER = 1.0 / 0.55;   // turns per micrometre

#include "apertures.glsl"
#include "even_waves.glsl"
#include "masks.glsl"

// A point as an opening sees it.
struct OpeningView {
    vec2 uv;             // change of the direction cosines
    mat2 perPixel;       // how much they change across the sample's share of a pixel
    float geometry;      // 1 / m^2: obliquity, the receiver's cosine, inverse square
    float nearness;      // 1 / distance
};

#include "fading.glsl"
#include "near_openings.glsl"
#include "near_layers.glsl"
#include "beam_spots.glsl"
#include "uneven_lattices.glsl"

bool reachesOpening(OpeningGrating g, vec3 position) { return dot(position - g.position, g.normal) > 0.0; }

OpeningView viewFromOpening(OpeningGrating g, vec3 offset, vec3 normal, vec3 view, float pixel) {
    float inverse = inversesqrt(dot(offset, offset));
    vec3 direction = offset * inverse;
    vec2 out_ = vec2(dot(direction, g.across), dot(direction, g.along));
    OpeningView v;
    v.uv = out_ - g.incoming;
    v.nearness = inverse;
    v.geometry = max(dot(direction, g.normal), 0.0) * max(-dot(direction, normal), 0.0) * inverse * inverse;
    vec3 t, b;
    completeFrame(view, t, b);
    float scale = pixel * inverse;
    vec3 alphaGradient = scale * (g.across - out_.x * direction), betaGradient = scale * (g.along - out_.y * direction);
    float perDepth = 1.0 / dot(normal, view);
    vec3 right = t - (dot(normal, t) * perDepth) * view, up = b - (dot(normal, b) * perDepth) * view;
    v.perPixel = mat2(dot(alphaGradient, right), dot(betaGradient, right), dot(alphaGradient, up), dot(betaGradient, up));
    return v;
}

// A row of N cells has peaks of width 1/N in turns. Where that is finer than a pixel, than the step from a wavenumber to
// the next or than the source, or where orders are images of the row (its near field), they become boxes as wide as all of
// these together, softened by another pixel, so that pixels however turned sum up to the same power.
struct LatticeRow {
    vec2 way_um;         // wayPerCell()
    float count;
    float image_um;      // width in the difference of the ways, which times the wavenumber is turns
    float blur;          // turns, of all but the image
    float pixel;         // turns
    float isMerged;      // 0 to 1
    float shear;         // of the trapezoid, along the other row
};
struct Lattice {
    LatticeRow first;
    LatticeRow second;
    float area;          // of a cell sheared so, over that of the rectangle
    UnevenLattice uneven;
};

LatticeRow latticeRow(OpeningGrating g, OpeningView v, vec4 step_um, float count) {
    LatticeRow row;
    row.way_um = wayPerCell(v.uv, step_um);
    row.count = count;
    vec2 perPixel_um = abs(step_um.xy * v.perPixel);
    row.pixel = min((perPixel_um.x + perPixel_um.y) * MIDDLE_WAVENUMBER, 0.5);
    float source_um = g.sourceBlur * (abs(step_um.x) + abs(step_um.y));
    float blur = source_um * MIDDLE_WAVENUMBER + abs(row.way_um.x) * g.wavenumberStep;
    row.blur = blur + 1.0 / count + row.pixel;
    row.image_um = dot(step_um.xy, step_um.xy) * count * 1e-6 * abs(v.nearness - g.convergence);
    row.isMerged = smoothstep(0.5, 1.0, max(row.image_um * MIDDLE_WAVENUMBER + blur, row.pixel) * count);
    return row;
}

Lattice latticeOf(OpeningGrating g, OpeningView v) {
    Lattice lattice;
    if (HAS_UNEVEN_LATTICES != 0u) lattice.uneven = unevenLatticeOf(g, v);
    lattice.first = latticeRow(g, v, g.first_um, g.counts.x);
    lattice.second = latticeRow(g, v, g.second_um, g.counts.y);
    // Turns along a row that is not square to the other change along that other as well.
    float square1 = dot(g.first_um.xy, g.first_um.xy), square2 = dot(g.second_um.xy, g.second_um.xy);
    float product = dot(g.first_um.xy, g.second_um.xy);
    lattice.first.shear = lattice.second.isMerged * product / square2;
    lattice.second.shear = lattice.first.isMerged * product / square1;
    lattice.area = 1.0 - lattice.first.shear * lattice.second.shear;
    lattice.first.image_um *= 1.0 - lattice.first.shear * product / square1;
    lattice.second.image_um *= 1.0 - lattice.second.shear * product / square2;
    return lattice;
}

// `past`: turns past an order.
float rowFactor(LatticeRow row, vec2 past, float pastOther, float wavenumber) {
    float wide = min(row.image_um * wavenumber + row.blur, 0.5), narrow = min(row.pixel, wide);
    float place = abs(past.x + past.y - row.shear * pastOther);
    float inside = clamp((0.5 * (wide + narrow) - place) / max(narrow, 0.01 * wide), 0.0, 1.0);
    return mix(fejer(past, row.count), inside / (wide * row.count), row.isMerged);
}

// Turns past the next order, along either row. `shift`: of the source.
void pastOrder(OpeningGrating g, Lattice lattice, vec2 shift, float wavenumber, out vec2 past1, out vec2 past2) {
    vec2 way1 = lattice.first.way_um, way2 = lattice.second.way_um;
    if (HAS_WIDE_SOURCES != 0u) {
        way1.x -= dot(shift, g.first_um.xy);
        way2.x -= dot(shift, g.second_um.xy);
    }
    past1 = turnsPastOrder(wavenumber, way1);
    past2 = turnsPastOrder(wavenumber, way2);
}

// The change of direction at which a cell's pattern is to be taken.
vec2 cellDirection(OpeningGrating g, Lattice lattice, vec2 uv, vec2 shift, float wavenumber) {
    if (HAS_UNEVEN_LATTICES == 0u || decided(g.isUneven) == 0u) return uv - shift;
    vec2 past1, past2;
    pastOrder(g, lattice, shift, wavenumber, past1, past2);
    return uv - shift - cellShift(g, lattice.uneven, vec2(past1.x + past1.y, past2.x + past2.y), wavenumber);
}

float latticeFactor(OpeningGrating g, Lattice lattice, vec2 shift, float wavenumber) {
    vec2 past1, past2;
    pastOrder(g, lattice, shift, wavenumber, past1, past2);
    if (HAS_UNEVEN_LATTICES != 0u && decided(g.isUneven) != 0u)
        return unevenFactor(g, lattice.uneven, vec2(past1.x + past1.y, past2.x + past2.y), wavenumber);
    return lattice.area * rowFactor(lattice.first, past1, past2.x + past2.y, wavenumber) *
           rowFactor(lattice.second, past2, past1.x + past1.y, wavenumber);
}

// A polygon's first vertices, loaded once for all wavenumbers.
struct Outline {
    vec2 vertices[FEW_EDGES + 1u];
};

Outline outlineOf(OpeningGrating g) {
    Outline outline;
    uint last = g.opening == SYMMETRIC_OPENING ? g.edgeCount : g.edgeCount - 1u;
    [[unroll]] for (uint i = 0u; i <= FEW_EDGES; ++i) {
        // Past the end the last again: edges without length.
        if (i <= max(POLYGON_EDGES, SYMMETRIC_EDGES)) outline.vertices[i] = apertureVertex(g.table, min(i, last));
    }
    return outline;
}

float polygonOf(OpeningGrating g, uint opening, Outline outline, vec2 uv, float wavenumber) {
    float scale = wavenumber * dot(uv, uv) * g.size_um.x;
    if (opening == SYMMETRIC_OPENING) {
        float sum = 0.0;
        [[unroll]] for (uint i = 0u; i < SYMMETRIC_EDGES; ++i)
            sum += pairOfEdges(polygonEdge(uv, outline.vertices[i], outline.vertices[i + 1u]), wavenumber);
        return symmetricPolygonIntensity(sum, scale);
    }
    if (POLYGON_EDGES > FEW_EDGES) return polygonPattern(uv, wavenumber, g.table, g.edgeCount, g.size_um.x);
    vec2 sum = vec2(0.0);
    [[unroll]] for (uint i = 0u; i < POLYGON_EDGES; ++i) {
        vec2 to = i + 1u < POLYGON_EDGES ? outline.vertices[i + 1u] : outline.vertices[0];
        sum += edgeWave(polygonEdge(uv, outline.vertices[i], to), wavenumber);
    }
    return polygonIntensity(sum, scale);
}

// Relative to the peak, outside the pixel that holds the middle.
float patternAround(OpeningGrating g, uint opening, Outline outline, Fading fading, OpeningView v, vec2 uv, float wavenumber) {
    vec2 f_per_um = uv * wavenumber, contrast = fading.contrast;
    if (opening == RECTANGULAR_OPENING) {
        vec2 sides = sidePatterns(fading, opening, f_per_um * g.size_um, wavenumber);
        return sides.x * sides.y;
    }
    if (opening == CIRCULAR_OPENING || opening == RING_OPENING) {
        float x = length(f_per_um) * g.size_um.x;
        if (opening == CIRCULAR_OPENING) {
            float mean = knowsMeans(opening) ? meanAt(fading.first, wavenumber) : airyMean(x);
            return mix(mean, circlePattern(x), contrast.x);
        }
        return mix(ringMean(x, g.size_um.y, fading.beat), ringPattern(x, g.size_um.y), contrast.x);
    }
    if (opening == MASK_OPENING) return fadedMask(g, fading, f_per_um, wavenumber);
    float mean = knowsMeans(opening) ? meanAt(fading.first, wavenumber) : polygonMeanOf(g, opening, v, uv, wavenumber);
    return mix(mean, polygonOf(g, opening, outline, uv, wavenumber), contrast.x);
}

// Relative to the peak. Means that are known hold that pixel's too.
float openingPattern(OpeningGrating g, uint opening, Outline outline, Fading fading, BeamSpot spot, OpeningView v, vec2 uv,
                     float wavenumber) {
    if (opening == GAUSSIAN_OPENING) return spotPattern(g, spot, uv, wavenumber);
    float pattern = patternAround(g, opening, outline, fading, v, uv, wavenumber);
    return knowsMeans(opening) ? pattern : mix(coreMeans(fading, vec3(wavenumber)).x, pattern, fading.kept);
}

// Sum over the EVEN_SAMPLES at hand, of a polygon with a centre of symmetry: symmetricPolygonIntensity() and what the means
// come to.
vec3 evenPolygonSum(OpeningGrating g, Outline outline, Fading fading, vec2 uv) {
    // At the peak from so near to it that it makes no difference.
    if (dot(uv, uv) < 1e-24) uv = vec2(1e-12, 0.0);
    float weight = 0.101321184 * sqrt(fading.contrast.x) / (dot(uv, uv) * g.size_um.x);   // 1/pi^2
    EvenEdge edges[FEW_EDGES];
    [[unroll]] for (uint i = 0u; i < FEW_EDGES; ++i) {
        if (i >= SYMMETRIC_EDGES) continue;
        vec3 edge = polygonEdge(uv, outline.vertices[i], outline.vertices[i + 1u]);
        edges[i] = evenEdge(edge, weight, scene.openingSamples[0].wavenumber, g.wavenumberStep);
    }
    vec3 means = (1.0 - fading.contrast.x) * fading.first, sum = vec3(0.0);
    [[unroll]] for (uint j = 0u; j < 3u; ++j) sum += means[j] * scene.openingMeans[j];
    [[unroll]] for (uint j = 0u; j < EVEN_SAMPLES; ++j) {
        float amplitude = 0.0;
        [[unroll]] for (uint i = 0u; i < FEW_EDGES; ++i) {
            if (i < SYMMETRIC_EDGES) amplitude += nextPairOfEdges(edges[i]);
        }
        float square = scene.openingSamples[j].wavenumber * scene.openingSamples[j].wavenumber;
        sum += amplitude * amplitude * (scene.openingSamples[j].color / (square * square));
    }
    return sum;
}

// Sum over the first `count` entries of the list; `count` is 0 where the opening is another one.
vec3 sumOverWavenumbers(OpeningGrating g, uint opening, uint count, OpeningView v, uint reflectance) {
    Outline outline;
    if (opening == POLYGONAL_OPENING || opening == SYMMETRIC_OPENING) outline = outlineOf(g);
    LayersView layers;
    bool hasLayers = HAS_NEAR_LAYERS != 0u && decided(g.hasLayers) != 0u;
    if (HAS_NEAR_LAYERS != 0u) {
        layers = layersView(g, v);
        if (hasLayers) v = besideImage(v, layers);
    }
    Fading fading = fadingOf(g, opening, v);
    if (HAS_NEAR_LAYERS != 0u && hasLayers && opening == MASK_OPENING)
        fading.blur = CellBlur(mat3x2(0.0), roundBlur(fading.blur));
    findMeans(g, opening, v, fading);
    BeamSpot spot;
    if (opening == GAUSSIAN_OPENING) spot = beamSpotOf(g, v);
    bool isLattice = HAS_LATTICES != 0u && decided(g.isLattice) != 0u;
    Lattice lattice;
    if (HAS_LATTICES != 0u) lattice = latticeOf(g, v);
    NearView near;
    if (HAS_NEAR_OPENINGS != 0u) near = nearView(g, v);
    vec3 sum = vec3(0.0);
    if (SAMPLES_AT_HAND != 0u) {
        if (EVEN_SAMPLES != 0u) sum = throughput.band[0] * evenPolygonSum(g, outline, fading, v.uv);
        [[unroll]] for (uint i = EVEN_SAMPLES; i < SAMPLES_AT_HAND; ++i) {
            OpeningSample sample_ = scene.openingSamples[i];
            vec2 uv = cellDirection(g, lattice, v.uv, vec2(0.0), sample_.wavenumber);
            float pattern = openingPattern(g, opening, outline, fading, spot, v, uv, sample_.wavenumber);
            if (isLattice) pattern *= latticeFactor(g, lattice, vec2(0.0), sample_.wavenumber);
            sum += pattern * throughputAt(1.0 / sample_.wavenumber) * sample_.color;
        }
        return sum;
    }
    uint colors = g.samples + 3u * g.sampleCount * (1u + reflectance);
    for (uint i = 0u; i < count; ++i) {
        uint at = g.samples + 3u * i;
        float wavenumber = tables[at];
        vec2 shift = vec2(0.0);
        if (HAS_WIDE_SOURCES != 0u) shift = vec2(tables[at + 1u], tables[at + 2u]);
        float pattern;
        bool isNear = false;
        if (HAS_NEAR_OPENINGS != 0u && opening <= RING_OPENING && decided(g.isNear) != 0u) {
            isNear = nearPattern(g, opening, near, fading, v.uv - shift, wavenumber, pattern);
        }
        vec2 uv = cellDirection(g, lattice, v.uv, shift, wavenumber);
        if (HAS_NEAR_LAYERS != 0u && hasLayers) {
            float beyond;
            pattern = layersPattern(g, layers, v.uv - shift, wavenumber, beyond);
            // A loop of no turns is left out where an `if` would not be (path.glsl).
            float edges = opening == MASK_OPENING ? edgesShare(layers, g.pixel_um, wavenumber) : 0.0;
            for (float i = 0.0; i < ceil(beyond * (1.0 - edges)); i += 1.0)
                pattern += beyond * (1.0 - edges) * openingPattern(g, opening, outline, fading, spot, v, uv, wavenumber);
            if (opening == MASK_OPENING && beyond * edges > 0.0)
                pattern += beyond * edges * edgesPattern(layers, uv * wavenumber, wavenumber);
            isNear = true;
        }
        if (!isNear) pattern = openingPattern(g, opening, outline, fading, spot, v, uv, wavenumber);
        if (isLattice) pattern *= latticeFactor(g, lattice, shift, wavenumber);
        sum += pattern * throughputAt(1.0 / wavenumber) * tableColor(colors + 3u * i);
    }
    return sum;
}

// As slitGratingValue().
vec3 openingGratingValue(OpeningGrating g, vec3 offset, vec3 normal, vec3 view, float pixel, uint reflectance) {
    OpeningView v = viewFromOpening(g, offset, normal, view, pixel);
    uint kind = decided(g.opening);
    vec3 sum = vec3(0.0);
    // A loop of no turns is left out where an `if` would not be (path.glsl).
#define ADD_OPENING(KIND, HAS)                                                                                          \
    if (HAS != 0u) sum += sumOverWavenumbers(g, KIND, kind == KIND ? g.sampleCount : 0u, v, reflectance);
    ADD_OPENING(RECTANGULAR_OPENING, HAS_RECTANGULAR_OPENINGS)
    ADD_OPENING(CIRCULAR_OPENING, HAS_CIRCULAR_OPENINGS)
    ADD_OPENING(RING_OPENING, HAS_RING_OPENINGS)
    ADD_OPENING(POLYGONAL_OPENING, HAS_POLYGONAL_OPENINGS)
    ADD_OPENING(SYMMETRIC_OPENING, HAS_SYMMETRIC_OPENINGS)
    ADD_OPENING(MASK_OPENING, HAS_MASK_OPENINGS)
    ADD_OPENING(GAUSSIAN_OPENING, HAS_GAUSSIAN_OPENINGS)
#undef ADD_OPENING
    return v.geometry * sum;
}
