// Pipeline constants, declared once for both languages: X(id, NAME). All follow from the scene's structure
// (src/compile/specialise.cpp), none from a value that a slider changes. A ..._COUNT is the number of such things, or
// FEW + 1 if there are more than FEW; likewise ..._CASTERS, those that can throw a shadow. A HAS_... or IS_... is 0 or 1.
#define FRINGE_SPECIALISATION(X) \
    X(0, PLANE_COUNT)             \
    X(1, RECTANGLE_COUNT)         \
    X(2, DISC_COUNT)              \
    X(3, SPHERE_COUNT)            \
    X(4, BOX_COUNT)               \
    X(5, CYLINDER_COUNT)          \
    X(6, CONE_COUNT)              \
    X(7, TRIANGLE_COUNT)          \
    X(8, GRATING_COUNT)           \
    X(9, LIGHT_COUNT)             \
    X(10, HAS_DIFFUSE)            \
    X(11, HAS_CONDUCTORS)         \
    X(12, HAS_DIELECTRICS)        \
    X(13, HAS_EMITTERS)           \
    X(14, HAS_THESIS_DISCS)       \
    X(15, HAS_POINT_LIGHTS)       \
    X(16, HAS_SPOT_LIGHTS)        \
    X(17, HAS_DIRECTIONAL_LIGHTS) \
    X(18, HAS_RECTANGLE_LIGHTS)   \
    X(19, HAS_DISC_LIGHTS)        \
    X(20, HAS_SPHERE_LIGHTS)      \
    X(21, HAS_ENVIRONMENT)        \
    X(22, HAS_PRINTED_FAULTS)     \
    X(23, IS_ORTHOGRAPHIC)        \
    X(24, HAS_LENS)               \
    X(25, HAS_SEVERAL_SAMPLES)    \
    X(26, MAX_DEPTH)              \
    X(27, PLANE_CASTERS)          \
    X(28, RECTANGLE_CASTERS)      \
    X(29, DISC_CASTERS)           \
    X(30, TRIANGLE_CASTERS)       \
    X(31, MATERIAL_COUNT)         \
    X(32, SLIT_GRATING_COUNT)     \
    X(33, HAS_SLIT_LINES)         \
    X(34, HAS_SLIT_CONTINUUM)     \
    X(35, HAS_WIDE_GRATINGS)      \
    X(36, HAS_GAUSSIAN_BEAMS)     \
    X(37, HAS_ORDER_SHARES)
