// Radiance along a camera ray: direct light at diffuse surfaces, mirrors and glass followed to scene.frame.maxDepth.
// Glass splits a path in two; the branch not followed at once waits on a stack. Without glass there is no stack,
// without mirrors no second ray.

// A waiting branch whose throughput is less than this is dropped: an eighth of the smallest 8-bit step.
const float LEAST_THROUGHPUT = 1.0 / 4096.0;

struct Path {
    vec3 origin;
    vec3 direction;
    vec3 throughput;
    uint depth;         // mirror and glass surfaces passed so far
};

// Everything that a sample accumulates on its way.
struct Sample {
    vec3 radiance;
    bool nonFinite;
    uint pixelSeed;
    uint index;
    uint dimension;     // next free pair of the sample pattern
};

// Which of 32 lights from `first` on may reach the point, a bit each: gratings drop out by their hemisphere and band.
// This loop is cheap and the same for all invocations, the one over the bits is costly and runs as often as the
// invocation with most bits needs: SIMD drivers execute both sides of an `if`, but leave a loop when all are done.
uint candidates(uint first, vec3 position) {
    uint lightsHere = lightCount();
    uint bits = 0u;
    if (LIGHT_COUNT <= FEW && GRATING_COUNT <= FEW) {          // all in the first 32, at constant places
        bits = (1u << LIGHT_COUNT) - 1u;
        [[unroll]] for (uint i = 0u; i < GRATING_COUNT; ++i) {
            if (reachesBand(gratingAt(i), position)) bits |= 1u << (LIGHT_COUNT + i);
        }
    } else {
        uint last = min(lightsHere + gratingCount(), first + 32u);
        for (uint i = first; i < min(last, lightsHere); ++i) bits |= 1u << (i - first);
        for (uint i = max(first, lightsHere); i < last; ++i) {
            if (reachesBand(gratingAt(i - lightsHere), position)) bits |= 1u << (i - first);
        }
    }
    return bits;
}

// Light i at a diffuse surface, unless something is in the way. Gratings give their value as it is (thesis model);
// others go through the Lambertian BRDF.
void addLight(uint i, Surface surface, vec3 normal, float travelled, vec3 brdf, vec3 throughput,
              inout Sample sample_) {
    vec3 direction;
    float distance_;
    vec3 value;
    bool nonFinite = false;
    if (GRATING_COUNT > 0u && i >= lightCount()) {
        ThesisGrating grating = gratingAt(i - lightCount());
        vec3 offset = surface.position - grating.position;
        value = thesisGratingValue(grating, offset, nonFinite);
        distance_ = length(offset);
        direction = -offset / distance_;
    } else if (LIGHT_COUNT > 0u) {
        vec2 random = vec2(0.5);
        if (HAS_SEVERAL_SAMPLES != 0u) {
            random = samplePair(sample_.pixelSeed, sample_.index, sample_.dimension + i);
        }
        Incident incident = incidentLight(lightAt(i), surface.position, normal, random);
        value = brdf * incident.irradiance;
        distance_ = incident.distance;
        direction = incident.direction;
    }
    vec3 side = dot(direction, normal) >= 0.0 ? normal : -normal;
    // The last 1e-4 of the way is the light's own surface.
    bool lit = max(max(value.x, value.y), value.z) > 0.0 || nonFinite;
    if (lit && !occluded(leave(surface.position, side, travelled), direction, distance_ * 0.9999)) {
        sample_.radiance += throughput * value;
        sample_.nonFinite = sample_.nonFinite || nonFinite;
    }
}

void addDirectLight(Surface surface, vec3 normal, float travelled, vec3 reflectance, vec3 throughput,
                    inout Sample sample_) {
    if (LIGHT_COUNT == 0u && GRATING_COUNT == 0u) return;
    uint count = lightCount() + gratingCount();
    for (uint first = 0u; first < count; first += 32u) {
        for (uint bits = candidates(first, surface.position); bits != 0u; bits &= bits - 1u) {
            addLight(first + uint(findLSB(bits)), surface, normal, travelled, reflectance * 0.318309886, throughput,
                     sample_);
        }
    }
    sample_.dimension += lightCount();
}

void tracePath(Path path, inout Sample sample_) {
    Path waiting[MAX_DEPTH + 1u];
    uint waitingCount = 0u;

    for (;;) {
        bool alive = false;
        Hit hit = nearestHit(path.origin, path.direction);
        if (hit.kind == NOTHING) {
            if (HAS_ENVIRONMENT != 0u) sample_.radiance += path.throughput * scene.frame.environment;
        } else {
            Surface surface = surfaceAt(hit, path.origin, path.direction);
            Material material = materialAt(surface.material);
            uint kind = decided(material.kind);
            float facing = dot(path.direction, surface.normal);
            vec3 normal = facing < 0.0 ? surface.normal : -surface.normal;   // towards the eye

            if (HAS_DIFFUSE != 0u && kind == DIFFUSE) {
                addDirectLight(surface, normal, hit.t, material.color, path.throughput, sample_);
            } else if (HAS_EMITTERS != 0u && kind == EMISSIVE) {
                if (facing < 0.0 || decided(floatBitsToUint(material.second.x)) != 0u) sample_.radiance += path.throughput * material.color;
            } else if (HAS_DIELECTRICS != 0u && kind == DIELECTRIC) {
                alive = path.depth < MAX_DEPTH;
                if (alive) {
                    float eta = facing < 0.0 ? material.color.x : 1.0 / material.color.x;
                    float cosTransmitted;
                    float reflectance = fresnelDielectric(abs(facing), eta, cosTransmitted);
                    vec3 reflected = path.direction + 2.0 * abs(facing) * normal;
                    vec3 refracted = path.direction / eta + (abs(facing) / eta - cosTransmitted) * normal;
                    Path reflection = Path(leave(surface.position, normal, hit.t), normalize(reflected),
                                           path.throughput * reflectance, path.depth + 1u);
                    Path refraction = Path(leave(surface.position, -normal, hit.t), normalize(refracted),
                                           path.throughput * (1.0 - reflectance), path.depth + 1u);
                    if (reflectance < 1.0) {
                        vec3 size = reflection.throughput;
                        if (max(max(size.x, size.y), size.z) >= LEAST_THROUGHPUT) waiting[waitingCount++] = reflection;
                        path = refraction;
                    } else {
                        path = reflection;
                    }
                    vec3 size = path.throughput;
                    alive = max(max(size.x, size.y), size.z) >= LEAST_THROUGHPUT;
                }
            } else if (HAS_CONDUCTORS != 0u || HAS_THESIS_DISCS != 0u) {
                vec3 reflectance;
                if (HAS_THESIS_DISCS != 0u && kind == THESIS_DISC) {
                    bool nonFinite = false;
                    vec3 pattern = thesisDiscValue(material.aperture, surface.local, surface.normal,
                                                   path.direction, nonFinite);
                    sample_.radiance += path.throughput * material.color * pattern;
                    sample_.nonFinite = sample_.nonFinite || nonFinite;
                    reflectance = vec3(material.second.x);
                } else {
                    reflectance = fresnelConductor(abs(facing), material.color, material.second);
                }
                alive = path.depth < MAX_DEPTH;
                path.direction += 2.0 * abs(facing) * normal;
                path.direction = normalize(path.direction);
                path.origin = leave(surface.position, normal, hit.t);
                path.throughput *= reflectance;
                path.depth += 1u;
            }
        }
        if (!alive) {
            if (HAS_DIELECTRICS == 0u || waitingCount == 0u) break;
            path = waiting[--waitingCount];
        }
    }
}
