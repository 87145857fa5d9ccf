// What a light source is to a point of an optical disc, of whose track each wavelength shows another place of the source: the
// chord that a line through the source cuts out, in direction cosines (disc.glsl).

// A point of the disc and the eye's way to it.
struct TrackView {
    vec3 radial;
    vec3 along;          // the track
    float radius;
    vec3 toEye;
    vec2 out_;           // its cosines with radial and along
    float cosOut;
    vec3 pixelA;         // shifts on the disc from a sample to its neighbours
    vec3 pixelB;
    float eyeNearness;   // 1 / distance; 0 where rays to the eye are parallel
};

// `local`: from the disc's centre; `pixel`: width of what the sample sees.
TrackView trackView(vec3 local, vec3 normal, vec3 direction, float distance_, float pixel) {
    TrackView v;
    v.radius = length(local);
    v.radial = local / v.radius;
    v.along = cross(normal, v.radial);
    v.toEye = -direction;
    v.out_ = vec2(dot(v.toEye, v.radial), dot(v.toEye, v.along));
    v.cosOut = dot(v.toEye, normal);
    vec3 slope = v.toEye - v.cosOut * normal;
    float steepness = dot(slope, slope);
    vec3 uphill = steepness > 1e-12 ? slope * inversesqrt(steepness) : v.radial;
    v.pixelA = uphill * (pixel / max(v.cosOut, 1e-3));
    v.pixelB = cross(normal, uphill) * pixel;
    v.eyeNearness = IS_ORTHOGRAPHIC != 0u ? 0.0 : 1.0 / distance_;
    return v;
}

// How much the sum of both ways' cosines changes with a shift on the disc: the ways turn, and so does the track.
vec2 changeOverPixel(TrackView v, vec3 shift, vec3 toLight, float lightNearness) {
    vec3 turn = -v.eyeNearness * (shift - v.toEye * dot(v.toEye, shift)) - lightNearness * (shift - toLight * dot(toLight, shift));
    vec3 both = v.toEye + toLight;
    float angle = dot(shift, v.along) / v.radius;
    return vec2(dot(turn, v.radial) + dot(both, v.along) * angle, dot(turn, v.along) - dot(both, v.radial) * angle);
}

// What the line `along` = const cuts out of a source of even radiance, in cosines across the track.
struct Chord {
    float center;
    float half_;
    float radiance;      // 0: the line passes by
};

// Of a source whose image, in direction cosines about `center`, is an ellipse: half diameters whose squares sum up to its own,
// and the irradiance that it makes. The mean over the pixel, as a tent in the cosine along the track: tents of neighbouring
// pixels have the sum 1, so a source smaller than they are keeps its power.
Chord ellipseChord(TrackView v, vec2 center, vec2 a, vec2 b, vec2 pixelA, vec2 pixelB, float irradiance) {
    const float LEAST = 1e-7;                              // a tenth of a microradian: no source is a point
    float height = sqrt(a.y * a.y + b.y * b.y + LEAST * LEAST);
    float across = (a.x * b.y - a.y * b.x) / height;
    float width = sqrt(across * across + LEAST * LEAST);
    float pixelHeight = sqrt(pixelA.y * pixelA.y + pixelB.y * pixelB.y + LEAST * LEAST);
    float pixelWidth = abs(pixelA.x * pixelB.y - pixelA.y * pixelB.x) / pixelHeight;

    // Gauss's rule with three points on either side of the tent's top.
    float offset = -v.out_.y - center.y;
    float low = max(offset - pixelHeight, -height), high = min(offset + pixelHeight, height);
    if (low >= high) return Chord(0.0, 0.0, 0.0);
    float top = clamp(offset, low, high);
    float sum = 0.0, squares = 0.0, moment = 0.0;
    for (uint i = 0u; i < 6u; ++i) {
        float from = i < 3u ? low : top, to = i < 3u ? top : high;
        float node = i % 3u == 0u ? -0.774596669 : i % 3u == 1u ? 0.0 : 0.774596669;
        float weight = (i % 3u == 1u ? 0.444444444 : 0.277777778) * (to - from);
        float y = 0.5 * (from + to) + 0.5 * (to - from) * node;
        float part = y / height;
        float chord = sqrt(max(1.0 - part * part, 0.0));
        float value = weight * max(1.0 - abs(y - offset) / pixelHeight, 0.0) * chord;
        sum += value;
        squares += value * chord;
        moment += value * y;
    }
    if (sum <= 0.0) return Chord(0.0, 0.0, 0.0);
    float y = moment / sum;
    float skew = (a.x * a.y + b.x * b.y) / (height * height);
    float pixelSkew = (pixelA.x * pixelA.y + pixelB.x * pixelB.y) / (pixelHeight * pixelHeight);
    float own = width * squares / sum;
    float half_ = sqrt(own * own + 0.25 * pixelWidth * pixelWidth);
    float radiance = irradiance * 0.318309886 / height * (sum / pixelHeight) / half_;
    return Chord(center.x + skew * y + pixelSkew * (offset - y), half_, radiance);
}

