// What the device reads to compute the colour of slits without a table over u (shaders/evaluators.glsl): a
// table over wavelength that serves all orders, or a list of wavelengths to sum over.
#pragma once

#include <vector>

#include "compile/slit_response.hpp"

namespace fringe::compile {

// Steps of half a nanometre over the visible range.
inline constexpr int kOrderEntries = 801;

// A table of the light's power per micrometre of wavelength, as the film records it, over the share that
// propagates: what an order of share 1 sends out. Its argument is the wavelength in um. Behind the entries of
// each reflectance and band stands the integral of the density times the wavelength, as floats by their bits.
SlitResponse orderResponse(const LitSlits& lit, const optics::Spectrum& spectrum,
                           const SpectralTables& tables);

// `count` >= 2 wavelengths in even steps over the visible range. First, for each: the slits' period in it, as
// two floats, their width in it, and how many bands' middles it lies behind the first. Then, for each
// reflectance and wavelength, the colour of the pattern's peak: X, Y, Z per unit of u, and 0. All are floats
// by their bits. The colours are such that the sum is exact for what is linear between the wavelengths.
std::vector<device::ResponseEntry> waveList(const LitSlits& lit, const optics::Spectrum& spectrum,
                                            const SpectralTables& tables, device::uint count);

}  // namespace fringe::compile
