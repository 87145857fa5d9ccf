// What an optical disc throws onto a matt surface of the light of lamps: the rainbows on the walls (docs/optical-discs.md).
// Of a lamp S the disc's point Q = (r, phi) sends order m to the surface point W where with D = s_out - s_in
//   D.radial = m wavelength/pitch,  D.along = 0.
// The second equation is a curve on the disc that all orders and wavelengths share. Along it, over r, the irradiance is the
// integral of E_plane cos_out cos_W / rho_W^2 r / |d(D.along)/d phi| sum over m of eta_m (pitch/m) S(u pitch/m).

// Steps over the data's radius: with 1.6 um and half a metre 2 nm of the spectrum each.
const uint RADII = 48u;
const uint RADII_PER_SHADOW_RAY = 6u;

struct CastingDisc {
    vec3 center;
    vec3 normal;
    float radius;
    uint disc;
};

CastingDisc castingDiscAt(uint i) {
    uint at = scene.frame.castingDiscs + 8u * i;
    return CastingDisc(tableColor(at), tableColor(at + 3u), tables[at + 6u], uint(tables[at + 7u]));
}

// A lamp as one point of it, relative to the disc's centre, and what it sends there.
struct LampPoint {
    vec3 place;          // or the direction to parallel light
    bool isParallel;
    float intensity;     // times cosine over squared distance: irradiance of the disc's plane; of parallel light, times cosine
};

float distanceTo(LampPoint lamp, vec3 q) { return lamp.isParallel ? 1.0 : distance(lamp.place, q); }
vec3 directionTo(LampPoint lamp, vec3 q) { return lamp.isParallel ? lamp.place : normalize(lamp.place - q); }

// The radial direction at which the curve has radius `r`; two of them, by `side`. A fixed point: at it, the cosines along the
// track of both ways cancel, if the distances are what they are there.
vec3 radialAt(LampPoint lamp, vec3 w, vec3 normal, float r, float side) {
    vec3 wInPlane = w - normal * dot(w, normal), lampInPlane = lamp.place - normal * dot(lamp.place, normal);
    vec3 q = vec3(0.0), radial = vec3(0.0);
    for (uint i = 0u; i < 8u; ++i) {
        vec3 sum = wInPlane / distance(w, q) + lampInPlane / distanceTo(lamp, q);
        float squared = dot(sum, sum);
        if (squared > 1e-12) radial = sum * (side * inversesqrt(squared));
        q = r * radial;
    }
    return radial;
}

// Irradiance of a surface at `w`, relative to the disc's centre, with normal `facing`, times reflectance row `reflectance`: XYZ.
vec3 fromCastingDisc(CastingDisc caster, OpticalDisc disc, LampPoint lamp, vec3 w, vec3 facing, uint spectrum,
                     uint reflectance, float jitter) {
    vec3 n = caster.normal;
    vec3 sum = vec3(0.0);
    float scale = max(max(abs(caster.center.x), abs(caster.center.y)), max(abs(caster.center.z), length(w)));
    vec3 lift = n * (scale * 4e-6);

    float inner = sqrt(disc.innerRadiusSquared), outer = min(sqrt(disc.outerRadiusSquared), caster.radius);
    float dr = (outer - inner) / float(RADII);
    for (uint i = 0u; i < 2u * RADII; ++i) {
        float side = i < RADII ? 1.0 : -1.0;
        float r = inner + (float(i < RADII ? i : i - RADII) + jitter) * dr;
        vec3 radial = radialAt(lamp, w, n, r, side);
        vec3 q = r * radial;
        vec3 along = cross(n, radial);
        vec3 toW = w - q;
        float wNear = inversesqrt(dot(toW, toW));
        toW *= wNear;
        vec3 toLamp = directionTo(lamp, q);
        float lampNear = lamp.isParallel ? 0.0 : 1.0 / distanceTo(lamp, q);
        vec2 out_ = vec2(dot(toW, radial), dot(toW, along)), in_ = vec2(dot(toLamp, radial), dot(toLamp, along));
        float cosOut = dot(toW, n), cosIn = dot(toLamp, n), cosW = -dot(toW, facing);
        if (cosOut <= 0.0 || cosIn <= 0.0 || cosW <= 0.0 || r > outer) continue;

        float acrossAcross = -(1.0 - out_.x * out_.x) * wNear - (1.0 - in_.x * in_.x) * lampNear;
        float acrossAlong = out_.x * out_.y * wNear + in_.x * in_.y * lampNear;
        float alongAlong = -(1.0 - out_.y * out_.y) * wNear - (1.0 - in_.y * in_.y) * lampNear;
        float turning = r * alongAlong - out_.x - in_.x;
        turning = turning < 0.0 ? min(turning, -1e-3) : max(turning, 1e-3);   // 0 on the caustic
        float slope = acrossAcross - r * acrossAlong * acrossAlong / turning;
        float half_ = 0.5 * abs(slope) * dr + 1e-6;

        TrackView view;
        view.out_ = out_;
        view.cosOut = cosOut;
        vec3 orders = diffractedOrders(disc, view, Chord(in_.x, half_, 1.0), spectrum, reflectance);
        if (orders.y <= 0.0) continue;
        float irradiance = lamp.intensity * cosIn * (lamp.isParallel ? 1.0 : lampNear * lampNear);
        vec3 value = orders * (irradiance * cosOut * cosW * wNear * wNear * r * dr / (abs(turning) * 2.0 * half_));
        vec3 origin = caster.center + q + lift;
        if (!occluded(origin, toW, 0.9999 / wNear) && !occluded(origin, toLamp, lamp.isParallel ? INFINITY : 0.9999 / lampNear)) {
            sum += value;
        }
    }

    // The mirror's own patch of light, from behind the disc.
    vec3 image = lamp.place - 2.0 * dot(lamp.place, n) * n;
    vec3 toImage = lamp.isParallel ? image : image - w;
    vec3 q = w - toImage * (dot(w, n) / dot(toImage, n));
    float squared = dot(q, q);
    if (squared < caster.radius * caster.radius && squared > disc.hubRadiusSquared) {
        float far = lamp.isParallel ? 1.0 : dot(toImage, toImage);
        vec3 toQ = normalize(toImage);
        vec3 radial = normalize(q);
        float cosine = abs(dot(toQ, n)), cosW = dot(toQ, facing);
        uint colors = colorsOf(spectrum, reflectance);
        vec3 color = vec3(0.0);
        [[dont_unroll]] for (uint k = 0u; k < BANDS; ++k) {
            vec2 out_ = vec2(dot(toQ, radial), dot(toQ, cross(n, radial)));
            color += inBand(k) * undeviatedShare(disc, out_, cosine, k, isOnTrack(disc, squared)) *
                     bandColor(colors, k);
        }
        vec3 origin = caster.center + q + lift;
        if (cosW > 0.0 && !occluded(origin, -toQ, 0.9999 * distance(w, q)) &&
            !occluded(origin, directionTo(lamp, q), lamp.isParallel ? INFINITY : 0.9999 * distanceTo(lamp, q))) {
            sum += color * (lamp.intensity * cosW / far);
        }
    }
    return sum;
}
