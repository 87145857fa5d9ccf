// Optical discs as the reference renderer has them. The light that a disc diffracts towards the eye is
// followed backwards, one wavelength and one order at a time: the grating equation says where it comes from,
// and a ray whether anything shines there.
#pragma once

#include "oracle/sampler.hpp"
#include "oracle/value.hpp"
#include "oracle/world.hpp"

namespace fringe::oracle {

// A place of the track, light on its way to the eye, and how it gets there.
struct TrackPoint {
    dvec3 position;
    dvec3 normal;  // on the eye's side
    dvec3 toEye;   // unit
    dvec3 center;  // of the disc
};

// Of the light that pits scatter at normal incidence, the part that is not evanescent.
optics::Curve propagatingScattering(const scene::OpticalDisc& disc);

// Share of the light of a wavelength that the disc reflects like a mirror, under this cosine with the normal;
// `isTrack` false: where there is plain metal.
double mirroredShare(const OpticalDisc& disc, const TrackPoint& at, bool isTrack, double wavelength_nm);

// XYZ of the orders but 0 and of what the pits scatter, at the end of a path. Light comes from emitting
// surfaces and the sky: lamps without extent are in no order, as they have no radiance, and are scattered
// alone.
Xyz diffracted(const World& world, const OpticalDisc& disc, const TrackPoint& at,
               const Throughput& throughput, const Sampler& sampler, Dimension dimension);

}  // namespace fringe::oracle
