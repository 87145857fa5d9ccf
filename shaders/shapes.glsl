// Ray against each analytic primitive. Every function gives the distance to the first hit with t > 0 along the unit
// direction `d` from `o`, or NO_HIT. The work happens relative to the shape's own origin, so a small shape far from
// the world's origin loses no digits.

const float NO_HIT = -1.0;

// Distance along d to the plane through the origin with this normal, of any length.
float hitPlaneAtOrigin(vec3 normal, vec3 o, vec3 d) {
    float approach = dot(normal, d);
    return approach != 0.0 ? -dot(normal, o) / approach : NO_HIT;
}

// The nearer of two roots that lies ahead.
float firstAhead(float near, float far) { return near > 0.0 ? near : (far > 0.0 ? far : NO_HIT); }

float hitPlane(Plane plane, vec3 o, vec3 d) { return hitPlaneAtOrigin(plane.normal, o - plane.point, d); }

float hitRectangle(Rectangle rectangle, vec3 o, vec3 d) {
    vec3 local = o - rectangle.center;
    float t = hitPlaneAtOrigin(cross(rectangle.uDual, rectangle.vDual), local, d);
    vec3 p = local + t * d;
    return abs(dot(p, rectangle.uDual)) <= 1.0 && abs(dot(p, rectangle.vDual)) <= 1.0 ? t : NO_HIT;
}

float hitDisc(Disc disc, vec3 o, vec3 d) {
    vec3 local = o - disc.center;
    float t = hitPlaneAtOrigin(disc.normal, local, d);
    vec3 p = local + t * d;
    float squared = dot(p, p);
    return squared <= disc.radiusSquared && squared >= disc.innerRadiusSquared ? t : NO_HIT;
}

// Discriminant from the closest approach, roots without cancellation (E. Haines et al., "Precision Improvements for
// Ray/Sphere Intersection", Ray Tracing Gems, 2019).
float hitSphere(Sphere sphere, vec3 o, vec3 d) {
    vec3 local = o - sphere.center;
    float b = -dot(local, d);
    vec3 closest = local + b * d;
    float discriminant = sphere.radius * sphere.radius - dot(closest, closest);
    if (discriminant < 0.0) return NO_HIT;
    float c = dot(local, local) - sphere.radius * sphere.radius;
    float q = b + (b >= 0.0 ? 1.0 : -1.0) * sqrt(discriminant);
    float other = q != 0.0 ? c / q : 0.0;
    return firstAhead(min(q, other), max(q, other));
}

// Coordinates in the box's own frame, where it is [-1, 1]^3.
vec3 boxCoordinates(Box box, vec3 v) { return vec3(dot(v, box.uDual), dot(v, box.vDual), dot(v, box.wDual)); }

float hitBox(Box box, vec3 o, vec3 d) {
    vec3 origin = boxCoordinates(box, o - box.center);
    vec3 direction = boxCoordinates(box, d);
    // A ray parallel to a face: any tiny slope gives the right side without 0/0.
    direction = mix(direction, vec3(1e-30), lessThan(abs(direction), vec3(1e-30)));
    vec3 toMiddle = -origin / direction;
    vec3 toFaces = abs(1.0 / direction);
    vec3 enter = toMiddle - toFaces;
    vec3 leave = toMiddle + toFaces;
    float near = max(max(enter.x, enter.y), enter.z);
    float far = min(min(leave.x, leave.y), leave.z);
    return near <= far ? firstAhead(near, far) : NO_HIT;
}

// The part of [near, far] that lies between two planes at z = 0 and z = height; near > far where there is none. A solid is
// taken as a whole, wall and caps together, or rays would slip in between the two where they meet.
vec2 betweenCaps(float near, float far, float z, float dz, float height) {
    float slope = abs(dz) < 1e-30 ? 1e-30 : dz;            // no 0/0
    float bottom = -z / slope, top = (height - z) / slope;
    return vec2(max(near, min(bottom, top)), min(far, max(bottom, top)));
}

