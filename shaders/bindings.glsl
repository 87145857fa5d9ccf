// The scene as the device sees it. Arrays that a scene lacks are never read: their constant is 0.

#include "interface.h"
#include "specialisation.h"

#define DECLARE(id, name) layout(constant_id = id) const uint name = 1u;
FRINGE_SPECIALISATION(DECLARE)
#undef DECLARE

layout(scalar, set = 0, binding = 0) uniform Scene { SceneBlock scene; };
layout(scalar, set = 0, binding = 1) buffer FilmBlock { FilmPixel film[]; };
layout(scalar, set = 0, binding = 2) readonly buffer PlaneBlock { Plane planes[]; };
layout(scalar, set = 0, binding = 3) readonly buffer RectangleBlock { Rectangle rectangles[]; };
layout(scalar, set = 0, binding = 4) readonly buffer DiscBlock { Disc discs[]; };
layout(scalar, set = 0, binding = 5) readonly buffer SphereBlock { Sphere spheres[]; };
layout(scalar, set = 0, binding = 6) readonly buffer BoxBlock { Box boxes[]; };
layout(scalar, set = 0, binding = 7) readonly buffer CylinderBlock { Cylinder cylinders[]; };
layout(scalar, set = 0, binding = 8) readonly buffer ConeBlock { Cone cones[]; };
layout(scalar, set = 0, binding = 9) readonly buffer TriangleBlock { Triangle triangles[]; };
layout(scalar, set = 0, binding = 10) readonly buffer MaterialBlock { Material materials[]; };
layout(scalar, set = 0, binding = 11) readonly buffer ApertureBlock { ThesisAperture apertures[]; };
layout(scalar, set = 0, binding = 12) readonly buffer LightBlock { Light lights[]; };
layout(scalar, set = 0, binding = 13) readonly buffer GratingBlock { ThesisGrating gratings[]; };

// Element i of a kind, from where it lies.
Plane planeAt(uint i) {
    if (PLANE_COUNT <= FEW) return scene.planes[i];
    return planes[i];
}
Rectangle rectangleAt(uint i) {
    if (RECTANGLE_COUNT <= FEW) return scene.rectangles[i];
    return rectangles[i];
}
Disc discAt(uint i) {
    if (DISC_COUNT <= FEW) return scene.discs[i];
    return discs[i];
}
Sphere sphereAt(uint i) {
    if (SPHERE_COUNT <= FEW) return scene.spheres[i];
    return spheres[i];
}
Box boxAt(uint i) {
    if (BOX_COUNT <= FEW) return scene.boxes[i];
    return boxes[i];
}
Cylinder cylinderAt(uint i) {
    if (CYLINDER_COUNT <= FEW) return scene.cylinders[i];
    return cylinders[i];
}
Cone coneAt(uint i) {
    if (CONE_COUNT <= FEW) return scene.cones[i];
    return cones[i];
}
Triangle triangleAt(uint i) {
    if (TRIANGLE_COUNT <= FEW) return scene.triangles[i];
    return triangles[i];
}
ThesisGrating gratingAt(uint i) {
    if (GRATING_COUNT <= FEW) return scene.gratings[i];
    return gratings[i];
}
