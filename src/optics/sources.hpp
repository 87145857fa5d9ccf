// Light sources: standard illuminants, lamps, hot bodies, diodes and lasers. Every spectrum here holds one
// watt of visible power.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "optics/spectrum.hpp"

namespace fringe::optics {

// A source that has a name: CIE illuminants A, D50, D65, E, the fluorescent lamps F2, F7, F11 and the white
// diode LED-B3 (CIE 15); the lines of hydrogen, mercury, neon and sodium vapour (NIST). Nothing for other
// names; upper and lower case matter.
std::optional<Spectrum> namedSpectrum(std::string_view name);

// The names, for messages.
std::span<const std::string_view> namedSpectra();

// A black body, by Planck's law (CODATA 2018). Precondition: kelvin > 0, and hot enough to have visible power
// in double precision (above 30 K).
Spectrum planck(double kelvin);

// A diode: Gaussian in wavelength. Precondition: fullWidth (at half maximum) > 0, peak visible.
Spectrum led(units::Length peak, units::Length fullWidth);

// One line. Precondition: linewidth (full, at half maximum) >= 0, wavelength visible.
Spectrum laser(units::Length wavelength, units::Length linewidth);

}  // namespace fringe::optics
