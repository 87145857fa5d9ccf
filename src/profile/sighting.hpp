// What a point of a surface sees of each grating and aperture: how far it is and under what angle, and which
// order of which wavelength it sends there.
#pragma once

#include <string>
#include <vector>

#include "profile/surface.hpp"

namespace fringe::profile {

// A line of the lamp, and the order that it has there: whole in a maximum.
struct LineOrder {
    double wavelength_nm;
    double order;
};

// The wavelength of a continuum that has this order there.
struct OrderWavelength {
    int order;
    double wavelength_nm;
};

struct Sighting {
    std::string grating;  // name of the light, or "lights[2]"
    double distance;      // metres, from its middle
    double angle_deg;     // to its normal
    // Change of the direction cosines on the way there, across and along the slits; order m of slits with the
    // period d is where `u` is m wavelength/d.
    double u, v;
    std::vector<LineOrder> lines;         // of slits: the strongest lines of the lamp, the brightest first
    std::vector<OrderWavelength> orders;  // of slits in a continuum, the lowest first
    bool isUndeviated;                    // of slits: in order 0 of all wavelengths
};

// Of all gratings and apertures in front of which the point is.
std::vector<Sighting> sightingsFrom(const scene::Scene& scene, dvec3 point);

}  // namespace fringe::profile
