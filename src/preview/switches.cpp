#include "preview/switches.hpp"

#include <utility>
#include <vector>

namespace fringe::preview {
namespace {

// The light of the band, as a line in its middle; of no power where there is none, so that every wavelength
// has the same pipeline.
optics::Spectrum within(const optics::Spectrum& spectrum, double wavelength_nm) {
    const optics::Curve band{{wavelength_nm - 0.5 * kBand_nm, 1.0}, {wavelength_nm + 0.5 * kBand_nm, 1.0}};
    const double power = optics::visiblePower(optics::filtered(spectrum, band));
    return {{}, {{wavelength_nm * units::nm, power, 0.0 * units::nm}}};
}

bool isMatt(const scene::Material& material) {
    return std::holds_alternative<scene::Diffuse>(material.model) ||
           std::holds_alternative<scene::Emissive>(material.model);
}

}  // namespace

scene::Scene switched(scene::Scene scene, const Switches& switches) {
    std::vector<scene::Light> lit;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const bool knowsColors = std::holds_alternative<scene::ThesisGrating>(scene.lights[i].model);
        const bool isDark = switches.darkLights.contains(i) || (switches.wavelength_nm && knowsColors);
        if (!isDark) lit.push_back(std::move(scene.lights[i]));
    }
    scene.lights = std::move(lit);
    scene.castsShadows = !switches.noShadows;
    for (scene::Material& material : scene.materials) {
        if (switches.mattOnly && !isMatt(material))
            material.model = scene::Diffuse{optics::constantCurve(0.5)};
    }
    if (!switches.wavelength_nm) return scene;
    for (scene::Light& light : scene.lights) light.spectrum = within(light.spectrum, *switches.wavelength_nm);
    for (scene::Material& material : scene.materials) {
        if (auto* emissive = std::get_if<scene::Emissive>(&material.model))
            emissive->spectrum = within(emissive->spectrum, *switches.wavelength_nm);
    }
    return scene;
}

}  // namespace fringe::preview
