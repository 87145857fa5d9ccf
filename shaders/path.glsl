// Radiance along a camera ray: direct light at diffuse surfaces, mirrors and glass followed to scene.frame.maxDepth.
// Glass and the hubs of discs split a path in two; the branch not followed at once waits on a stack. Without them there is
// no stack, without mirrors no second ray.

// A waiting branch whose throughput is less than this is dropped: an eighth of the smallest 8-bit step.
const float LEAST_THROUGHPUT = 1.0 / 4096.0;

struct Path {
    vec3 origin;
    vec3 direction;
    uint depth;         // mirror and glass surfaces passed so far
    float travelled;
};

// Everything that a sample accumulates on its way.
struct Sample {
    vec3 radiance;      // CIE XYZ
    bool nonFinite;
    uint pixelSeed;
    uint index;
    uint dimension;     // next free pair of the sample pattern
};

// Where light falls, and what arrives there from one light.
struct Arrival {
    vec3 value;          // of the sample, unless something is in the way
    vec3 direction;      // towards the light, unit
    float distance;
    bool nonFinite;
};

void add(Arrival arrival, Surface surface, vec3 normal, float travelled, inout Sample sample_) {
    vec3 side = dot(arrival.direction, normal) >= 0.0 ? normal : -normal;
    // The last 1e-4 of the way is the light's own surface.
    bool lit = max(max(arrival.value.x, arrival.value.y), arrival.value.z) > 0.0 || arrival.nonFinite;
    if (lit && !occluded(leave(surface.position, side, travelled), arrival.direction, arrival.distance * 0.9999)) {
        sample_.radiance += arrival.value;
        sample_.nonFinite = sample_.nonFinite || arrival.nonFinite;
    }
}

// The numbers of a sample that say which point of light i it sees.
vec2 pairOfLight(Sample sample_, uint i) {
    if (HAS_SEVERAL_SAMPLES == 0u) return vec2(0.5);
    return samplePair(sample_.pixelSeed, sample_.index, sample_.dimension + i);
}

// Light i, or a part of it, at a diffuse surface or the track of a disc.
Arrival fromLight(uint i, uint part, Surface surface, vec3 normal, Material material, TrackView view, Path path, Sample sample_) {
    vec2 random = pairOfLight(sample_, i);
    Incident incident = incidentLight(lightAt(i), surface.position, normal, random);
    vec3 value = vec3(0.0);
    if (OPTICAL_DISC_COUNT > 0u && decided(material.kind) == OPTICAL_DISC) {
        if (incident.irradiance > 0.0) {
            value = discValue(opticalDiscAt(material.row), view, normal, lightAt(i), surface.position, part, random.x, incident);
        }
    } else if (incident.irradiance > 0.0) {
        value = material.value * 0.318309886 * incident.irradiance * seen(lightAt(i).spectrum, material.row);
    }
    return Arrival(value, incident.direction, incident.distance, false);
}

// Whether every point may ask all gratings, at constant places.
#define ASKS_ALL_GRATINGS                                                                            \
    (GRATING_COUNT <= FEW && SLIT_GRATING_COUNT <= FEW && OPENING_GRATING_COUNT <= FEW &&            \
     GRATING_COUNT + SLIT_GRATING_COUNT + OPENING_GRATING_COUNT <= FEW_GRATINGS)

// Entries of the tables, or numbers of gratings where all are asked.
struct GratingList {
    uint first;
    uint end;
};

// The gratings that may reach a point. Thesis gratings come first, then slits, then other openings.
GratingList gratingsNear(vec3 position) {
    if (ASKS_ALL_GRATINGS) return GratingList(0u, GRATING_COUNT + SLIT_GRATING_COUNT + OPENING_GRATING_COUNT);
    GratingGrid grid = scene.frame.gratingGrid;
    uvec3 cell = uvec3(clamp((position - grid.low) * grid.cellsPerMetre, vec3(0.0), grid.last));
    uint list = grid.lists + uint(tables[grid.places + cell.x + cell.y * grid.perRow + cell.z * grid.perLayer]);
    return GratingList(list + 1u, list + 1u + uint(tables[list]));
}

uint gratingOf(uint entry) {
    if (ASKS_ALL_GRATINGS) return entry;
    return uint(tables[entry]);
}

bool reachesPoint(uint i, vec3 position) {
    if (OPENING_GRATING_COUNT > 0u && i >= gratingCount() + slitGratingCount())
        return reachesOpening(openingGratingAt(i - gratingCount() - slitGratingCount()), position);
    if (SLIT_GRATING_COUNT > 0u && i >= gratingCount()) return reachesSlits(slitGratingAt(i - gratingCount()), position);
    return reachesBand(gratingAt(i), position);
}

