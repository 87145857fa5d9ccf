// The scene as a user described it: SI units, double precision, plain values.
// Invariant: a Scene that `parseScene` returned is valid (unit directions are normalised, lengths are
// finite and positive, references resolved), so nothing downstream checks it again.
// Coordinates are metres, right-handed, y up. Spectra are whole: RGB of the file is a spectrum here.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "optics/aperture.hpp"
#include "optics/energy.hpp"
#include "optics/spectrum.hpp"
#include "units/units.hpp"

namespace fringe::scene {

using glm::dvec3;
using Rgb = glm::dvec3;  // linear sRGB

// ---- picture and camera -------------------------------------------------------------------------

enum class ColorSpace { srgb, displayP3, rec2020 };  // of PNG files

struct Image {
    std::uint32_t width = 600;
    std::uint32_t height = 600;
    std::uint32_t samples = 1;   // per pixel; one sample goes through the pixel's centre
    std::uint32_t seed = 0;      // of the sample pattern
    std::uint32_t maxDepth = 8;  // longest chain of mirror and glass surfaces a path may follow
    double exposure = 0.0;       // stops; at 0 a value of 1 is display white
    bool autoExposure = false;   // `exposure` is then added to the one found from the picture
    ColorSpace colorSpace = ColorSpace::srgb;
    double tolerance = 1e-3;  // error of each light that is accepted, as a share of its brightest place
};

struct ThinLens {
    units::Length diameter;
    units::Length focusDistance;  // from the lens to the plane in focus, along the optical axis
};

struct Perspective {
    units::Angle fov;  // vertical, whole angle
    std::optional<ThinLens> lens;
};

struct Orthographic {
    double height;  // metres of the scene that the picture's height shows
};

struct Camera {
    dvec3 position;
    dvec3 target;
    dvec3 up;
    std::variant<Perspective, Orthographic> projection;
    std::optional<optics::Spectrum> whiteBalance;  // light that the picture shows as white; without it D65
};

// ---- materials ----------------------------------------------------------------------------------

enum class Faults { limit, asPrinted };  // what the thesis's 0/0 becomes: its limit, or a flagged NaN

using optics::Slits;

// Invariant: the curve covers the visible range.
struct Diffuse {
    optics::Curve reflectance;
};

enum class Metal { aluminium, silver, gold, copper };

struct Conductor {
    Metal metal;
};

struct Dielectric {
    double ior;  // relative to the surroundings, > 0
};

struct Emissive {
    units::Radiance radiance;
    optics::Spectrum spectrum;  // per watt of `radiance`; tinted by the material's colour
    bool twoSided;              // false: only the side that the normal points to
};

// The compact disc of the thesis as its listing has it (physics: docs/thesis-algorithm.md): the pattern
// depends on the view ray alone, and a mirror of the stated reflectance lies under it.
struct ThesisDisc {
    Slits slits;
    double mirrorReflectance;
    Faults faults;
};

// Share of the incident power that an order takes, where it is known better than scalar theory tells.
struct OrderEfficiency {
    int order;
    optics::Curve efficiency;  // over wavelength, covers the visible range

