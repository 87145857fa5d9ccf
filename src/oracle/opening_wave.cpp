#include "oracle/opening_wave.hpp"

#include <complex>
#include <glm/geometric.hpp>

#include "oracle/beam.hpp"
#include "oracle/opening_share.hpp"
#include "oracle/spectral.hpp"

namespace fringe::oracle {

OpeningWave::OpeningWave(const scene::Grating& grating, const OpeningShape& shape)
    : shape_(shape),
      area_(openArea(shape)),
      extent_(oracle::extent(shape)),
      power_(grating.efficiency ? *grating.efficiency
                                : peakIrradiance(grating.beam) * openArea(shape, grating.beam)) {}

OpeningWave::View OpeningWave::view(const glm::dvec3& offset, const glm::dvec3& normal,
                                    const glm::dvec2& incident) const {
    const double distance = glm::length(offset);
    const glm::dvec3 direction = offset / distance;
    const double facing = -glm::dot(direction, normal);
    View view{{}, glm::dvec2(direction) - incident, direction.z * facing / (distance * distance)};
    if (facing > 0.0) view.opening.emplace(shape_, glm::length(view.turn) / (1e-9 * kFirst_nm));
    return view;
}

double OpeningWave::irradiance(const View& view, double wavelength) const {
    if (!view.opening) return 0.0;
    const double pattern = std::norm(view.opening->amplitude(view.turn / wavelength));
    return power_ * pattern / (wavelength * wavelength * area_) * view.geometry;
}

double OpeningWave::propagatingShare(double wavelength, const glm::dvec2& incident) const {
    return oracle::propagatingShare(shape_, wavelength, incident);
}

double OpeningWave::spread(const View& view) const {
    return extent_ * glm::length(view.turn);
}

// The share of a single opening changes slowly.
double OpeningWave::shareStep_nm() const {
    return isEndless(shape_, 1e-9 * kLast_nm) ? 1.0 : 20.0;
}

glm::dvec3 OpeningWave::source(const glm::dvec3&, const glm::dvec2&) const {
    return glm::dvec3(0.0);
}

glm::dvec2 OpeningWave::extent() const {
    return {extent_, extent_};
}

}  // namespace fringe::oracle