// Which of the list's next 32 gratings from `first` on may reach the point, a bit each: they drop out by their hemisphere and
// band.
// This loop is cheap and the same for all invocations, the one over the bits is costly and runs as often as the
// invocation with most bits needs: SIMD drivers execute both sides of an `if`, but leave a loop when all are done.
uint candidates(uint first, uint end, vec3 position) {
    uint bits = 0u;
    if (ASKS_ALL_GRATINGS) {
        // By their constant places, not gratingAt() and its likes: a selection among all for each is much to compile.
        [[unroll]] for (uint i = 0u; i < GRATING_COUNT; ++i) {
            if (reachesBand(scene.gratings[i], position)) bits |= 1u << i;
        }
        [[unroll]] for (uint i = 0u; i < SLIT_GRATING_COUNT; ++i) {
            if (reachesSlits(scene.slitGratings[i], position)) bits |= 1u << (GRATING_COUNT + i);
        }
        [[unroll]] for (uint i = 0u; i < OPENING_GRATING_COUNT; ++i) {
            if (reachesOpening(scene.openingGratings[i], position)) bits |= 1u << (GRATING_COUNT + SLIT_GRATING_COUNT + i);
        }
    } else {
        for (uint entry = first; entry < min(end, first + 32u); ++entry) {
            if (reachesPoint(gratingOf(entry), position)) bits |= 1u << (entry - first);
        }
    }
    return bits;
}

// Grating i at a diffuse surface. Those of the thesis give their value as it is; others go through the Lambertian BRDF.
Arrival fromGrating(uint i, Surface surface, vec3 normal, float travelled, Material material, Path path) {
    Arrival arrival;
    arrival.nonFinite = false;
    float brdf = material.value * 0.318309886;
    float pixel = scene.frame.pixelAngle * (path.travelled + travelled) + scene.frame.pixelWidth;
    vec3 from;
    if (OPENING_GRATING_COUNT > 0u && i >= gratingCount() + slitGratingCount()) {
        OpeningGrating grating = openingGratingAt(i - gratingCount() - slitGratingCount());
        vec3 offset = surface.position - grating.position;
        arrival.value = brdf * openingGratingValue(grating, offset, normal, path.direction, pixel, material.row);
        from = grating.position;
        if (HAS_NEAR_OPENINGS != 0u && decided(grating.isNear) != 0u) from += nearFoot(grating, offset);
        if (HAS_NEAR_LAYERS != 0u && decided(grating.hasLayers) != 0u) from += layersFoot(grating, offset);
    } else if (SLIT_GRATING_COUNT > 0u && i >= gratingCount()) {
        SlitGrating grating = slitGratingAt(i - gratingCount());
        vec3 offset = surface.position - grating.position;
        arrival.value = brdf * slitGratingValue(grating, offset, normal, path.direction, pixel, material.row);
        if (HAS_NAIVE_EVALUATOR != 0u) {
            arrival.nonFinite = metNonFinite;
            metNonFinite = false;
        }
        from = grating.position + clamp(viewFrom(grating, offset).footY, -grating.halfHeight, grating.halfHeight) * grating.along;
    } else {
        ThesisGrating grating = gratingAt(i);
        vec3 offset = surface.position - grating.position;
        arrival.value = xyzFromLinearSrgb(thesisGratingValue(grating, offset, arrival.nonFinite) * throughputOfPrimaries());
        from = grating.position;
    }
    vec3 way = from - surface.position;
    arrival.distance = length(way);
    arrival.direction = way / arrival.distance;
    return arrival;
}

// Light that discs send on to a matt surface.
void addCastLight(Surface surface, vec3 normal, Material material, Path path, inout Sample sample_) {
    for (uint i = 0u; i < CASTING_DISC_COUNT * lightCount(); ++i) {
        CastingDisc caster = castingDiscAt(i / lightCount());
        Light light = lightAt(i % lightCount());
        vec3 w = surface.position - caster.center;
        vec2 random = pairOfLight(sample_, i % lightCount());
        Incident incident = incidentLight(light, caster.center, caster.normal, random);
        if (dot(w, caster.normal) <= 0.0 || incident.irradiance <= 0.0 || decided(light.kind) == ENVIRONMENT_LIGHT) continue;
        bool isParallel = decided(light.kind) == DIRECTIONAL_LIGHT;
        float normalIrradiance = incident.irradiance / dot(incident.direction, caster.normal);
        LampPoint lamp = LampPoint(isParallel ? incident.direction : incident.direction * incident.distance, isParallel,
                                   isParallel ? normalIrradiance : normalIrradiance * incident.distance * incident.distance);
        vec3 irradiance = fromCastingDisc(caster, opticalDiscAt(caster.disc), lamp, w, normal, light.spectrum, material.row,
                                          random.x);
        sample_.radiance += material.value * 0.318309886 * irradiance;
    }
}

