// Where the power of an aperture goes: how much of a beam passes, and how much of that leaves as light.
//
// Of an aperture that lets Phi through, the radiant intensity is Phi gamma |A|^2 / (wavelength^2 area share),
// and that of slits, per unit of alpha, Phi |A|^2 count / (wavelength count width share), with A of
// transform.hpp and `share` from here: then the sphere of directions receives Phi at every wavelength. The
// obliquity factor gamma is the one that makes Parseval's theorem exact (J. E. Harvey et al., "Diffracted
// radiance: a fundamental quantity in nonparaxial scalar diffraction theory", Applied Optics 38, 6469, 1999).
#pragma once

#include "optics/aperture.hpp"

namespace fringe::optics {

// Share of |A|^2 that belongs to directions: the rest is evanescent. 0..1, near 1 for openings of many
// wavelengths. `alphaIn`, `betaIn`: direction cosines of the light that comes in, across and along the slits.
//
// Errors: 1e-9 for slits up to 10^4 and for circles at normal incidence; 2e-6 for more slits, circles, rings,
// and polygons of at most 32 vertices (more: 1e-5); for lattices 1e-6 if the whole spans at most 60
// wavelengths, else 1e-3 where an order is about to leave and 1e-4 elsewhere (2e-4 and 2e-5 where more than
// 2000 orders propagate). For a mask ask its MaskSpectrum: here one is made for the call.
double propagatingShare(const Aperture& aperture, units::Length wavelength, double alphaIn, double betaIn);

// Profile of a beam: a flat or Gaussian disc, a flat rectangle.
enum class BeamProfile { flat, gaussian, rectangle };

// Power per area, 1/m^2, in the middle of a beam of one watt; sizes as below.
double centralIrradiance(double beamWidth, double beamHeight, BeamProfile profile);

// Share of a beam's power that an aperture in its middle lets through. `beamWidth` lies across the slits,
// `beamHeight` along them, in metres: diameters of the disc, 1/e^2 diameters of the Gaussian (discs are
// circular: the width counts). Slits reach past the beam along their length; one that lies outside lets
// nothing through. Other openings have to lie inside a flat beam.
double openFraction(const Aperture& aperture, double beamWidth, double beamHeight, BeamProfile profile);

}  // namespace fringe::optics
