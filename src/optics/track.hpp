// The track of an optical disc as a reflection grating: a binary phase profile, pits of one depth in a flat
// mirror, by scalar theory. Along the track pits and lands alternate at random; what all tracks have in
// common makes the orders, and what they do not have in common is scattered. Trustworthy for structures above
// about two wavelengths; below, the real efficiencies depend on polarisation, and measured ones can be given
// instead.
#pragma once

#include "units/units.hpp"

namespace fringe::optics {

struct Track {
    units::Length pitch;
    units::Length pitWidth;  // < pitch
    units::Length depth;     // times the refractive index over the track
    double pitShare;         // of the track's length that is pit, 0..1

    // Pits and lands have random lengths (exponential, so that a random telegraph signal runs along the
    // track). No standard fixes the mean; 2.5 widths lie between those of the three media (1.95 to 2.8).
    units::Length meanPitLength() const { return 2.5 * pitWidth; }
    // Over which the scattered light's phases agree along the track.
    units::Length correlationLength() const { return (1.0 - pitShare) * meanPitLength(); }
};

// |e^{i phase} - 1|^2 of the phase that pits lag behind: 4 sin^2(2 pi depth (cosines)/(2 wavelength)).
// `cosines`: of incidence and diffraction, within the medium over the track, together.
double phaseContrast(const Track& track, units::Length wavelength, double cosines);

// Share of order m != 0 for a phase contrast of 1: (share of pits in the area)^2 sinc^2(m width/pitch).
double orderStrength(const Track& track, int order);

// Share of the reflected light that goes into order m; all orders, evanescent ones too, and the scattered
// light have the sum 1 for equal `cosines`.
double orderEfficiency(const Track& track, int order, units::Length wavelength, double cosines);

// Share that is scattered.
double scatteredShare(const Track& track, units::Length wavelength, double cosines);

// How scattered light is spread over the changes of direction cosine across (u) and along the track (v): the
// slit factor of a pit's width times the spectrum of a random telegraph signal. Its integral over the plane
// is 1.
double scatteringDensity(const Track& track, units::Length wavelength, double u, double v);

// The part of that integral that propagates at normal incidence, u^2 + v^2 < 1. Error below 1e-6.
double propagatingScattering(const Track& track, units::Length wavelength);

// ---- grooves that are many wavelengths wide ------------------------------------------------------

// A continuous groove of ten micrometres or more, such as a record's: not a step but an arc, of which each
// part reflects like a mirror of its own slope. A parabola has all slopes up to the steepest equally often.
bool isWideGroove(const Track& track);

// At the groove's edge, times the refractive index over the track.
double steepestSlope(const Track& track);

// Share of order m != 0 of a wide groove: the part of the groove, by stationary phase, whose slope sends
// light there. The flat land between grooves reflects the rest without deviation.
double grooveEfficiency(const Track& track, int order, units::Length wavelength, double cosines);

}  // namespace fringe::optics