// What an optical disc's orders show of the sky.
void addSkyOrders(uint i, OpticalDisc disc, Surface surface, vec3 normal, TrackView view, float travelled, inout Sample sample_) {
    float random = pairOfLight(sample_, i).x;
    float rim = sqrt(max(1.0 - view.out_.y * view.out_.y, 0.0));
    vec3 origin = leave(surface.position, normal, travelled);
    uint open = 0u;
    for (uint part = 0u; part < SKY_PARTS; ++part) {
        float alpha = rim * (2.0 * (float(part) + random) / float(SKY_PARTS) - 1.0);
        if (!occluded(origin, skyDirection(view, normal, rim, alpha), INFINITY)) open |= 1u << part;
    }
    sample_.radiance += lightAt(i).emission * ordersOfSky(disc, view, rim, open, lightAt(i).spectrum);
}

void addDirectLight(Surface surface, vec3 normal, float travelled, Material material, Path path, inout Sample sample_) {
    bool isTrack = OPTICAL_DISC_COUNT > 0u && decided(material.kind) == OPTICAL_DISC;
    if (LIGHT_COUNT > 0u) {
        TrackView view;
        if (OPTICAL_DISC_COUNT > 0u) {
            float toEye = path.travelled + travelled;
            view = trackView(surface.local, normal, path.direction, toEye, scene.frame.pixelAngle * toEye + scene.frame.pixelWidth);
        }
        for (uint i = 0u; i < lightCount(); ++i) {
            uint parts = isTrack ? partsOf(lightAt(i)) : 1u, part = 0u;
            if (OPTICAL_DISC_COUNT > 0u && parts > 1u && seesSkyInBands(opticalDiscAt(material.row))) {
                addSkyOrders(i, opticalDiscAt(material.row), surface, normal, view, travelled, sample_);
                part = SKY_PARTS;
            }
            for (; part < parts; ++part) {
                add(fromLight(i, part, surface, normal, material, view, path, sample_), surface, normal, travelled, sample_);
            }
        }
        if (CASTING_DISC_COUNT > 0u && decided(material.kind) == DIFFUSE) addCastLight(surface, normal, material, path, sample_);
        sample_.dimension += lightCount();
    }
    if (GRATING_COUNT > 0u || SLIT_GRATING_COUNT > 0u || OPENING_GRATING_COUNT > 0u) {
        GratingList near = gratingsNear(surface.position);
        if (isTrack) near.end = near.first;                // discs diffract no light of gratings
        for (uint first = near.first; first < near.end; first += 32u) {
            for (uint bits = candidates(first, near.end, surface.position); bits != 0u; bits &= bits - 1u) {
                uint i = gratingOf(first + uint(findLSB(bits)));
                add(fromGrating(i, surface, normal, travelled, material, path), surface, normal, travelled, sample_);
            }
        }
    }
}

// A branch not followed at once, of a path with this throughput.
struct WaitingPath {
    Path path;
    Throughput throughput;
    float share;
};

