// What slits make of a continuous spectrum: the colour of the light they send out as a function of the change
// in direction cosine, u = alpha_out - alpha_in, integrated over wavelength in double precision. The device
// interpolates in it.
#pragma once

#include <vector>

#include "compile/spectral.hpp"
#include "optics/aperture.hpp"

namespace fringe::compile {

struct SlitBeam {
    double alphaIn;  // direction cosines of the beam, across and along the slits
    double betaIn;
};

// Power per direction cosine, as the film records it, for one watt that leaves the slits, before the share of
// it that is evanescent is put back: the entry for u is the integral over wavelength of
//   S(l) response(l) (N a / (l eta(l))) sinc^2(a u/l) Fej_N(d u/l)
// with Fej_N = (sin(N pi t) / (N sin(pi t)))^2. Where `zeroOrder` is false its term sinc^2(N t) is left out.
struct SlitResponse {
    double firstU;
    double perU;  // entries per unit of u
    device::uint entries;
    std::vector<float> values;  // [reflectance][sum of the bands, then each][density, prefix sum][entry][xyz]
};

// `tables` must know all reflectances. Interpolating linearly errs by about 2.5e-4 of the highest entry
// (docs/theory.md, "Tables").
SlitResponse slitResponse(const optics::Slits& slits, const SlitBeam& beam, const optics::Spectrum& spectrum,
                          const SpectralTables& tables, bool zeroOrder);

}  // namespace fringe::compile
