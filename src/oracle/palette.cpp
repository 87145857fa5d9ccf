#include "oracle/palette.hpp"

#include <utility>

namespace fringe::oracle {

std::size_t Palette::addSpectrum(const optics::Spectrum& spectrum) {
    Light light{sampled(spectrum), {}, sampled(spectrum, 4000)};
    for (std::size_t i = 0; i < reflectances_.size(); ++i)
        light.colors.push_back(sum(light.samples, passage(i, {})));
    lights_.push_back(std::move(light));
    return lights_.size() - 1;
}

std::size_t Palette::addReflectance(const optics::Curve& reflectance) {
    reflectances_.push_back(reflectance);
    const std::size_t index = reflectances_.size() - 1;
    for (Light& light : lights_) light.colors.push_back(sum(light.samples, passage(index, {})));
    return index;
}

Xyz Palette::color(std::size_t spectrum, std::size_t reflectance, const Throughput& throughput) const {
    const Light& light = lights_[spectrum];
    if (throughput.isConstant()) return throughput.constantPart() * light.colors[reflectance];
    return sum(light.samples, passage(reflectance, throughput));
}

Xyz Palette::sum(const std::vector<SpectralSample>& samples, const Passage& passage) {
    Xyz total(0.0);
    for (const auto& [wavelength_nm, power] : samples) total += power * passage.at(wavelength_nm);
    return total;
}

}  // namespace fringe::oracle
