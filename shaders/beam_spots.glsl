// Gaussian beams that pass an opening whole, or make an order of a lattice: spots that are Gaussian at any distance
// (docs/theory.md, "Uneven light"). Widths are given in direction cosines, where the irradiance is 1/e^2, and squared; of
// blurs as products of their sides.

struct BeamSpot {
    mat2 spread;         // of the beam's image, as the wave is curved across the beam, and of the source
    mat2 pixel;
    mat2 step_;          // of the list, at a wavenumber of 1
    float curvature;     // 1 / um
};

// A spot finer than a pixel, or than a step of the list, becomes as wide as that, so that what its neighbours show sums up to
// the same power, to 2 %.
mat2 spotBlur(vec2 side, float spread) { return smoothstep(0.02, 0.4, dot(side, side) / spread) * outerProduct(side, side); }

float farSpread(OpeningGrating g, float wavenumber) {
    float angle = 0.318309886 / (wavenumber * g.beamRadius_um);
    return angle * angle;
}

BeamSpot beamSpotOf(OpeningGrating g, OpeningView v) {
    BeamSpot spot;
    spot.curvature = 1e-6 * abs(v.nearness - g.convergence);
    float image = g.beamRadius_um * spot.curvature;
    vec2 out_ = v.uv + g.incoming;                         // the curvature is less along the slant
    mat2 slant = mat2(1.0) - (2.0 - dot(out_, out_)) * outerProduct(out_, out_);
    spot.spread = image * image * slant + mat2(g.sourceBlur * g.sourceBlur);
    float whole = image * image + g.sourceBlur * g.sourceBlur + farSpread(g, MIDDLE_WAVENUMBER);
    spot.pixel = spotBlur(v.perPixel[0], whole) + spotBlur(v.perPixel[1], whole);
    vec2 step_ = v.uv * (g.wavenumberStep / MIDDLE_WAVENUMBER);
    spot.step_ = MIDDLE_WAVENUMBER * MIDDLE_WAVENUMBER * spotBlur(step_, whole);
    return spot;
}

// All but the spread of the beam's image and the source.
mat2 spotEdge(OpeningGrating g, BeamSpot spot, float wavenumber) {
    return mat2(farSpread(g, wavenumber)) + spot.pixel + spot.step_ / (wavenumber * wavenumber);
}

// Relative to the peak of the far field, `away` from the middle.
float spotPattern(OpeningGrating g, BeamSpot spot, vec2 away, float wavenumber) {
    mat2 spread = spotEdge(g, spot, wavenumber) + spot.spread;
    return farSpread(g, wavenumber) * exp(-2.0 * dot(away, inverse(spread) * away)) * inversesqrt(determinant(spread));
}
