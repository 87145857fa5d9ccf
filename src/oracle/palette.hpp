// The spectra and reflectances of a scene, and the colours that they make together.
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/spectral.hpp"
#include "oracle/throughput.hpp"

namespace fringe::oracle {

// Every colour is a sum over wavelengths of spectrum, reflectance, throughput and the film's response. Where
// the throughput is the same for all of them the sum is made once.
class Palette {
public:
    // Of what is seen directly.
    static constexpr std::size_t kWhite = 0;

    explicit Palette(Response response = filmResponse)
        : response_(response), reflectances_{{{kFirst_nm, 1.0}, {kLast_nm, 1.0}}} {}

    std::size_t addSpectrum(const optics::Spectrum& spectrum);
    std::size_t addReflectance(const optics::Curve& reflectance);

    std::size_t spectrumCount() const { return lights_.size(); }
    // For light whose way depends on its wavelength: ten samples a nanometre.
    const std::vector<SpectralSample>& fineSamples(std::size_t spectrum) const {
        return lights_[spectrum].fine;
    }

    // The passage keeps a reference to the throughput.
    Passage passage(std::size_t reflectance, const Throughput& throughput) const {
        return {reflectances_[reflectance], throughput, response_};
    }

    // Of a radiance of 1 W/(m^2 sr) of this spectrum, times the reflectance, at the end of a path.
    Xyz color(std::size_t spectrum, std::size_t reflectance, const Throughput& throughput) const;

private:
    struct Light {
        std::vector<SpectralSample> samples;
        std::vector<Xyz> colors;  // per reflectance, without a path
        std::vector<SpectralSample> fine;
    };

    static Xyz sum(const std::vector<SpectralSample>& samples, const Passage& passage);

    Response response_;
    std::vector<Light> lights_;
    std::vector<optics::Curve> reflectances_;
};

}  // namespace fringe::oracle
