// What slits make of a continuous spectrum: the colour of the light they send out as a function of the change
// in direction cosine, u = alpha_out - alpha_in, integrated over wavelength in double precision. The device
// interpolates in it.
#pragma once

#include <memory>
#include <vector>

#include "compile/spectral.hpp"
#include "optics/aperture.hpp"

namespace fringe::compile {

// Slits in a beam.
struct LitSlits {
    optics::Slits slits;
    std::vector<scene::OrderEfficiency> orders;  // empty: those of an amplitude grating
    double alphaIn;                              // direction cosines of the beam, across and along the slits
    double betaIn;

    // Share of what leaves an amplitude grating that is not evanescent; 1 where the orders are given.
    double propagatingShare(double wavelength_nm) const;
};

// Power per direction cosine, as the film records it, for one watt that leaves the slits, before the share of
// it that is evanescent is put back: the entry for u is the integral over wavelength of
//   S(l) response(l) (N a / (l eta(l))) sinc^2(a u/l) Fej_N(d u/l)
// with Fej_N = (sin(N pi t) / (N sin(pi t)))^2, or where the orders' efficiencies e_m are given, for one watt
// that arrives,
//   S(l) response(l) (N d / l) sum_m e_m(l) sinc^2(N (d u/l - m)).
// Where `zeroOrder` is false its term sinc^2(N t) is left out.
struct SlitResponse {
    device::uint zeroEntry;  // the entry for u = 0
    double perU;             // entries per unit of u
    device::uint entries;
    double integralUnit;  // of the entries, in colour times steps
    double slopeUnit;     // in colour per step
    std::vector<device::ResponseEntry>
        values;  // [reflectance][sum of the bands, then each if `inBands`][entry]
};

// `tables` must know all reflectances. `perU`: entries per unit of u (chooseEvaluator()), of which a draft
// has an eighth or less. From the memo of `tables`, if there.
std::shared_ptr<const SlitResponse> slitResponse(const LitSlits& lit, const optics::Spectrum& spectrum,
                                                 const SpectralTables& tables, bool zeroOrder, double perU);

}  // namespace fringe::compile
