// The scene as the device sees it. Arrays that a scene lacks are never read: their constant is 0.

#include "interface.h"
#include "specialisation.h"

#define DECLARE(id, name) layout(constant_id = id) const uint name = 1u;
FRINGE_SPECIALISATION(DECLARE)
#undef DECLARE

layout(scalar, set = 0, binding = 0) uniform Scene { SceneBlock scene; };
layout(scalar, set = 0, binding = 1) buffer FilmBlock { uint firstRow; FilmPixel film[]; };  // rows firstRow.. of the picture
layout(scalar, set = 0, binding = 2) readonly buffer PlaneBlock { Plane planes[]; };
layout(scalar, set = 0, binding = 3) readonly buffer RectangleBlock { Rectangle rectangles[]; };
layout(scalar, set = 0, binding = 4) readonly buffer DiscBlock { Disc discs[]; };
layout(scalar, set = 0, binding = 5) readonly buffer SphereBlock { Sphere spheres[]; };
layout(scalar, set = 0, binding = 6) readonly buffer BoxBlock { Box boxes[]; };
layout(scalar, set = 0, binding = 7) readonly buffer CylinderBlock { Cylinder cylinders[]; };
layout(scalar, set = 0, binding = 8) readonly buffer ConeBlock { Cone cones[]; };
layout(scalar, set = 0, binding = 9) readonly buffer TriangleBlock { Triangle triangles[]; };
layout(scalar, set = 0, binding = 10) readonly buffer MaterialBlock { Material materials[]; };
layout(scalar, set = 0, binding = 11) readonly buffer LightBlock { Light lights[]; };
layout(scalar, set = 0, binding = 12) readonly buffer GratingBlock { ThesisGrating gratings[]; };
layout(scalar, set = 0, binding = 13) readonly buffer SlitGratingBlock { SlitGrating slitGratings[]; };
layout(scalar, set = 0, binding = 14) readonly buffer TableBlock { float tables[]; };
layout(scalar, set = 0, binding = 15) readonly buffer OpeningGratingBlock { OpeningGrating openingGratings[]; };
layout(scalar, set = 0, binding = 16) readonly buffer OpticalDiscBlock { OpticalDisc opticalDiscs[]; };
// Entries of response tables, as texels: drivers for processors fetch the four words of a texel at once, but those of a storage
// buffer one by one, lane by lane. Where the device's texel buffers are too small, texels lie in images, from which lavapipe
// fetches 1.66 times as slowly.
layout(set = 0, binding = 17) uniform utextureBuffer responses;
layout(set = 0, binding = 18) uniform utexture2D responseImage;

ivec2 placeInImage(uint texel) { return ivec2(texel % TEXEL_ROW, texel / TEXEL_ROW); }

uvec4 responseEntry(uint at) {
    if (TEXELS_IN_IMAGES != 0u) return texelFetch(responseImage, placeInImage(at), 0);
    return texelFetch(responses, int(at));
}

// TypeAt(i): element i of a kind, from where it lies. Among few it is selected, not addressed: i mostly differs from
// invocation to invocation, and an address that does is loaded lane by lane on a CPU.
#define ELEMENT_AT(TYPE, FUNCTION, COUNT, ARRAY)                  \
    TYPE FUNCTION(uint i) {                                       \
        if (COUNT > FEW) return ARRAY[i];                         \
        TYPE element = scene.ARRAY[0];                            \
        [[unroll]] for (uint j = 1u; j < COUNT; ++j) {            \
            if (i == j) element = scene.ARRAY[j];                 \
        }                                                         \
        return element;                                           \
    }
ELEMENT_AT(Plane, planeAt, PLANE_COUNT, planes)
ELEMENT_AT(Rectangle, rectangleAt, RECTANGLE_COUNT, rectangles)
ELEMENT_AT(Disc, discAt, DISC_COUNT, discs)
ELEMENT_AT(Sphere, sphereAt, SPHERE_COUNT, spheres)
ELEMENT_AT(Box, boxAt, BOX_COUNT, boxes)
ELEMENT_AT(Cylinder, cylinderAt, CYLINDER_COUNT, cylinders)
ELEMENT_AT(Cone, coneAt, CONE_COUNT, cones)
ELEMENT_AT(Triangle, triangleAt, TRIANGLE_COUNT, triangles)
ELEMENT_AT(Material, materialAt, MATERIAL_COUNT, materials)
ELEMENT_AT(Light, lightAt, LIGHT_COUNT, lights)
ELEMENT_AT(ThesisGrating, gratingAt, GRATING_COUNT, gratings)
ELEMENT_AT(SlitGrating, slitGratingAt, SLIT_GRATING_COUNT, slitGratings)
ELEMENT_AT(OpeningGrating, openingGratingAt, OPENING_GRATING_COUNT, openingGratings)
ELEMENT_AT(OpticalDisc, opticalDiscAt, OPTICAL_DISC_COUNT, opticalDiscs)

// The same value, but not to be seen as a uniform. Use it wherever a value of the scene block alone decides an if: for
// such values lavapipe 22.3 may compile the shader again at every dispatch (half a second each).
uint decided(uint value) { return value ^ (gl_NumWorkGroups.x >> 31); }

uint lightCount() { return LIGHT_COUNT <= FEW ? LIGHT_COUNT : uint(lights.length()); }
uint slitGratingCount() { return SLIT_GRATING_COUNT <= FEW ? SLIT_GRATING_COUNT : uint(slitGratings.length()); }
uint openingGratingCount() { return OPENING_GRATING_COUNT <= FEW ? OPENING_GRATING_COUNT : uint(openingGratings.length()); }
uint gratingCount() { return GRATING_COUNT <= FEW ? GRATING_COUNT : uint(gratings.length()); }

vec3 tableColor(uint at) { return vec3(tables[at], tables[at + 1u], tables[at + 2u]); }