vec2 cosines(TrackView v, vec3 direction) { return vec2(dot(direction, v.radial), dot(direction, v.along)); }

// Of a source that is known by its middle and two half diameters, seen from the disc.
Chord ellipseChord(TrackView v, vec3 offset, vec3 a, vec3 b, float scale, float irradiance) {
    float nearness = inversesqrt(dot(offset, offset));
    vec3 middle = offset * nearness;
    vec3 a1 = normalize(offset + a), a2 = normalize(offset - a), b1 = normalize(offset + b), b2 = normalize(offset - b);
    return ellipseChord(v, cosines(v, 0.25 * (a1 + a2 + b1 + b2)), cosines(v, (0.5 * scale) * (a1 - a2)), cosines(v, (0.5 * scale) * (b1 - b2)),
                        changeOverPixel(v, v.pixelA, middle, nearness), changeOverPixel(v, v.pixelB, middle, nearness), irradiance);
}

// Exactly, by where the edges pass through the cone of directions with the wanted cosine along the track.
Chord rectangleChord(TrackView v, vec3 normal, Light light, vec3 offset) {
    float beta = -v.out_.y;
    float betaSquared = beta * beta;
    float low = 2.0, high = -2.0;
    for (uint i = 0u; i < 4u; ++i) {
        float side = i < 2u ? 1.0 : -1.0;
        bool isU = (i & 1u) == 0u;
        vec3 from = offset + side * (light.u + (isU ? -light.v : light.v));
        vec3 edge = 2.0 * side * (isU ? light.v : -light.u);
        float pt = dot(from, v.along), et = dot(edge, v.along);
        float a = et * et - betaSquared * dot(edge, edge);
        float b = pt * et - betaSquared * dot(from, edge);
        float c = pt * pt - betaSquared * dot(from, from);
        float discriminant = b * b - a * c;
        float q = -(b + (b >= 0.0 ? 1.0 : -1.0) * sqrt(max(discriminant, 0.0)));
        for (uint k = 0u; k < 2u; ++k) {
            float place = k == 0u ? (a != 0.0 ? q / a : -1.0) : (q != 0.0 ? c / q : -1.0);
            vec3 point = from + place * edge;
            if (discriminant >= 0.0 && place >= 0.0 && place <= 1.0 && dot(point, normal) > 0.0 &&
                dot(point, v.along) * beta >= 0.0) {
                float alpha = dot(point, v.radial) * inversesqrt(dot(point, point));
                low = min(low, alpha);
                high = max(high, alpha);
            }
        }
    }
    // A part below the disc's plane is cut off at the horizon.
    for (float side = -1.0; side <= 1.0; side += 2.0) {
        float rim = side * sqrt(max(1.0 - betaSquared, 0.0));
        vec3 direction = rim * v.radial + beta * v.along;
        float approach = dot(direction, light.direction);
        float distance_ = approach != 0.0 ? dot(offset, light.direction) / approach : -1.0;
        vec3 point = distance_ * direction - offset;
        if (distance_ > 0.0 && abs(dot(point, light.u)) <= dot(light.u, light.u) && abs(dot(point, light.v)) <= dot(light.v, light.v)) {
            low = min(low, rim);
            high = max(high, rim);
        }
    }
    return high > low ? Chord(0.5 * (low + high), 0.5 * (high - low), light.emission) : Chord(0.0, 0.0, 0.0);
}

