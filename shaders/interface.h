// Every byte that host and device share, written once: included by GLSL (scalar block layout) and by C++
// inside namespace fringe::device (src/compile/interface.hpp). No bool, no padding, no matrices.
// Lengths are metres unless a suffix says otherwise; directions are unit vectors. A light is a number of watts and a row of
// spectra, a surface a row of reflectances; colours are CIE XYZ of both together (tables, src/compile/spectral.hpp).

struct Camera {
    vec3 position;
    vec3 forward;
    vec3 right;          // half the image plane's width at distance 1 (orthographic: half the visible width)
    vec3 up;             // likewise its height
    vec3 lensRight;      // half the lens diameter along the picture's right
    vec3 lensUp;
    float focusDistance;
};

// Even cells of space, for scenes with so many gratings that not every point can ask all of them: each cell has a list of
// those that may reach it (src/compile/grating_grid.hpp). Beyond the grid the outermost cells count.
struct GratingGrid {
    vec3 low;
    vec3 cellsPerMetre;
    vec3 last;           // the number of the last cell along each axis
    uint perRow;         // cells
    uint perLayer;
    uint places;         // in the tables: for each cell where its list is, from `lists` on
    uint lists;          // in the tables: how long a list is, then the gratings in their order
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
    float environment;   // radiance
    uint environmentSpectrum;
    uint reflectanceCount;
    uint metals;         // where the refractive indices begin in the tables
    uint castingDiscs;   // where the discs that light their surroundings are in the tables: centre, normal, radius, OpticalDisc
    uint discSpectra;    // where the spectra for optical discs begin in the tables (src/compile/discs.hpp)
    GratingGrid gratingGrid;
    float pixelAngle;    // width of a sample's share of a pixel: this times the distance, plus pixelWidth
    float pixelWidth;
};

