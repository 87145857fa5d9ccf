#include "compile/beam_profile.hpp"

#include <cmath>

#include "compile/near_field.hpp"
#include "compile/uneven_lattice.hpp"
#include "optics/amplitude_grid.hpp"

namespace fringe::compile {

double fallToRim(const scene::Grating& grating) {
    if (grating.beam.profile != scene::BeamProfile::gaussian) return 0.0;
    const double across = wholeExtent(grating.aperture) / (grating.beam.width / units::m);
    return 1.0 - std::exp(-2.0 * across * across);
}

std::optional<UnevenBeam> profileAcross(const scene::Grating& grating, double fresnelNumber) {
    constexpr double kEven = 0.01;
    // Radii of the beam within which it has to be free to count as whole: beyond lie 1e-6 of its amplitude,
    // and in a near field, of whose ripples none are known then, 1e-3.
    constexpr double kFree = 3.7, kFreeNear = 2.6;
    if (grating.beam.profile != scene::BeamProfile::gaussian) return {};
    const double width = grating.beam.width / units::m;
    if (std::holds_alternative<optics::MaskAperture>(grating.aperture)) return UnevenBeam{width, false};
    if (!(fallToRim(grating) > kEven)) return {};
    if (const auto* lattice = std::get_if<optics::LatticeAperture>(&grating.aperture))
        return litCells(*lattice, width) ? std::optional(UnevenBeam{width, false}) : std::nullopt;
    const double free = fresnelNumber > kFarFieldNumber ? kFreeNear : kFree;
    const bool isWhole = optics::clearance(grating.aperture) >= 0.5 * width * free;
    return UnevenBeam{width, isWhole};
}

}  // namespace fringe::compile