// `irradiance`: of a light without extent. `inner`: 1, or the share that a hole is of a disc-shaped light's radius.
Chord chordOf(TrackView v, vec3 normal, Light light, vec3 offset, vec3 toLight, float irradiance, float inner) {
    if (HAS_SPHERE_LIGHTS != 0u && decided(light.kind) == SPHERE_LIGHT) {
        float nearness = inversesqrt(dot(offset, offset));
        vec3 middle = offset * nearness;
        float sine = light.radius * nearness;
        vec3 a, b;
        completeFrame(middle, a, b);
        if (sine >= 1.0) return Chord(0.0, sqrt(max(1.0 - v.out_.y * v.out_.y, 0.0)), decided(light.twoSided) != 0u ? light.emission : 0.0);
        if (dot(middle, normal) <= 0.0) return Chord(0.0, 0.0, 0.0);
        // The cap's rim is a circle, and so its image an ellipse.
        float full = light.emission * (3.14159265 * sine * sine * dot(middle, normal));
        return ellipseChord(v, sqrt(1.0 - sine * sine) * cosines(v, middle), sine * cosines(v, a), sine * cosines(v, b),
                            changeOverPixel(v, v.pixelA, middle, nearness), changeOverPixel(v, v.pixelB, middle, nearness), full);
    }
    if (HAS_DISC_LIGHTS != 0u && decided(light.kind) == DISC_LIGHT) {
        vec3 a = inner * light.u, b = inner * light.v;
        float nearness = inversesqrt(dot(offset, offset));
        // What the light's disc fills of the sphere of directions, projected: as the ellipse does.
        vec2 p = cosines(v, 0.5 * (normalize(offset + a) - normalize(offset - a)));
        vec2 q = cosines(v, 0.5 * (normalize(offset + b) - normalize(offset - b)));
        return ellipseChord(v, offset, a, b, 1.0, light.emission * 3.14159265 * abs(p.x * q.y - p.y * q.x));
    }
    if (HAS_RECTANGLE_LIGHTS != 0u && decided(light.kind) == RECTANGLE_LIGHT) {
        vec2 p = cosines(v, 0.5 * (normalize(offset + light.u) - normalize(offset - light.u)));
        vec2 q = cosines(v, 0.5 * (normalize(offset + light.v) - normalize(offset - light.v)));
        float nearness = inversesqrt(dot(offset, offset));
        vec3 middle = offset * nearness;
        float pixelA = changeOverPixel(v, v.pixelA, middle, nearness).y, pixelB = changeOverPixel(v, v.pixelB, middle, nearness).y;
        // Smaller than a few pixels it may be round: with the same second moments, 1/3 of a half edge's square for 1/4.
        if (p.y * p.y + q.y * q.y < 9.0 * (pixelA * pixelA + pixelB * pixelB)) {
            return ellipseChord(v, offset, light.u, light.v, 1.15470054, light.emission * 4.0 * abs(p.x * q.y - p.y * q.x));
        }
        return rectangleChord(v, normal, light, offset);
    }
    if (HAS_ENVIRONMENT != 0u && decided(light.kind) == ENVIRONMENT_LIGHT) {
        return Chord(0.0, sqrt(max(1.0 - v.out_.y * v.out_.y, 0.0)), light.emission);
    }
    bool isParallel = HAS_DIRECTIONAL_LIGHTS != 0u && decided(light.kind) == DIRECTIONAL_LIGHT;
    float nearness = isParallel ? 0.0 : inversesqrt(dot(offset, offset));
    vec3 middle = isParallel ? -light.direction : toLight;
    float sine = isParallel ? light.radius : 0.0;
    vec3 a, b;
    completeFrame(middle, a, b);
    if (isParallel) irradiance = light.emission * max(dot(middle, normal), 0.0);
    return ellipseChord(v, sqrt(1.0 - sine * sine) * cosines(v, middle), sine * cosines(v, a), sine * cosines(v, b),
                        changeOverPixel(v, v.pixelA, middle, nearness), changeOverPixel(v, v.pixelB, middle, nearness), irradiance);
}
