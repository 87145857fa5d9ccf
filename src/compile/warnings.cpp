#include "compile/warnings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "compile/beam_profile.hpp"
#include "compile/near_layers.hpp"

namespace fringe::compile {
namespace {

constexpr double kFallToTell = 0.1;  // of the irradiance in the middle, by which it may fall to the rim

std::optional<std::string> nearFieldWarning(const scene::Grating& grating, const NearestField& nearest) {
    const auto [distance, number, least] = nearest;
    const std::optional<UnevenBeam> profile = profileAcross(grating, number);
    if (hasNearLayers(grating.aperture, profile, number)) {
        if (number <= kMostLayer) return {};
        return fmt::format(
            "its Fresnel number is {:.3g} at {:.3g} m, and ripples are shown up to {:g}: at the rim of the "
            "opening's image they are {:.2g} times as wide as they should be",
            number, distance, kMostLayer, std::sqrt(number / kMostLayer));
    }
    if (!std::holds_alternative<optics::LatticeAperture>(grating.aperture)) return {};
    if (number <= kFarFieldNumber) return {};
    const double half = 0.5 * openingExtent(grating.aperture);
    return fmt::format(
        "the far field of each opening is shown, which is wrong as near as this: its Fresnel number is "
        "{:.2g} at {:.3g} m, and the far field is where it is below {:g}. Let the light fall on surfaces "
        "{:.2g} m away and beyond, or focus the beam on them (\"focus\": \"{:.3g} m\")",
        number, distance, kFarFieldNumber, half * half / (kFarFieldNumber * kFresnelWavelength), distance);
}

std::optional<std::string> profileWarning(const scene::Grating& grating, const NearestField& nearest) {
    const double fall = fallToRim(grating);
    if (!(fall > kFallToTell) || profileAcross(grating, nearest.fresnelNumber)) return {};
    return fmt::format(
        "the opening is lit evenly, though the Gaussian beam falls by {:.0f} % from its middle to its rim. "
        "The power is right, the pattern that of an even beam. A beam of {:.3g} mm would fall by {:.0f} %",
        100.0 * fall, 1e3 * wholeExtent(grating.aperture) / std::sqrt(-0.5 * std::log(1.0 - kFallToTell)),
        100.0 * kFallToTell);
}

}  // namespace

std::vector<Warning> warningsOf(const scene::Scene& scene) {
    std::vector<Warning> warnings;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const scene::Light& light = scene.lights[i];
        const auto* grating = std::get_if<scene::Grating>(&light.model);
        if (grating == nullptr || std::holds_alternative<optics::Slits>(grating->aperture)) continue;
        const std::string name = light.name.empty() ? fmt::format("lights[{}]", i) : light.name;
        const NearestField nearest = nearestField(scene, *grating);
        for (const auto& message : {nearFieldWarning(*grating, nearest), profileWarning(*grating, nearest)}) {
            if (message) warnings.push_back({name, *message});
        }
    }
    return warnings;
}

}  // namespace fringe::compile
