// How far from its far field an opening is where its light falls.
#pragma once

#include "optics/aperture.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

// Diameter of the circle about the middle that holds the opening, or a lattice's cell, in metres. Endless
// for slits.
double openingExtent(const optics::Aperture& aperture);

// The same for all of a lattice.
double wholeExtent(const optics::Aperture& aperture);

// Whether the device has Fresnel's integral of it: of rectangles, circles and rings.
bool hasNearField(const optics::Aperture& aperture);

// The wavelength that Fresnel numbers are given for: the middle of the visible range.
inline constexpr double kFresnelWavelength = 550e-9;

// From this Fresnel number on a far field is 8e-3 of its peak off, and soon more.
inline constexpr double kFarFieldNumber = 0.1;

// Where an opening's light is furthest from its far field.
struct NearestField {
    double distance;       // metres from the opening along the beam; 0 where it lights nothing
    double fresnelNumber;  // (half its extent)^2 |1/distance - 1/focus| / wavelength
    double leastNumber;    // the same where it is nearest to it
};

// Over all matt surfaces that the main part of the light falls on. What only its far side lobes reach is not
// counted. An upper bound: solid shapes count with the boxes around them.
NearestField nearestField(const scene::Scene& scene, const scene::Grating& grating);

}  // namespace fringe::compile
