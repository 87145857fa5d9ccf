// What of the patterns of openings a sample can resolve, and what stands for the rest (docs/theory.md, "Wavelengths").

// What a sample of a mask, or of a lattice's cells, averages over: the sides of its pixel, in turns from cell to cell at a
// wavenumber of 1, and the step of the list; and the width of a Gaussian besides.
struct CellBlur {
    mat3x2 sides;
    float source;
};

// How a pattern gives way to its mean where a sample cannot resolve it: fringes fade before they turn by half from one
// wavenumber of the list to the next, or from a pixel to the next, and would come back as an alias.
struct Fading {
    vec2 contrast;       // what is left of the fringes
    vec3 first;          // the mean at three wavenumbers, times their cubes; of rectangles and a mask's pixels for either side
    vec3 second;
    vec2 perPixel_um;    // of rectangles and a mask's pixels: turns between their sides from pixel to pixel, at a wavenumber of 1
    vec2 perStep;        // and from one wavenumber of the list to the next
    float beat;          // the same between the two rims of a ring
    float kept;          // of the pattern: 1 but in the pixel that holds the middle
    vec2 core;           // what that pixel covers, in 1/area of the opening at a wavenumber of 1, and what it misses of it
    CellBlur blur;       // of a mask
};

// Turns between two points of the opening, `apart_um` from each other: from one wavenumber of the list to the next, and
// from a pixel to the next.
vec2 turnsPerStep(OpeningGrating g, OpeningView v, vec2 apart_um) {
    return vec2(abs(dot(apart_um, v.uv)) * g.wavenumberStep, length(apart_um * v.perPixel) * MIDDLE_WAVENUMBER);
}
float fringeContrast(vec2 turns) { return (1.0 - smoothstep(0.3, 0.5, turns.x)) * (1.0 - smoothstep(0.3, 0.6, turns.y)); }

// Pixels and the source blur as far as the finest fringes cannot be told apart; a step of the list likewise, whose line
// then reaches from the middle between two wavenumbers to the next, so that no fringe adds up over the list.
CellBlur cellBlur(OpeningGrating g, OpeningView v, mat2 cell_um, float extentInCells) {
    vec2 step_ = g.wavenumberStep * v.uv * cell_um;
    mat2 pixel = mat2(v.perPixel[0] * cell_um, v.perPixel[1] * cell_um);
    float source = g.sourceBlur * min(length(cell_um[0]), length(cell_um[1]));
    float extent = MIDDLE_WAVENUMBER * extentInCells;
    float perPixel = sqrt(dot(pixel[0], pixel[0]) + dot(pixel[1], pixel[1]));
    pixel *= sqrt(smoothstep(0.15, 0.6, extent * perPixel));
    step_ *= sqrt(smoothstep(0.3, 0.6, extentInCells * length(step_)));
    return CellBlur(mat3x2(pixel[0], pixel[1], step_), source * sqrt(smoothstep(0.3, 0.6, extent * source) / 12.0));
}
MaskBlur blurAt(CellBlur blur, float wavenumber, float extentInCells, vec2 tableSize) {
    mat3x2 sides = mat3x2(wavenumber * blur.sides[0], wavenumber * blur.sides[1], blur.sides[2]);
    return maskBlur(sides, wavenumber * blur.source, extentInCells, tableSize);
}

// Of rectangles and a mask's pixels for either side, else of the widest points in the direction of the fringes.
Fading fadingOf(OpeningGrating g, uint opening, OpeningView v) {
    Fading fading;
    fading.kept = 1.0;
    fading.core = vec2(0.0);
    if (opening == RECTANGULAR_OPENING || opening == MASK_OPENING) {
        vec2 side = opening == MASK_OPENING ? g.pixel_um : g.size_um;
        vec2 x = turnsPerStep(g, v, vec2(side.x, 0.0)), y = turnsPerStep(g, v, vec2(0.0, side.y));
        fading.contrast = vec2(fringeContrast(x), fringeContrast(y));
        fading.perPixel_um = vec2(x.y, y.y) / MIDDLE_WAVENUMBER;
        fading.perStep = vec2(x.x, y.x);
        if (opening == MASK_OPENING) fading.blur = cellBlur(g, v, mat2(g.pixel_um.x, 0.0, 0.0, g.pixel_um.y), g.extent);
        return fading;
    }
    bool isPolygon = opening == POLYGONAL_OPENING || opening == SYMMETRIC_OPENING;
    float extent_um = isPolygon ? g.extent : g.size_um.x;
    vec2 turns = turnsPerStep(g, v, extent_um * v.uv * inversesqrt(max(dot(v.uv, v.uv), 1e-30)));
    fading.contrast = vec2(fringeContrast(turns));
    // All of the pattern is 1/area; the part beyond r, perimeter / (2 pi^2 r area^2) where r is large.
    float hole = opening == RING_OPENING ? g.size_um.y : 0.0;
    fading.beat = fringeContrast(0.5 * (1.0 - hole) * turns);
    float area = isPolygon ? g.size_um.x : 0.785398163 * g.size_um.x * g.size_um.x * (1.0 - hole * hole);
    float determinant_ = determinant(v.perPixel);
    vec2 inPixels = vec2(determinant(mat2(v.uv, v.perPixel[1])), determinant(mat2(v.perPixel[0], v.uv)));
    if (max(abs(inPixels.x), abs(inPixels.y)) < 0.5 * abs(determinant_)) {
        fading.kept = fading.contrast.x;
        fading.contrast = vec2(1.0);
        fading.core.x = abs(determinant_) * area;
        fading.core.y = 0.36 * sqrt(fading.core.x * (1.0 + hole) / (1.0 - hole));
    }
    return fading;
}

