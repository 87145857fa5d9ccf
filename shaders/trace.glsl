// Rays through the whole scene: the nearest hit with what shading needs of it, and the shadow test.
// A primitive type that the scene lacks leaves no loop behind (specialisation constants).

const float INFINITY = 1e30;

const uint PLANE = 0u;
const uint RECTANGLE = 1u;
const uint DISC = 2u;
const uint SPHERE = 3u;
const uint BOX = 4u;
const uint CYLINDER = 5u;
const uint CONE = 6u;
const uint TRIANGLE = 7u;
const uint NOTHING = 8u;

struct Hit {
    float t;
    uint kind;
    uint index;
};

struct Surface {
    vec3 position;
    vec3 normal;      // the shape's own: outward, or the front of a sheet
    vec3 local;       // position relative to the shape's centre, free of the world's rounding
    uint material;
};

// BODY for the first LAST of a kind that has COUNT: unrolled where there are few, a loop over all where there are many and
// no tree holds them.
#define FOR_EACH(KIND, COUNT, LAST, ARRAY, BODY)                           \
    if (COUNT <= FEW) {                                                    \
        [[unroll]] for (uint i = 0u; i < LAST; ++i) { BODY }               \
    } else if (KIND == PLANE || TREE_DEPTH == 0u) {                        \
        for (uint i = 0u; i < uint(ARRAY.length()); ++i) { BODY }          \
    }

// DO(kind, how many, how many cast shadows, array, distance to element i) for every kind.
#define FOR_EACH_KIND(DO)                                                                             \
    DO(PLANE, PLANE_COUNT, PLANE_CASTERS, planes, hitPlane(planeAt(i), o, d))                         \
    DO(RECTANGLE, RECTANGLE_COUNT, RECTANGLE_CASTERS, rectangles, hitRectangle(rectangleAt(i), o, d)) \
    DO(DISC, DISC_COUNT, DISC_CASTERS, discs, hitDisc(discAt(i), o, d))                               \
    DO(SPHERE, SPHERE_COUNT, SPHERE_COUNT, spheres, hitSphere(sphereAt(i), o, d))                     \
    DO(BOX, BOX_COUNT, BOX_COUNT, boxes, hitBox(boxAt(i), o, d))                                      \
    DO(CYLINDER, CYLINDER_COUNT, CYLINDER_COUNT, cylinders, hitCylinder(cylinderAt(i), o, d))         \
    DO(CONE, CONE_COUNT, CONE_COUNT, cones, hitCone(coneAt(i), o, d))                                 \
    DO(TRIANGLE, TRIANGLE_COUNT, TRIANGLE_CASTERS, triangles, hitTriangle(triangleAt(i), o, d))

#include "tree.glsl"

Hit nearestHit(vec3 o, vec3 d) {
    Hit hit = Hit(INFINITY, NOTHING, 0u);
#define KEEP_NEAREST(KIND, COUNT, CASTERS, ARRAY, DISTANCE) \
    FOR_EACH(KIND, COUNT, COUNT, ARRAY, float t = DISTANCE; if (t > 0.0 && t < hit.t) hit = Hit(t, KIND, i);)
    FOR_EACH_KIND(KEEP_NEAREST)
#if TREE
    if (TREE_DEPTH > 0u) hitTree(o, d, false, hit);
#endif
    return hit;
}

// Whether anything lies between o and the point at distance tMax.
bool occluded(vec3 o, vec3 d, float tMax) {
    if (HAS_SHADOWS == 0u) return false;
    bool blocked = false;
#define NOTE_BLOCKER(KIND, COUNT, CASTERS, ARRAY, DISTANCE) \
    FOR_EACH(KIND, COUNT, CASTERS, ARRAY, float t = DISTANCE; blocked = blocked || (t > 0.0 && t < tMax);)
    FOR_EACH_KIND(NOTE_BLOCKER)
#if TREE
    if (TREE_DEPTH > 0u) {
        Hit blocker = Hit(blocked ? 0.0 : tMax, PLANE, 0u);
        hitTree(o, d, true, blocker);
        blocked = blocker.t < tMax;
    }
#endif
    return blocked;
}