void tracePath(Path path, inout Sample sample_) {
    WaitingPath waiting[MAX_DEPTH + 1u];
    uint waitingCount = 0u;

    for (;;) {
        bool alive = false;
        Hit hit = nearestHit(path.origin, path.direction);
        if (hit.kind == NOTHING) {
            if (HAS_ENVIRONMENT != 0u) {
                sample_.radiance += scene.frame.environment * seen(scene.frame.environmentSpectrum, 0u);
            }
        } else {
            Surface surface = surfaceAt(hit, path.origin, path.direction);
            Material material = materialAt(surface.material);
            uint kind = decided(material.kind);
            float facing = dot(path.direction, surface.normal);
            vec3 normal = facing < 0.0 ? surface.normal : -surface.normal;   // towards the eye

            bool isTrack = false;
            if (OPTICAL_DISC_COUNT > 0u && kind == OPTICAL_DISC) {
                OpticalDisc disc = opticalDiscAt(material.row);
                float squared = dot(surface.local, surface.local);
                isTrack = isOnTrack(disc, squared);
                if (isLabel(disc, squared, facing > 0.0)) {
                    isTrack = false;
                    kind = DIFFUSE;
                    material.kind = DIFFUSE;
                    material.row = disc.label;
                }
            }
            if ((HAS_DIFFUSE != 0u || OPTICAL_DISC_COUNT > 0u) && (kind == DIFFUSE || isTrack)) {
                addDirectLight(surface, normal, hit.t, material, path, sample_);
            }
            if (kind == DIFFUSE) {
                // the path ends
            } else if (HAS_EMITTERS != 0u && kind == EMISSIVE) {
                if (facing < 0.0 || decided(material.twoSided) != 0u) {
                    sample_.radiance += material.value * seen(material.row, 0u);
                }
            } else if (HAS_DIELECTRICS != 0u && kind == DIELECTRIC) {
                alive = path.depth < MAX_DEPTH;
                if (alive) {
                    float eta = facing < 0.0 ? material.value : 1.0 / material.value;
                    float cosTransmitted;
                    float reflectance = fresnelDielectric(abs(facing), eta, cosTransmitted);
                    vec3 reflected = path.direction + 2.0 * abs(facing) * normal;
                    vec3 refracted = path.direction / eta + (abs(facing) / eta - cosTransmitted) * normal;
                    float travelled = path.travelled + hit.t;
                    Path reflection = Path(leave(surface.position, normal, hit.t), normalize(reflected), path.depth + 1u, travelled);
                    Path refraction = Path(leave(surface.position, -normal, hit.t), normalize(refracted), path.depth + 1u, travelled);
                    if (reflectance < 1.0) {
                        if (largestThroughput() * reflectance >= LEAST_THROUGHPUT)
                            waiting[waitingCount++] = WaitingPath(reflection, throughput, reflectance);
                        scaleThroughput(1.0 - reflectance);
                        path = refraction;
                    } else {
                        path = reflection;
                    }
                    alive = largestThroughput() >= LEAST_THROUGHPUT;
                }
            } else if (OPTICAL_DISC_COUNT > 0u && kind == OPTICAL_DISC) {
                alive = path.depth < MAX_DEPTH;
                OpticalDisc disc = opticalDiscAt(material.row);
                Path mirrored = path;
                mirrored.direction = normalize(path.direction + 2.0 * abs(facing) * normal);
                mirrored.origin = leave(surface.position, normal, hit.t);
                mirrored.travelled += hit.t;
                mirrored.depth += 1u;
                float squared = dot(surface.local, surface.local);
                if (HAS_HUBS != 0u && squared < disc.hubRadiusSquared) {
                    float reflectance = clearSheet(abs(facing), disc.index);
                    if (alive && largestThroughput() * reflectance >= LEAST_THROUGHPUT)
                        waiting[waitingCount++] = WaitingPath(mirrored, throughput, reflectance);
                    scaleThroughput(1.0 - reflectance);
                    path.origin = leave(surface.position, -normal, hit.t);
                    path.travelled += hit.t;
                    path.depth += 1u;
                } else {
                    vec3 radial = surface.local * inversesqrt(squared);
                    vec2 out_ = vec2(dot(path.direction, radial), dot(path.direction, cross(normal, radial)));
                    // Downwards, as the first may stand for all.
                    [[dont_unroll]] for (uint k = BANDS; k-- > 0u;) {
                        throughput.band[k] = inBand(k) * undeviatedShare(disc, out_, abs(facing), k,
                                                                         isOnTrack(disc, squared));
                    }
                    if (BANDS > 1u) throughput.bands = BANDS;
                    path = mirrored;
                }
            } else if (HAS_CONDUCTORS != 0u || HAS_THESIS_DISCS != 0u) {
                if (HAS_THESIS_DISCS != 0u && kind == THESIS_DISC) {
                    bool nonFinite = false;
                    vec3 pattern = thesisDiscValue(material.aperture, surface.local, surface.normal,
                                                   path.direction, nonFinite);
                    pattern *= material.color * throughputOfPrimaries();
                    sample_.radiance += xyzFromLinearSrgb(pattern);
                    sample_.nonFinite = sample_.nonFinite || nonFinite;
                    scaleThroughput(material.value);
                } else {
                    // Bands are interpolated between linearly: a sixteenth of the second difference halves the error.
                    uint first = scene.frame.metals + 2u * material.row * BANDS;
                    uint last = first + 2u * (BANDS - 1u);
                    float here = fresnelConductor(abs(facing), tables[last], tables[last + 1u]);
                    float before = here;
                    // Downwards, as the first may stand for all.
                    [[dont_unroll]] for (uint k = BANDS; k-- > 0u;) {
                        uint next = first + 2u * (max(k, 1u) - 1u);
                        float after = fresnelConductor(abs(facing), tables[next], tables[next + 1u]);
                        throughput.band[k] = inBand(k) * (here - 0.0625 * (before - 2.0 * here + after));
                        before = here;
                        here = after;
                    }
                    if (BANDS > 1u) throughput.bands = BANDS;
                }
                alive = path.depth < MAX_DEPTH;
                path.direction += 2.0 * abs(facing) * normal;
                path.direction = normalize(path.direction);
                path.origin = leave(surface.position, normal, hit.t);
                path.travelled += hit.t;
                path.depth += 1u;
            }
        }
        if (!alive) {
            if ((HAS_DIELECTRICS == 0u && HAS_HUBS == 0u) || waitingCount == 0u) break;
            --waitingCount;
            path = waiting[waitingCount].path;
            throughput = waiting[waitingCount].throughput;
            scaleThroughput(waiting[waitingCount].share);
        }
    }
}
