// What a light sends to a point: the irradiance on the side that `normal` points to, before the shadow test, with the way to
// the light. Area lights and the environment are sampled by one point or direction per call.

struct Incident {
    vec3 direction;    // unit, towards the light
    float distance;    // to where the shadow ray ends
    float irradiance;  // 0 where the light does not reach
};

// A point uniform on the unit disc, or on the ring from sqrt(innerRatioSquared) to 1. Concentric (P. Shirley and
// K. Chiu, "A Low Distortion Map Between Disk and Square", J. Graphics Tools 2(3), 1997), so that a single sample in
// the middle of the square is the middle of the disc.
vec2 sampleRing(vec2 random, float innerRatioSquared) {
    vec2 p = 2.0 * random - 1.0;
    bool wide = abs(p.x) > abs(p.y);
    float radius = wide ? p.x : p.y;
    float ratio = radius != 0.0 ? (wide ? p.y : p.x) / radius : 0.0;
    float angle = 0.785398163 * ratio;
    float onRing = sign(radius) * sqrt(mix(innerRatioSquared, 1.0, radius * radius));
    return onRing * (wide ? vec2(cos(angle), sin(angle)) : vec2(sin(angle), cos(angle)));
}

// Two unit vectors that complete `n` to a frame (T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017).
void completeFrame(vec3 n, out vec3 t, out vec3 b) {
    float side = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (side + n.z);
    float c = n.x * n.y * a;
    t = vec3(1.0 + side * n.x * n.x * a, side * c, -side * n.x);
    b = vec3(c, side + n.y * n.y * a, -n.y);
}

Incident fromPoint(float intensity, vec3 offset, vec3 normal) {
    float squared = dot(offset, offset);
    vec3 direction = offset * inversesqrt(squared);
    return Incident(direction, sqrt(squared), intensity * (max(dot(direction, normal), 0.0) / squared));
}

Incident fromSpot(Light light, vec3 offset, vec3 normal) {
    Incident incident = fromPoint(light.emission, offset, normal);
    float cosine = -dot(incident.direction, light.direction);
    float edge = light.cosInner > light.cosOuter
                     ? smoothstep(light.cosOuter, light.cosInner, cosine)
                     : (cosine >= light.cosOuter ? 1.0 : 0.0);
    incident.irradiance *= edge;
    return incident;
}

// Area-sampled: radiance cos cos' A / r^2.
Incident fromFlatArea(Light light, vec3 point, vec3 offset, vec3 normal) {
    vec3 toPoint = offset + point;
    float squared = dot(toPoint, toPoint);
    vec3 direction = toPoint * inversesqrt(squared);
    float cosine = -dot(direction, light.direction);
    if (decided(light.twoSided) != 0u) cosine = abs(cosine);
    float irradiance = light.emission * (max(cosine, 0.0) * max(dot(direction, normal), 0.0) * light.area / squared);
    return Incident(direction, sqrt(squared), irradiance);
}

// Sampled over the cone of directions that the sphere fills; from inside, over its surface.
Incident fromSphere(Light light, vec3 offset, vec3 normal, vec2 random) {
    float squared = dot(offset, offset);
    float radiusSquared = light.radius * light.radius;
    vec3 direction;
    float distance_;
    float irradiance;
    if (squared > radiusSquared) {
        float sinMax2 = radiusSquared / squared;
        float oneMinusCosMax = sinMax2 / (1.0 + sqrt(1.0 - sinMax2));   // 1 - cos without cancellation
        float cosine = 1.0 - random.x * oneMinusCosMax;
        float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
        vec3 axis = offset * inversesqrt(squared);
        vec3 t, b;
        completeFrame(axis, t, b);
        float angle = 6.28318531 * random.y;
        direction = axis * cosine + (t * cos(angle) + b * sin(angle)) * sine;
        float along = dot(offset, direction);
        vec3 closest = offset - along * direction;         // squared - along^2 would lose digits
        distance_ = along - sqrt(max(radiusSquared - dot(closest, closest), 0.0));
        irradiance = light.emission * (6.28318531 * oneMinusCosMax * max(dot(direction, normal), 0.0));
    } else {
        float z = 1.0 - 2.0 * random.x;
        float ring = sqrt(max(1.0 - z * z, 0.0));
        float angle = 6.28318531 * random.y;
        vec3 outward = vec3(ring * cos(angle), ring * sin(angle), z);
        vec3 toPoint = offset + light.radius * outward;
        float distanceSquared = dot(toPoint, toPoint);
        direction = toPoint * inversesqrt(distanceSquared);
        distance_ = sqrt(distanceSquared);
        float inside = decided(light.twoSided) != 0u ? abs(dot(direction, outward)) : 0.0;
        irradiance = light.emission *
                     (inside * max(dot(direction, normal), 0.0) * 12.5663706 * radiusSquared / distanceSquared);
    }
    return Incident(direction, distance_, irradiance);
}

// Cosine-weighted over the hemisphere: the estimate is pi times the radiance.
Incident fromEnvironment(float radiance, vec3 normal, vec2 random) {
    vec2 disc = sampleRing(random, 0.0);
    vec3 t, b;
    completeFrame(normal, t, b);
    vec3 direction = t * disc.x + b * disc.y + normal * sqrt(max(1.0 - dot(disc, disc), 0.0));
    return Incident(direction, INFINITY, radiance * 3.14159265);
}

Incident incidentLight(Light light, vec3 position, vec3 normal, vec2 random) {
    vec3 offset = light.position - position;
    if (HAS_POINT_LIGHTS != 0u && decided(light.kind) == POINT_LIGHT) return fromPoint(light.emission, offset, normal);
    if (HAS_SPOT_LIGHTS != 0u && decided(light.kind) == SPOT_LIGHT) return fromSpot(light, offset, normal);
    if (HAS_DIRECTIONAL_LIGHTS != 0u && decided(light.kind) == DIRECTIONAL_LIGHT) {
        vec2 disc = light.radius * sampleRing(random, 0.0);
        vec3 t, b;
        completeFrame(-light.direction, t, b);
        vec3 direction = t * disc.x + b * disc.y - light.direction * sqrt(1.0 - dot(disc, disc));
        return Incident(direction, INFINITY, light.emission * max(dot(direction, normal), 0.0) * inversesqrt(1.0 - dot(disc, disc)));
    }
    if (HAS_RECTANGLE_LIGHTS != 0u && decided(light.kind) == RECTANGLE_LIGHT) {
        return fromFlatArea(light, (2.0 * random.x - 1.0) * light.u + (2.0 * random.y - 1.0) * light.v, offset, normal);
    }
    if (HAS_DISC_LIGHTS != 0u && decided(light.kind) == DISC_LIGHT) {
        vec2 ring = sampleRing(random, light.innerRatioSquared);
        return fromFlatArea(light, ring.x * light.u + ring.y * light.v, offset, normal);
    }
    if (HAS_SPHERE_LIGHTS != 0u && decided(light.kind) == SPHERE_LIGHT) return fromSphere(light, offset, normal, random);
    return fromEnvironment(light.emission, normal, random);
}