float hitCylinder(Cylinder cylinder, vec3 o, vec3 d) {
    vec3 local = o - cylinder.base;
    float dz = dot(d, cylinder.axis);
    float oz = dot(local, cylinder.axis);
    vec3 dr = d - dz * cylinder.axis;
    vec3 or = local - oz * cylinder.axis;

    float a = dot(dr, dr);
    bool isAlong = a < 1e-14;                              // the axis: it meets the caps alone
    float middle = isAlong ? 0.0 : -dot(or, dr) / a;
    vec3 closest = or + middle * dr;
    float discriminant = cylinder.radius * cylinder.radius - dot(closest, closest);
    if (discriminant < 0.0) return NO_HIT;
    float half_ = isAlong ? 1e30 : sqrt(discriminant / a);
    float near = middle - half_;
    float far = middle + half_;
    if (decided(cylinder.capped) != 0u) {
        vec2 inside = betweenCaps(near, far, oz, dz, cylinder.height);
        return inside.x <= inside.y ? firstAhead(inside.x, inside.y) : NO_HIT;
    }
    float zNear = oz + near * dz;
    float zFar = oz + far * dz;
    near = zNear >= 0.0 && zNear <= cylinder.height ? near : NO_HIT;
    far = zFar >= 0.0 && zFar <= cylinder.height ? far : NO_HIT;
    return firstAhead(near, far);
}

// |r| = slope z from the apex at z = 0 to the base at z = height. The origin is first moved near: to where the ray passes
// the axis, or the apex if it goes along the cone, so that the coefficients have the cone's own size there.
float hitCone(Cone cone, vec3 o, vec3 d) {
    vec3 local = o - cone.apex;
    float dz = dot(d, cone.axis);
    vec3 dr = d - dz * cone.axis;
    float k = cone.slope * cone.slope;
    float a = dot(dr, dr) - k * dz * dz;
    float shift = a > 0.0 ? -dot(local - dot(local, cone.axis) * cone.axis, dr) / dot(dr, dr) : -dot(local, d);
    local += shift * d;
    float oz = dot(local, cone.axis);
    vec3 or = local - oz * cone.axis;
    float b = dot(or, dr) - k * oz * dz;
    float c = dot(or, or) - k * oz * oz;
    // b^2 - a c, without what cancels for a slender cone.
    vec3 turned = oz * dr - dz * or;
    vec3 moment = cross(or, dr);
    float discriminant = k * dot(turned, turned) - dot(moment, moment);
    if (discriminant < 0.0 && a > 0.0) return NO_HIT;
    float q = -(b + (b >= 0.0 ? 1.0 : -1.0) * sqrt(max(discriminant, 0.0)));
    float first = q / (a != 0.0 ? a : 1e-30);
    float second = q != 0.0 ? c / q : first;
    float near = min(first, second);
    float far = max(first, second);
    if (decided(cone.capped) != 0u) {
        if (a < 0.0) {                                     // along the cone: the other root is on the other side of the apex
            near = dz > 0.0 ? far : -1e30;
            far = dz > 0.0 ? 1e30 : min(first, second);
        }
        vec2 inside = betweenCaps(near, far, oz, dz, cone.height);
        return inside.x <= inside.y ? firstAhead(inside.x + shift, inside.y + shift) : NO_HIT;
    }
    float zNear = oz + near * dz;
    float zFar = oz + far * dz;
    near = zNear >= 0.0 && zNear <= cone.height ? near + shift : NO_HIT;
    far = zFar >= 0.0 && zFar <= cone.height ? far + shift : NO_HIT;
    return firstAhead(near, far);
}

// By the plane first: the quotients of Moeller and Trumbore are noise where the ray is nearly in it.
float hitTriangle(Triangle triangle, vec3 o, vec3 d) {
    vec3 local = o - triangle.vertex;
    float t = hitPlaneAtOrigin(triangle.normal, local, d);
    vec3 p = local + t * d;
    float u = dot(cross(p, triangle.edge2), triangle.normal);
    float v = dot(cross(triangle.edge1, p), triangle.normal);
    bool inside = u >= 0.0 && v >= 0.0 && u + v <= dot(cross(triangle.edge1, triangle.edge2), triangle.normal);
    return inside ? t : NO_HIT;
}