    bool operator==(const OrderEfficiency&) const = default;
};

// An optical disc or record with a spiral track that diffracts light: a metal under a clear cover, or a black
// lacquer, which reflects at its surface.
struct OpticalDisc {
    units::Length pitch;     // of the track, radially
    units::Length pitWidth;  // of the groove or pit; < pitch
    units::Length pitDepth;
    double pitShare;             // of the track's length that is pit: 1 for a groove
    double coverIndex;           // refractive index of the cover layer; 1 for none
    std::optional<Metal> metal;  // none: lacquer of that index, opaque; the track is in its surface, in air
    double dataInnerRadius;      // metres; outside the data there is plain metal
    double dataOuterRadius;
    double metalInnerRadius;         // metres; inside lies the clear hub, shown as the cover's plain surface
    optics::Curve labelReflectance;  // of the back
    std::vector<OrderEfficiency> efficiencies;  // empty: those of a binary phase grating
    bool castsLight = false;                    // sends light of lamps on to matt surfaces
};

struct Material {
    std::string name;
    std::variant<Diffuse, Conductor, Dielectric, Emissive, ThesisDisc, OpticalDisc> model;
};

// ---- shapes -------------------------------------------------------------------------------------

struct Plane {
    dvec3 point;
    dvec3 normal;  // unit
};

struct Rectangle {
    dvec3 center;
    dvec3 u;  // half edges, perpendicular; the normal is u x v
    dvec3 v;
};

struct Disc {
    dvec3 center;
    dvec3 normal;  // unit
    double radius;
    double innerRadius;  // of the hole; 0 for none
};

struct Sphere {
    dvec3 center;
    double radius;
};

struct Box {
    dvec3 center;
    dvec3 u;  // half edges, mutually perpendicular
    dvec3 v;
    dvec3 w;
};

struct Cylinder {
    dvec3 base;
    dvec3 top;
    double radius;
    bool capped;
};

struct Cone {
    dvec3 base;
    dvec3 apex;
    double radius;  // at the base
    bool capped;
};

struct Triangle {
    dvec3 vertices[3];  // counter-clockwise seen from the side the normal points to
};

using Shape = std::variant<Plane, Rectangle, Disc, Sphere, Box, Cylinder, Cone, Triangle>;

struct Object {
    std::string name;  // may be empty
    Shape shape;
    std::uint32_t material;  // index into Scene::materials
};

// ---- lights -------------------------------------------------------------------------------------

struct PointLight {
    dvec3 position;
    units::Power power;  // radiant intensity is power / 4 pi
};

// Full intensity inside innerAngle, none outside angle, smoothstep in the cosine between them.
struct SpotLight {
    dvec3 position;
    dvec3 direction;          // unit, the way the light goes
    units::Angle angle;       // half angle of the whole cone, at most 180 deg
    units::Angle innerAngle;  // <= angle
    units::Power power;       // of the whole cone
};

struct DirectionalLight {
    dvec3 direction;               // unit, the way the light goes
    units::Irradiance irradiance;  // on a surface that faces it
    units::Angle angularSize{};    // whole angle of the round source
};

// Lambertian: radiance is power / (pi area), from the front alone unless twoSided (then from each side).
// The emitting surface is visible.
struct AreaLight {
    std::variant<Rectangle, Disc, Sphere> shape;
    units::Power power;  // of one side
    bool twoSided;
};

struct EnvironmentLight {
    units::Radiance radiance;  // from every direction
};

// A grating as a light: the algorithm of Watson 2009, "Code". See docs/thesis-algorithm.md.
struct ThesisGrating {
    dvec3 position;
    dvec3 normal;         // unit, outgoing
    dvec3 slitDirection;  // unit, perpendicular to the normal
    Slits slits;
    units::Length beamDiameter;
    units::Power power;  // "wattage": a factor on the value, which is added to the picture directly
    bool attenuated;     // by the circle, as in figure 17; else full inside the band, as in figure 16
    Faults faults;
};

using optics::BeamProfile;

// What falls on a grating: collimated, or converging where it is focused.
struct Beam {
    BeamProfile profile;
    units::Length width;   // across the slits: diameter of a flat disc, 1/e^2 diameter of a Gaussian
    units::Length height;  // along the slits; as the width but for a rectangle
    dvec3 direction;  // unit, the way the light goes; its part along the normal is > 0 (transmission) or < 0
                      // (reflection)
    units::Power power;
    units::Angle angularSize;            // whole angle that the source fills; 0 for a point at infinity
    std::optional<units::Length> focus;  // from the grating to where a lens brings the beam together
};

// The way to the colour of slits in a continuous spectrum (docs/theory.md, "Evaluators"). The small-angle
// approximation and the formula as printed are for comparison, and hold for single lines as well.
enum class Evaluator { automatic, table, direct, smallAngle, naive, orders };

// A diffraction grating or another aperture in a beam, as a light: scalar theory, docs/theory.md. The light
// leaves on the side that the normal points to.
struct Grating {
    dvec3 position;
    dvec3 normal;         // unit, outgoing
    dvec3 slitDirection;  // unit, perpendicular to the normal: the aperture's y; its x is slitDirection x
                          // normal
    optics::Aperture aperture;
    Beam beam;
    std::optional<double>
        efficiency;  // share of the beam that leaves; else the open share of the beam's area
    std::vector<OrderEfficiency> efficiencies;  // of slits; empty: those of an amplitude grating
    Evaluator evaluator = Evaluator::automatic;
    std::optional<std::uint32_t> wavelengths = std::nullopt;  // that sums go over; else as the tolerance asks
};

struct Light {
    std::string name;           // may be empty
    Rgb color;                  // already in the spectrum, but for thesis gratings, which have that alone
    optics::Spectrum spectrum;  // per watt, W/m^2 or W/(m^2 sr) of the model, tinted by `color`
    std::variant<PointLight, SpotLight, DirectionalLight, AreaLight, EnvironmentLight, ThesisGrating, Grating>
        model;
};

struct Scene {
    std::string description;
    Image image;
    Camera camera;
    std::vector<Material> materials;
    std::vector<Object> objects;
    std::vector<Light> lights;
    bool castsShadows = true;  // no key of scene files: the preview can switch shadows off
};

// Whether anything asks for its 0/0 as printed, or for the formula as it is printed, so that pixels may be
// not a number.
bool hasPrintedFaults(const Scene& scene);

}  // namespace fringe::scene
