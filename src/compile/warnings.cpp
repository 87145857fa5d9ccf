#include "compile/warnings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "compile/beam_profile.hpp"
#include "compile/near_field.hpp"

namespace fringe::compile {
namespace {

constexpr double kEven = 0.1;  // of the irradiance in the middle, by which it may fall to the rim

std::optional<std::string> nearFieldWarning(const scene::Scene& scene, const scene::Grating& grating) {
    if (hasNearField(grating.aperture)) return {};
    const auto [distance, number] = nearestField(scene, grating);
    if (number <= kFarFieldNumber) return {};
    if (const auto profile = profileAcross(grating, number); profile && profile->isWhole) return {};
    const double half = 0.5 * openingExtent(grating.aperture);
    const bool isLattice = std::holds_alternative<optics::LatticeAperture>(grating.aperture);
    return fmt::format(
        "the far field of {} is shown, which is wrong as near as this: its Fresnel number is {:.2g} at "
        "{:.3g} m, and the far field is where it is below {:g}. Let the light fall on surfaces {:.2g} m away "
        "and beyond, or focus the beam on them (\"focus\": \"{:.3g} m\")",
        isLattice ? "each opening" : "the opening", number, distance, kFarFieldNumber,
        half * half / (kFarFieldNumber * kFresnelWavelength), distance);
}

std::optional<std::string> profileWarning(const scene::Scene& scene, const scene::Grating& grating) {
    const double fall = fallToRim(grating);
    if (!(fall > kEven) || profileAcross(grating, nearestField(scene, grating).fresnelNumber)) return {};
    return fmt::format(
        "the opening is lit evenly{}, though the Gaussian beam falls by {:.0f} % from its middle to its rim. "
        "The power is right, the pattern that of an even beam. A beam of {:.3g} mm would fall by {:.0f} %",
        hasNearField(grating.aperture) ? " in its near field" : "", 100.0 * fall,
        1e3 * wholeExtent(grating.aperture) / std::sqrt(-0.5 * std::log(1.0 - kEven)), 100.0 * kEven);
}

}  // namespace

std::vector<Warning> warningsOf(const scene::Scene& scene) {
    std::vector<Warning> warnings;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const scene::Light& light = scene.lights[i];
        const auto* grating = std::get_if<scene::Grating>(&light.model);
        if (grating == nullptr || std::holds_alternative<optics::Slits>(grating->aperture)) continue;
        const std::string name = light.name.empty() ? fmt::format("lights[{}]", i) : light.name;
        for (const auto& message : {nearFieldWarning(scene, *grating), profileWarning(scene, *grating)}) {
            if (message) warnings.push_back({name, *message});
        }
    }
    return warnings;
}

}  // namespace fringe::compile
