// Lattices whose cells a Gaussian beam lights unevenly (docs/theory.md, "Uneven light"). In the far field the orders are the
// transform of the cells' amplitudes, looked up as a mask's; nearer they are images of the beam. Where the lattice reaches
// past the beam both are the same Gaussian.

struct UnevenLattice {
    mat2 perTurn;        // 1 / um: turns from cell to cell, over the wavenumber, become direction cosines
    float isImage;       // 0 to 1
    BeamSpot spot;
    CellBlur blur;
};

UnevenLattice unevenLatticeOf(OpeningGrating g, OpeningView v) {
    UnevenLattice lattice;
    mat2 cell_um = mat2(g.first_um.xy, g.second_um.xy);
    lattice.perTurn = inverse(cell_um);
    lattice.blur = cellBlur(g, v, cell_um, length(g.counts));
    lattice.spot = beamSpotOf(g, v);
    // What of the lattice is lit, as wide as the wave's phase is curved across.
    vec2 lit_um = min(g.counts * vec2(length(cell_um[0]), length(cell_um[1])), 2.0 * g.beamRadius_um);
    float wide_um = max(lit_um.x, lit_um.y);
    lattice.isImage = g.cellsSize.x == 0.0 ? 1.0 : smoothstep(0.5, 1.0, wide_um * wide_um * lattice.spot.curvature * MIDDLE_WAVENUMBER);
    return lattice;
}

// Of a normal distribution's power up to `x` standard deviations: error 2e-4.
vec2 normalUpTo(vec2 x) { return 0.5 + 0.5 * tanh(0.797884561 * (x + 0.044715 * x * x * x)); }

// The beam's image around an order, `away` from it. Where the lattice ends within the beam the image does: what of it lands
// here, blurred, comes from a part about as wide as the blur or the image, whichever is less.
float orderImage(OpeningGrating g, UnevenLattice lattice, vec2 away, float wavenumber) {
    float value = g.imagePeak * spotPattern(g, lattice.spot, away, wavenumber);
    if (g.cellsSize.x > 0.0) {
        mat2 edge = spotEdge(g, lattice.spot, wavenumber);
        float image = g.beamRadius_um * lattice.spot.curvature, blur = 0.5 * (edge[0][0] + edge[1][1]);
        float share = image * image / (image * image + blur);
        mat2 rows = transpose(lattice.perTurn);
        vec2 cells = share * (away * rows) / lattice.spot.curvature;
        vec2 width = 0.5 * sqrt(share * blur) / lattice.spot.curvature * vec2(length(rows[0]), length(rows[1]));
        vec2 lit = normalUpTo((0.5 * g.counts - cells) / width) - normalUpTo((-0.5 * g.counts - cells) / width);
        value *= lit.x * lit.y;
    }
    return value;
}

float unevenFactor(OpeningGrating g, UnevenLattice lattice, vec2 past, float wavenumber) {
    float far = 0.0, image = 0.0;
    // Loops of no turns are left out where an `if` would not be (path.glsl).
    for (uint i = 0u; i < (lattice.isImage < 1.0 ? 1u : 0u); ++i)
        far = maskPattern(past, g.cells, g.cellsSize, blurAt(lattice.blur, wavenumber, length(g.counts), g.cellsSize), false);
    for (uint i = 0u; i < (lattice.isImage > 0.0 ? 1u : 0u); ++i)
        image = orderImage(g, lattice, past * lattice.perTurn / wavenumber, wavenumber);
    return mix(far, image, lattice.isImage);
}

// How far from the direction asked for a cell's pattern is to be taken: the light around an order, as far as the beam and not
// the lattice's ends shape it, has the order's.
vec2 cellShift(OpeningGrating g, UnevenLattice lattice, vec2 past, float wavenumber) {
    vec2 follow = vec2(1.0);
    if (g.cellsSize.x > 0.0) {
        vec2 lobe = past * g.cellsWidth;
        float square = dot(lobe, lobe);
        follow = mix(g.cellsFollow / (1.0 + square * square), follow, lattice.isImage);
    }
    return (follow * past) * lattice.perTurn / wavenumber;
}
