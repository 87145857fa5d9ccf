#include "compile/beam_profile.hpp"

#include <cmath>

#include "compile/near_field.hpp"

namespace fringe::compile {

double fallToRim(const scene::Grating& grating) {
    if (grating.beam.profile != scene::BeamProfile::gaussian) return 0.0;
    const double across = wholeExtent(grating.aperture) / (grating.beam.width / units::m);
    return 1.0 - std::exp(-2.0 * across * across);
}

std::optional<double> profileAcross(const scene::Grating& grating, double fresnelNumber) {
    constexpr double kEven = 0.01;
    if (grating.beam.profile != scene::BeamProfile::gaussian) return {};
    const double width = grating.beam.width / units::m;
    if (std::holds_alternative<optics::MaskAperture>(grating.aperture)) return width;
    if (std::holds_alternative<optics::LatticeAperture>(grating.aperture)) return {};
    if (hasNearField(grating.aperture) && fresnelNumber > kFarFieldNumber) return {};
    return fallToRim(grating) > kEven ? std::optional(width) : std::nullopt;
}

}  // namespace fringe::compile
