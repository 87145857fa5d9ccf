// Every byte that host and device share, written once: included by GLSL (scalar block layout) and by C++
// inside namespace fringe::device (src/compile/interface.hpp). No bool, no padding, no matrices.
// Lengths are metres unless a suffix says otherwise; colours are linear sRGB; directions are unit vectors.

struct Camera {
    vec3 position;
    vec3 forward;
    vec3 right;          // half the image plane's width at distance 1 (orthographic: half the visible width)
    vec3 up;             // likewise its height
    vec3 lensRight;      // half the lens diameter along the picture's right
    vec3 lensUp;
    float focusDistance;
};

// What every invocation reads. How many there are of each thing is in the pipeline constants, or in the length of its
// storage buffer: lavapipe compiles a shader again for each new value of a uniform that bounds a loop or decides an if.
// For the same reason nothing that changes from dispatch to dispatch is a uniform or a push constant: the place in the
// picture and the sample's index come in as the dispatch's first workgroup.
struct Frame {
    Camera camera;
    uint width;
    uint height;
    uint filmWidth;      // the picture's, rounded up to whole workgroups; the shader never asks where the picture ends
    uint seed;
    vec3 environment;    // radiance
};

// Running sum over the samples taken so far, zero at first; the count is in the low 31 bits of state, and NON_FINITE is
// set once any sample was 0/0 by a formula that the scene asked for as printed.
struct FilmPixel {
    vec3 sum;
    uint state;
};

struct Plane {
    vec3 point;
    vec3 normal;
    uint material;
};

struct Rectangle {
    vec3 center;
    vec3 uDual;          // u/|u|^2: dot(p - center, uDual) runs from -1 to 1 across the rectangle
    vec3 vDual;          // the normal is along uDual x vDual
    uint material;
};

struct Disc {
    vec3 center;
    vec3 normal;
    float innerRadiusSquared;
    float radiusSquared;
    uint material;
};

struct Sphere {
    vec3 center;
    float radius;
    uint material;
};

struct Box {
    vec3 center;
    vec3 uDual;
    vec3 vDual;
    vec3 wDual;
    uint material;
};

struct Cylinder {
    vec3 base;
    vec3 axis;
    float height;
    float radius;
    uint capped;
    uint material;
};

struct Cone {
    vec3 apex;
    vec3 axis;           // from the apex to the base
    float height;
    float slope;         // radius / height
    uint capped;
    uint material;
};

struct Triangle {
    vec3 vertex;
    vec3 edge1;
    vec3 edge2;
    vec3 normal;
    uint material;
};

// Slits of the thesis's model; reciprocal wavelengths as printed live in thesis.glsl.
struct ThesisAperture {
    float width_um;
    float period_um;
    uint count;
    uint asPrinted;      // 1: leave 0/0 in, flagged
};

const uint DIFFUSE = 1u;
const uint CONDUCTOR = 2u;
const uint DIELECTRIC = 3u;
const uint EMISSIVE = 4u;
const uint THESIS_DISC = 5u;

// One record for every kind: what `color` and `second` mean depends on it.
struct Material {
    uint kind;
    vec3 color;          // reflectance | n | ior in x | radiance | pattern colour
    vec3 second;         // - | k | - | x: 1 if two-sided | x: mirror reflectance
    ThesisAperture aperture;  // THESIS_DISC
};

const uint POINT_LIGHT = 1u;
const uint SPOT_LIGHT = 2u;
const uint DIRECTIONAL_LIGHT = 3u;
const uint RECTANGLE_LIGHT = 4u;
const uint DISC_LIGHT = 5u;
const uint SPHERE_LIGHT = 6u;
const uint ENVIRONMENT_LIGHT = 7u;

struct Light {
    uint kind;
    vec3 position;       // or centre
    vec3 direction;      // the way the light goes; normal of a flat area light
    vec3 u;              // half edges of a rectangle, radius vectors of a disc
    vec3 v;
    vec3 emission;       // radiant intensity | irradiance | radiance
    float area;          // of a flat area light
    float radius;        // of a sphere
    float cosOuter;
    float cosInner;
    float innerRatioSquared;  // of a disc with a hole: (inner radius / radius)^2
    uint twoSided;
};

struct ThesisGrating {
    vec3 position;
    vec3 normal;
    vec3 across;         // normal x slitDirection
    vec3 slitDirection;
    float radius;        // half the beam's diameter
    float attenuation;   // 1 / radius^2, or 0 for a band of even brightness
    vec3 color;          // times power
    ThesisAperture aperture;
};

const uint NON_FINITE = 0x80000000u;

const uint GROUP_EDGE = 8u;   // a workgroup is GROUP_EDGE x GROUP_EDGE pixels

// Up to FEW of a kind lie in the uniform block, where the shader's loops over them are unrolled and every load has a
// constant address; more go through storage buffers and ordinary loops. On lavapipe a load whose address is no
// constant is done lane by lane: five rectangles cost five times as much in a storage buffer.
const uint FEW = 16u;

struct SceneBlock {
    Frame frame;
    Plane planes[FEW];
    Rectangle rectangles[FEW];
    Disc discs[FEW];
    Sphere spheres[FEW];
    Box boxes[FEW];
    Cylinder cylinders[FEW];
    Cone cones[FEW];
    Triangle triangles[FEW];
    Material materials[FEW];
    Light lights[FEW];
    ThesisGrating gratings[FEW];
};