// Running sum over the samples taken so far, zero at first; the count is in the low 31 bits of state, and NON_FINITE is
// set once any sample was 0/0 by a formula that the scene asked for as printed.
struct FilmPixel {
    vec3 sum;            // CIE XYZ
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

// A node of the tree over the shapes of kinds that have more than FEW (src/compile/tree.hpp): the boxes of two children,
// and what they are. The shader reads it as four texels.
struct TreeNode {
    vec3 lowLeft;
    uint left;           // a node; or TREE_LEAF + (kind << TREE_KIND_SHIFT) + index of a shape
    vec3 highLeft;
    uint right;
    vec3 lowRight;
    uint unusedLow;      // fills the texel
    vec3 highRight;
    uint unusedHigh;
};

const uint TREE_LEAF = 0x80000000u;
const uint TREE_KIND_SHIFT = 28u;

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
const uint OPTICAL_DISC = 6u;

// One record for every kind: what `value` and `row` mean depends on it.
struct Material {
    uint kind;
    float value;         // factor on the reflectance | - | refractive index | radiance | mirror reflectance | of the label
    uint row;            // reflectance | metal | - | spectrum | - | optical disc
    uint twoSided;       // EMISSIVE
    vec3 color;          // THESIS_DISC: linear sRGB
    ThesisAperture aperture;  // THESIS_DISC
};

const uint NO_METAL = 0xffffffffu;

// A disc whose track diffracts (docs/optical-discs.md). From the middle outwards: hub, plain metal, track, plain metal.
struct OpticalDisc {
    float pitch_um;
    float depth_um;      // of the pits, times the refractive index over the track
    float bend;          // refractive index over the track, by which directions are refracted: 1 where it lies in air
    float index;         // of the cover, or of the lacquer where there is no metal
    uint metal;          // or NO_METAL: a lacquer, with a track on both sides
    float pits;          // share of the data's area that is pit
    float scattering;    // share of the light that pits scatter, per phase contrast
    float pitWidth_um;
    float correlation_um;   // length along the track over which scattered light agrees
    uint scatteringShares;  // in the tables: for each band, the part of the scattering that propagates
    uint orders;         // in the tables: given efficiencies [-orderCount..orderCount][band]
    uint orderCount;
    uint isGiven;        // 1: efficiencies are given
    uint isCoarse;       // 1: so many orders that all power is among them
    float grooveSlope;   // of a wide groove: the steepest slope of its arc, times the refractive index; 0 for pits
    float hubRadiusSquared;
    float innerRadiusSquared;  // of the data
    float outerRadiusSquared;
    uint label;          // reflectance row
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
    float emission;      // radiant intensity | irradiance | radiance
    uint spectrum;
    float area;          // of a flat area light
    float radius;        // of a sphere; sine of half the angle that a directional light fills
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
    vec3 color;          // times power; linear sRGB
    ThesisAperture aperture;
};

const uint FLAT_BEAM = 0u;      // a disc
const uint GAUSSIAN_BEAM = 1u;
const uint RECTANGULAR_BEAM = 2u;

// How the colour of slits is computed where their spectrum is continuous (evaluators.glsl), and single lines by the last three.
const uint TABLE_EVALUATOR = 0u;
const uint ORDERS_EVALUATOR = 1u;
const uint DIRECT_EVALUATOR = 2u;        // this and the next two: a sum over wavelengths
const uint SMALL_ANGLE_EVALUATOR = 3u;
const uint NAIVE_EVALUATOR = 4u;
const uint PAIRS_EVALUATOR = 5u;         // lines as well (pairs.glsl)

// Slits in a beam, physically (docs/theory.md). Lengths in the plane of the slits; the aperture's frame is across, along,
// normal, and the light leaves with direction cosines alpha, beta, gamma along these.
struct SlitGrating {
    vec3 position;
    vec3 across;
    vec3 along;
    vec3 normal;
    float alphaIn;       // direction cosines of the beam
    float betaIn;
    uint profile;
    float halfWidth;     // of the beam, across the slits; Gaussian: 1/e^2 radius
    float halfHeight;    // likewise along them
    float halfSlits;     // half of what the slits cover: count period / 2
    float convergence;   // 1 / distance of the beam's focus; 0 for a collimated beam
    float angularSize;   // of the source
    float irradiance;    // power per area that leaves the middle of the slits
    uint isWide;         // 1: the undeviated light is followed apart from the response
    uint linesAreImages; // 1: a line's orders are images of the beam; 0: the far field of the slits
    float count;
    float width_um;
    float period_um;
    uint evaluator;
    uint zeroEntry;      // of the response table, the one for u = 0, wrapped below 0; it is in steps of 1 / perU. By orders,
                         // wavelengths in um for u
    float perU;
    uint entries;        // or waves in the list
    uint response;       // in the responses: for each reflectance, for the sum of all bands and each band, the entries; or
                         // a list of waves (src/compile/wave_tables.hpp)
    float integralUnit;  // of the entries
    float slopeUnit;     // in units of the integral
    uint lines;          // in the tables: for each reflectance, wavelengths that are followed one by one
    uint lineCount;
    uint shares;         // in the tables: for each line the share of the beam that each order takes; where orderCount is 0
    uint orderCount;     // they are those of an amplitude grating
    float firstOrder;
    uint zeroOrder;      // likewise, wavelengths that stand for the undeviated beam's continuous spectrum
    uint zeroOrderCount;
};

// An entry of a response table: its running integral, and by how much the response changes to the next entry. Integers
// keep the difference of two integrals exact; floats would leave it 256 times less precise.
struct ResponseEntry {
    uvec3 integral;      // in units of the grating's, steps of the table
    uint slopes;         // three signed numbers of nine bits, to be shifted by the uppermost five
};
const uint TEXEL_ROW = 4096u;        // where texels lie in an image, it has so many a row

const uint RECTANGULAR_OPENING = 1u;
const uint CIRCULAR_OPENING = 2u;
const uint RING_OPENING = 3u;
const uint POLYGONAL_OPENING = 4u;
const uint SYMMETRIC_OPENING = 5u;   // a polygon of at most 2 FEW_EDGES edges with a centre of symmetry
const uint MASK_OPENING = 6u;
const uint GAUSSIAN_OPENING = 7u;   // any that lets a Gaussian beam pass whole
const uint FEW_EDGES = 8u;           // that an invocation keeps at hand

// Any other opening in a beam, or a lattice of them; its frame is that of slits.
struct OpeningGrating {
    vec3 position;
    vec3 across;
    vec3 along;
    vec3 normal;
    vec2 incoming;       // direction cosines of the beam, across and along
    float convergence;   // 1 / distance of the beam's focus; 0 for a collimated beam
    uint opening;
    vec2 size_um;        // width, height | diameter, - | diameter, inner over outer | area in um^2, - | mask: its table's
    vec2 pixel_um;       // of a mask: width and height
    uint table;          // in the tables: a polygon's vertices in um, a mask's spectrum
    uint edgeCount;      // of a polygon, or of its half
    float extent;        // diameter of a polygon in um, of a mask in its pixels
    uint hasHats;        // 1: a mask's pixels are hats twice as wide, which overlap, and not squares
    uint isLattice;
    uint isNear;         // 1: a surface that it lights lies in its near field (shaders/near_openings.glsl)
    vec4 first_um;       // from cell to cell: (x, y) rounded, and what that leaves out
    vec4 second_um;
    vec2 counts;         // of cells, those that a beam lights
    uint isUneven;       // 1: a Gaussian beam lights the lattice's cells (shaders/uneven_lattices.glsl)
    float beamRadius_um;  // of a Gaussian beam: where its amplitude is 1/e
    float imagePeak;     // of an order in the far field, were the lattice endless, over what it is
    uint cells;          // in the tables: their spectrum, of this size; 0 where the lattice reaches past the beam
    vec2 cellsSize;
    vec2 cellsWidth;     // where it is: turns from an order, along either row, times this are 1 at the end of its main lobe
    vec2 cellsFollow;    // and how far cells' patterns go with the order: 0 in even light to 1 in a beam that ends within it
    float wavenumberStep;  // of the continuous spectrum, per um
    float sourceBlur;    // direction cosine between neighbouring points of the source, or its size if it is one; 0 for no size
    uint samples;        // in the tables: wavenumber in 1/um and the source's direction; then, for each reflectance, XYZ
    uint sampleCount;
    uint hasLayers;      // 1: a surface that it lights lies in its near field, which is looked up
    uint layers;         // in the tables: what LayerRow says, then patterns for a row of Fresnel numbers
};

// Of layers, as floats.
struct LayerRow {
    float count;
    float entries;       // of each
    float points;        // of a table along either axis
    float across;        // pixels of the opening, at which tables repeat themselves
    float pixel_um;
    float half_um;       // for Fresnel numbers
    float first;         // the first of these
    float ratio;         // log2 from one to the next, LAYER_OFFSET added to either
    float upright;       // of masks: lengths of edges with the squares of their steps over |A(0)|^2, 1/um^3; of those along y
    float level;         // along x
    float slanting;      // the others
};
const uint LAYER_ROW_SIZE = 11u;
const float LAYER_OFFSET = 2.5f;
const float LAYER_STRETCH = 3.0f;    // src/optics/near_spectrum.hpp

// An entry of that list. Where a scene has but one opening and grey surfaces, and the list is no longer than
// FEW_SAMPLES, it is in the uniform block, and the loop over it unrolled.
struct OpeningSample {
    float wavenumber;    // per um
    vec3 color;
};
const uint FEW_SAMPLES = 32u;

// Per um; where means over fringes are known (shaders/fading.glsl).
const vec3 MEAN_WAVENUMBERS = vec3(1.28f, 1.95f, 2.63f);

// Bands that the visible range is cut into where surfaces on a path have colours of their own, and at the edges of a beam.
// Their weights are hats: 1 in the band's middle, 0 in its neighbours'; the first and last reach to the ends of the range.
// Where the reflectances of gold and copper climb the middles are 5 nm apart, below 10 nm and above 12.5 nm.
const uint SPECTRAL_BANDS = 41u;
const float FIRST_BAND_um = 0.4;
const float LOW_STEP_um = 0.01;
const uint LOW_STEPS = 8u;
const float MIDDLE_STEP_um = 0.005;
const uint MIDDLE_STEPS = 24u;
const float HIGH_STEP_um = 0.0125;

// The visible range.
const float FIRST_WAVE_um = 0.38;
const float LAST_WAVE_um = 0.78;

// Side lobes of the undeviated beam that are followed; what lies beyond is in the response table.
const float ZERO_ORDER_LOBES = 30.0;

// Step of the wavelengths that stand for the undeviated beam.
const float ZERO_ORDER_STEP_um = 0.005;

const uint NON_FINITE = 0x80000000u;

const uint GROUP_EDGE = 8u;   // a workgroup is GROUP_EDGE x GROUP_EDGE pixels

// Up to FEW of a kind lie in the uniform block, where the shader's loops over them are unrolled and every load has a
// constant address; more go through storage buffers and ordinary loops. On lavapipe a load whose address is no
// constant is done lane by lane: five rectangles cost five times as much in a storage buffer.
const uint FEW = 16u;
const uint FEW_GRATINGS = 32u;   // of all kinds together that are asked one by one, a bit each

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
    SlitGrating slitGratings[FEW];
    OpeningGrating openingGratings[FEW];
    OpeningSample openingSamples[FEW_SAMPLES];
    vec3 openingMeans[3];   // of a mean's value at MEAN_WAVENUMBERS, times their cubes, to the first EVEN_SAMPLES of these
    OpticalDisc opticalDiscs[FEW];
};