// Of the pixel that holds the middle.
vec3 coreMeans(Fading fading, vec3 wavenumbers) {
    return min(1.0 / (fading.core.x * wavenumbers * wavenumbers + max(vec3(0.65), fading.core.y * wavenumbers)), 1.0);
}

// Means change slowly with the wavenumber, so three are enough. Not so the beats of a ring, nor where the points of a source
// see the pattern in places of their own.
bool knowsMeans(uint opening) { return HAS_WIDE_SOURCES == 0u && opening != RING_OPENING; }

// The parabola through three values, over the cube of the wavenumber: 1 % off for what falls with its fourth power.
float meanAt(vec3 values, float wavenumber) {
    vec3 past = wavenumber - MEAN_WAVENUMBERS;
    vec3 weights = past.yxx * past.zzy * vec3(1.10558302, -2.19490782, 1.08932480);
    return dot(values, weights) / (wavenumber * wavenumber * wavenumber);
}

// Of one side of a rectangle, or of a mask's pixel, `x` turns between its ends at a wavenumber of 1.
vec3 sideMeans(float x, float perPixel, float perStep, vec3 wavenumbers) {
    vec3 root = vec3(slitMeanRoot(x * wavenumbers.x, perPixel * wavenumbers.x + perStep),
                     slitMeanRoot(x * wavenumbers.y, perPixel * wavenumbers.y + perStep),
                     slitMeanRoot(x * wavenumbers.z, perPixel * wavenumbers.z + perStep));
    return wavenumbers * wavenumbers * wavenumbers * root * root;
}
float polygonMeanOf(OpeningGrating g, uint opening, OpeningView v, vec2 uv, float wavenumber) {
    uint count = opening == SYMMETRIC_OPENING ? 2u * g.edgeCount : g.edgeCount;
    return polygonMean(uv, v.perPixel, g.wavenumberStep, wavenumber, g.table, count, g.edgeCount, g.size_um.x);
}

// `x`: turns between the sides.
vec2 sidePatterns(Fading fading, uint opening, vec2 x, float wavenumber) {
    vec2 mean;
    if (knowsMeans(opening)) {
        mean = vec2(meanAt(fading.first, wavenumber), meanAt(fading.second, wavenumber));
    } else {
        vec2 window = fading.perPixel_um * wavenumber + fading.perStep;
        vec2 root = vec2(slitMeanRoot(x.x, window.x), slitMeanRoot(x.y, window.y));
        mean = root * root;
    }
    return mix(mean, vec2(slitFactor(x.x), slitFactor(x.y)), fading.contrast);
}

void findMeans(OpeningGrating g, uint opening, OpeningView v, inout Fading fading) {
    if (!knowsMeans(opening)) return;
    vec3 wavenumbers = MEAN_WAVENUMBERS, cubes = wavenumbers * wavenumbers * wavenumbers;
    if (opening == RECTANGULAR_OPENING || opening == MASK_OPENING) {
        vec2 x = v.uv * (opening == MASK_OPENING ? g.pixel_um : g.size_um);
        fading.first = sideMeans(x.x, fading.perPixel_um.x, fading.perStep.x, wavenumbers);
        fading.second = sideMeans(x.y, fading.perPixel_um.y, fading.perStep.y, wavenumbers);
    } else if (opening == CIRCULAR_OPENING) {
        vec3 x = length(v.uv) * g.size_um.x * wavenumbers;
        fading.first = cubes * vec3(airyMean(x.x), airyMean(x.y), airyMean(x.z));
    } else {
        fading.first = vec3(0.0);
        // A loop of no turns is left out where an `if` would not be (path.glsl).
        for (uint i = 0u; i < (fading.contrast.x < 1.0 ? 3u : 0u); ++i) {
            float wavenumber = i == 0u ? wavenumbers.x : i == 1u ? wavenumbers.y : wavenumbers.z;
            float cube = wavenumber * wavenumber * wavenumber;
            fading.first = vec3(fading.first.yz, cube * polygonMeanOf(g, opening, v, v.uv, wavenumber));
        }
    }
    if (fading.kept < 1.0) {
        fading.first = cubes * coreMeans(fading, wavenumbers);
        fading.contrast.x = fading.kept;
    }
}

float fadedMask(OpeningGrating g, Fading fading, vec2 f_per_um, float wavenumber) {
    vec2 x = f_per_um * g.pixel_um;
    vec2 sides = sidePatterns(fading, MASK_OPENING, x, wavenumber);
    if (g.hasHats != 0u) sides *= sides;
    return maskPattern(x, g.table, g.size_um, blurAt(fading.blur, wavenumber, g.extent, g.size_um), false) * sides.x * sides.y;
}
