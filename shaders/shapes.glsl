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

// The nearer of two distances, either of which may be NO_HIT.
float nearer(float a, float b) { return a > 0.0 && (b <= 0.0 || a < b) ? a : b; }

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

float hitCylinder(Cylinder cylinder, vec3 o, vec3 d) {
    vec3 local = o - cylinder.base;
    float dz = dot(d, cylinder.axis);
    float oz = dot(local, cylinder.axis);
    vec3 dr = d - dz * cylinder.axis;
    vec3 or = local - oz * cylinder.axis;
    float squared = cylinder.radius * cylinder.radius;
    float t = NO_HIT;

    float a = dot(dr, dr);
    if (a > 1e-14) {                                       // else parallel to the axis: caps alone
        float middle = -dot(or, dr) / a;
        vec3 closest = or + middle * dr;
        float discriminant = squared - dot(closest, closest);
        if (discriminant >= 0.0) {
            float half_ = sqrt(discriminant / a);
            float near = middle - half_;
            float far = middle + half_;
            float zNear = oz + near * dz;
            float zFar = oz + far * dz;
            near = zNear >= 0.0 && zNear <= cylinder.height ? near : NO_HIT;
            far = zFar >= 0.0 && zFar <= cylinder.height ? far : NO_HIT;
            t = firstAhead(near, far);
        }
    }
    if (decided(cylinder.capped) != 0u && dz != 0.0) {
        float bottom = -oz / dz;
        float top = (cylinder.height - oz) / dz;
        vec3 atBottom = or + bottom * dr;
        vec3 atTop = or + top * dr;
        if (dot(atBottom, atBottom) <= squared) t = nearer(bottom, t);
        if (dot(atTop, atTop) <= squared) t = nearer(top, t);
    }
    return t;
}

// |r| = slope z from the apex at z = 0 to the base at z = height; the origin is first moved to the ray's closest
// approach to the apex, so that the quadratic's coefficients have the cone's own size.
float hitCone(Cone cone, vec3 o, vec3 d) {
    vec3 local = o - cone.apex;
    float shift = -dot(local, d);
    local += shift * d;
    float dz = dot(d, cone.axis);
    float oz = dot(local, cone.axis);
    vec3 dr = d - dz * cone.axis;
    vec3 or = local - oz * cone.axis;
    float k = cone.slope * cone.slope;
    float t = NO_HIT;

    float a = dot(dr, dr) - k * dz * dz;
    float b = dot(or, dr) - k * oz * dz;
    float c = dot(or, or) - k * oz * oz;
    float discriminant = b * b - a * c;
    if (discriminant >= 0.0) {
        float q = -(b + (b >= 0.0 ? 1.0 : -1.0) * sqrt(discriminant));
        float first = a != 0.0 ? q / a : NO_HIT - shift;
        float second = q != 0.0 ? c / q : first;
        float zFirst = oz + first * dz;
        float zSecond = oz + second * dz;
        first = zFirst >= 0.0 && zFirst <= cone.height ? first + shift : NO_HIT;
        second = zSecond >= 0.0 && zSecond <= cone.height ? second + shift : NO_HIT;
        t = nearer(first, second);
    }
    if (decided(cone.capped) != 0u && dz != 0.0) {
        float cap = (cone.height - oz) / dz;
        vec3 atCap = or + cap * dr;
        if (dot(atCap, atCap) <= k * cone.height * cone.height) t = nearer(cap + shift, t);
    }
    return t;
}

// Moeller and Trumbore 1997.
float hitTriangle(Triangle triangle, vec3 o, vec3 d) {
    vec3 p = cross(d, triangle.edge2);
    float determinant = dot(triangle.edge1, p);
    if (determinant == 0.0) return NO_HIT;
    vec3 local = o - triangle.vertex;
    float u = dot(local, p) / determinant;
    vec3 q = cross(local, triangle.edge1);
    float v = dot(d, q) / determinant;
    bool inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    return inside ? dot(triangle.edge2, q) / determinant : NO_HIT;
}
