// A grating or another aperture in a beam, as a light: what falls on a surface that it shines on. Every
// wavelength is worked out for itself.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "oracle/opening_wave.hpp"
#include "oracle/ray.hpp"
#include "oracle/slit_wave.hpp"
#include "oracle/spectral.hpp"
#include "oracle/throughput.hpp"

namespace fringe::oracle {

class Grating {
public:
    // The spectrum is that of one watt of the beam.
    Grating(const scene::Grating& grating, optics::Spectrum spectrum);
    Grating(Grating&&) noexcept;
    Grating& operator=(Grating&&) noexcept;
    ~Grating();

    // From where light comes to `position`, for its shadows; nothing behind the grating.
    std::optional<dvec3> sourceFor(const dvec3& position) const;

    // Watts per square metre at a point in front, on the side of the unit vector `normal`, if the whole beam
    // has this wavelength. Averaged over the angular size of the source, a square of that side in direction
    // cosines.
    double irradiance(const dvec3& position, const dvec3& normal, double wavelength_nm) const;

    // What the film gets of the light that a matt surface there sends back, times pi: a sum over at least
    // `steps` steps of the visible range, more where the fringes ask for it.
    Xyz color(const dvec3& position, const dvec3& normal, const Passage& passage,
              std::size_t steps = 400) const;

private:
    using Wave = std::variant<SlitWave, OpeningWave>;
    class Shares;

    static Wave makeWave(const scene::Grating& grating);
    dvec3 local(const dvec3& world) const;
    std::vector<glm::dvec2> directions() const;

    // Calls use(views of the wave, one for each direction of the source).
    template <class Use>
    auto withViews(const dvec3& position, const dvec3& normal, const Use& use) const;

    dvec3 position_;
    dvec3 x_, y_, z_;  // the grating's frame
    scene::Beam beam_;
    optics::Spectrum spectrum_;
    glm::dvec2 incident_;  // direction cosines of the beam's axis
    Wave wave_;
    std::unique_ptr<Shares> shares_;  // that propagate
};

// What a matt surface of this reflectance sends back of the light of scene.lights[light], a grating, times
// pi, at a point in front of it; nothing is in the way. With a reflectance of 1 it is the colour of the
// irradiance.
Xyz irradianceXyz(const scene::Scene& scene, std::size_t light, const dvec3& position, const dvec3& normal,
                  const optics::Curve& reflectance, std::size_t wavelengthSteps = 400);

}  // namespace fringe::oracle