// The point on a flat shape: what rounding put beside its plane is taken back.
Surface flatSurface(vec3 center, vec3 normal, uint material, vec3 o, vec3 d, float t) {
    vec3 local = (o - center) + t * d;
    local -= normal * dot(normal, local);
    return Surface(center + local, normal, local, material);
}

vec3 boxNormal(Box box, vec3 local) {
    vec3 p = boxCoordinates(box, local);
    vec3 size = abs(p);
    vec3 axis = size.x >= size.y && size.x >= size.z ? box.uDual * p.x
              : size.y >= size.z ? box.vDual * p.y : box.wDual * p.z;
    return normalize(axis);
}

// `local` is relative to the base. A cap is hit where z is at an end, nearer than the wall is to the radius.
vec3 cylinderNormal(Cylinder cylinder, vec3 local) {
    float z = dot(local, cylinder.axis);
    vec3 radial = local - z * cylinder.axis;
    float fromEnd = min(abs(z), abs(cylinder.height - z));
    if (decided(cylinder.capped) != 0u && fromEnd < abs(cylinder.radius - length(radial))) {
        return z > 0.5 * cylinder.height ? cylinder.axis : -cylinder.axis;
    }
    return normalize(radial);
}

// `local` is relative to the apex.
vec3 coneNormal(Cone cone, vec3 local) {
    float z = dot(local, cone.axis);
    vec3 radial = local - z * cone.axis;
    float r = length(radial);
    if (decided(cone.capped) != 0u && abs(cone.height - z) < abs(cone.slope * z - r)) return cone.axis;
    return normalize((r > 0.0 ? radial / r : vec3(0.0)) - cone.slope * cone.axis);
}

Surface surfaceAt(Hit hit, vec3 o, vec3 d) {
    if (PLANE_COUNT > 0u && hit.kind == PLANE) {
        Plane plane = planeAt(hit.index);
        return flatSurface(plane.point, plane.normal, plane.material, o, d, hit.t);
    }
    if (RECTANGLE_COUNT > 0u && hit.kind == RECTANGLE) {
        Rectangle rectangle = rectangleAt(hit.index);
        vec3 normal = normalize(cross(rectangle.uDual, rectangle.vDual));
        return flatSurface(rectangle.center, normal, rectangle.material, o, d, hit.t);
    }
    if (DISC_COUNT > 0u && hit.kind == DISC) {
        Disc disc = discAt(hit.index);
        return flatSurface(disc.center, disc.normal, disc.material, o, d, hit.t);
    }
    if (SPHERE_COUNT > 0u && hit.kind == SPHERE) {
        Sphere sphere = sphereAt(hit.index);
        vec3 normal = normalize((o - sphere.center) + hit.t * d);
        vec3 local = normal * sphere.radius;
        return Surface(sphere.center + local, normal, local, sphere.material);
    }
    if (BOX_COUNT > 0u && hit.kind == BOX) {
        Box box = boxAt(hit.index);
        vec3 local = (o - box.center) + hit.t * d;
        return Surface(box.center + local, boxNormal(box, local), local, box.material);
    }
    if (CYLINDER_COUNT > 0u && hit.kind == CYLINDER) {
        Cylinder cylinder = cylinderAt(hit.index);
        vec3 local = (o - cylinder.base) + hit.t * d;
        return Surface(cylinder.base + local, cylinderNormal(cylinder, local), local, cylinder.material);
    }
    if (CONE_COUNT > 0u && hit.kind == CONE) {
        Cone cone = coneAt(hit.index);
        vec3 local = (o - cone.apex) + hit.t * d;
        return Surface(cone.apex + local, coneNormal(cone, local), local, cone.material);
    }
    Triangle triangle = triangleAt(hit.index);
    return flatSurface(triangle.vertex, triangle.normal, triangle.material, o, d, hit.t);
}

// A ray's origin just off the surface, on the side of `normal`, beyond the rounding of its position: 32 units in the
// last place of the largest coordinate in play (three operations at the world's scale, and the ray's own length).
vec3 leave(vec3 position, vec3 normal, float travelled) {
    vec3 size = abs(position);
    float scale = max(max(size.x, size.y), max(size.z, travelled));
    return position + normal * (scale * 4e-6);
}
