// Near fields that are looked up (docs/theory.md, "Near field"): of polygons and masks, and of openings that cut a Gaussian
// beam. Tables as masks have them (masks.glsl), each for a Fresnel number, in a row (src/compile/near_layers.hpp).

struct LayersView {
    LayerRow row;
    float number;        // Fresnel number at a wavenumber of 1
    float towards;       // 1; behind the beam's focus -1, where the image stands on its head
    float image;         // direction cosines that the opening's image is wide
    float blur;          // a Gaussian's width, in turns from pixel to pixel of the opening at a wavenumber of 1
};

// A Gaussian as wide as what a sample averages over: rounder than that, but seen in one look.
float roundBlur(CellBlur blur) {
    vec2 step_ = blur.sides[2] / MIDDLE_WAVENUMBER;
    return sqrt(0.08 * (dot(blur.sides[0], blur.sides[0]) + dot(blur.sides[1], blur.sides[1])) + 0.16 * dot(step_, step_) +
                blur.source * blur.source);
}

LayersView layersView(OpeningGrating g, OpeningView v) {
    LayersView near;
    near.row = LayerRow(tables[g.layers], tables[g.layers + 1u], tables[g.layers + 2u], tables[g.layers + 3u],
                        tables[g.layers + 4u], tables[g.layers + 5u], tables[g.layers + 6u], tables[g.layers + 7u],
                        tables[g.layers + 8u], tables[g.layers + 9u], tables[g.layers + 10u]);
    float curvature = v.nearness - g.convergence;
    near.towards = curvature < 0.0 ? -1.0 : 1.0;
    near.image = 2e-6 * near.row.half_um * abs(curvature);
    near.number = 0.5 * near.row.half_um * near.image;
    // From one wavenumber of the list to the next the image stays where it is, and only the fringes around go on.
    OpeningView past = v;
    past.uv *= LAYER_STRETCH / (near.number * MIDDLE_WAVENUMBER + LAYER_STRETCH);
    // Fringes of light from opposite corners are too weak to be seen.
    near.blur = roundBlur(cellBlur(g, past, mat2(near.row.pixel_um), 0.5 * near.row.across));
    return near;
}

// From so far off that only means count, fringes and spokes are those of the far field, but as wide as the rims that they
// come from, half the image on the whole.
OpeningView besideImage(OpeningView v, LayersView near) {
    mat2 p = v.perPixel;
    bool isStraight = abs(p[0].x * p[1].y) >= abs(p[0].y * p[1].x);
    vec2 first = isStraight ? vec2(p[0].x, p[1].y) : vec2(p[0].y, p[1].x);
    first += 0.5 * near.image * vec2(first.x < 0.0 ? -1.0 : 1.0, first.y < 0.0 ? -1.0 : 1.0);
    v.perPixel = isStraight ? mat2(first.x, p[0].y, p[1].x, first.y) : mat2(p[0].x, first.x, first.y, p[1].y);
    return v;
}

float layerStretch(LayersView near, float layer, float number) {
    float at = (near.row.first + LAYER_OFFSET) * exp2(layer * near.row.ratio) - LAYER_OFFSET;
    return (at + LAYER_STRETCH) / (number + LAYER_STRETCH);
}

// Relative to the far field's peak. `beyond`: the share that is not in the tables.
float layersPattern(OpeningGrating g, LayersView near, vec2 uv, float wavenumber, out float beyond) {
    float number = near.number * wavenumber;
    float place = log2((number + LAYER_OFFSET) / (near.row.first + LAYER_OFFSET)) / near.row.ratio;
    place = clamp(place, 0.0, near.row.count - 1.0);
    float layer = min(floor(place), near.row.count - 2.0);
    // Between two layers directions are those that keep their place in the image, or in the far field.
    vec2 frequency = near.towards * wavenumber * near.row.pixel_um * uv, points = vec2(near.row.points);
    beyond = smoothstep(0.38, 0.48, max(abs(frequency.x), abs(frequency.y)) * layerStretch(near, layer, number));
    float sum = 0.0;
    // A loop of no turns is left out where an `if` would not be (path.glsl).
    for (float i = 0.0; i < (beyond < 1.0 ? 2.0 : 0.0); i += 1.0) {
        float stretch = layerStretch(near, layer + i, number);
        MaskBlur blur = maskBlur(mat3x2(0.0), stretch * wavenumber * near.blur, near.row.across, points);
        uint table = g.layers + LAYER_ROW_SIZE + uint(layer + i) * uint(near.row.entries);
        float weight = i == 0.0 ? 1.0 - (place - layer) : place - layer;
        sum += weight * stretch * stretch * maskPattern(stretch * frequency, table, points, blur, true);
    }
    return (1.0 - beyond) * sum;
}

// Of a mask beyond its layers, where the image is wide beside what single fringes between the mask's pixels are apart: light
// from edges, across them, each from its own place.
float edgesPattern(LayersView near, vec2 f_per_um, float wavenumber) {
    float width = 0.55 * near.number * wavenumber / near.row.half_um;
    vec2 square = max(f_per_um * f_per_um, 0.14 / (near.row.pixel_um * near.row.pixel_um));   // where layers end
    vec2 profile = exp(-0.5 * f_per_um * f_per_um / (width * width)) * (0.398942280 / width);
    float sum = near.row.upright * profile.y / square.x + near.row.level * profile.x / square.y;
    sum += near.row.slanting * 0.318309886 * inversesqrt(square.x + square.y) / (square.x + square.y);
    return 0.0253302959 * sum;                             // 1/(4 pi^2)
}

// The share of it.
float edgesShare(LayersView near, vec2 pixel_um, float wavenumber) {
    return smoothstep(0.05, 0.2, near.number * wavenumber * max(pixel_um.x, pixel_um.y) / near.row.half_um);
}

// As nearFoot().
vec3 layersFoot(OpeningGrating g, vec3 offset) {
    float nearness = inversesqrt(dot(offset, offset)), half_ = 1e-6 * tables[g.layers + 5u];
    float curvature = nearness - g.convergence;
    if (half_ * half_ * abs(curvature) < 0.25 * MIDDLE_WAVE) return vec3(0.0);
    vec2 foot = (vec2(dot(offset, g.across), dot(offset, g.along)) * nearness - g.incoming) / curvature;
    foot *= min(half_ * inversesqrt(max(dot(foot, foot), 1e-30)), 1.0);
    return foot.x * g.across + foot.y * g.along;
}
