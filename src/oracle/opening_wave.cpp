#include "oracle/opening_wave.hpp"

#include <cmath>
#include <complex>
#include <glm/geometric.hpp>

#include "oracle/beam.hpp"
#include "oracle/opening_share.hpp"
#include "oracle/spectral.hpp"

namespace fringe::oracle {
namespace {

// Below this Fresnel number of the whole the far field is right to 1e-5.
constexpr double kLeastFresnelNumber = 2e-3;

}  // namespace

OpeningWave::OpeningWave(const scene::Grating& grating, const OpeningShape& shape)
    : shape_(shape),
      area_(openArea(shape)),
      extent_(oracle::extent(shape)),
      power_(grating.efficiency ? *grating.efficiency
                                : peakIrradiance(grating.beam) * openArea(shape, grating.beam)) {
    if (grating.beam.focus) focus_ = grating.beam.focus->si;
}

OpeningWave::View OpeningWave::view(const glm::dvec3& offset, const glm::dvec3& normal,
                                    const glm::dvec2& incident) const {
    const double distance = glm::length(offset);
    const glm::dvec3 direction = offset / distance;
    const double facing = -glm::dot(direction, normal);
    const double along = std::sqrt(1.0 - glm::dot(incident, incident));
    View view{{},
              glm::dvec2(direction) - incident,
              direction.z * facing / (distance * distance),
              offset,
              glm::dvec3(incident, along)};
    const double steepest = glm::length(view.turn) + 0.5 * extent_ * curvature(view);
    if (facing > 0.0) view.opening.emplace(shape_, steepest / (1e-9 * kFirst_nm));
    return view;
}

double OpeningWave::curvature(const View& view) const {
    return std::abs(1.0 / glm::length(view.offset) - (focus_ ? 1.0 / *focus_ : 0.0));
}

// The beam reaches r earlier or later than the middle, and the point is further from it or nearer.
double OpeningWave::turns(const View& view, const glm::dvec2& r, double wavelength) const {
    const glm::dvec3 at(r, 0.0);
    double way = glm::length(view.offset - at) - glm::length(view.offset);
    if (focus_) way += *focus_ - glm::length(*focus_ * view.incident - at);
    else way += glm::dot(view.incident, at);
    return way / wavelength;
}

double OpeningWave::irradiance(const View& view, double wavelength) const {
    if (!view.opening) return 0.0;
    const bool isFar = 0.25 * extent_ * extent_ * curvature(view) < kLeastFresnelNumber * wavelength;
    const double pattern =
        std::norm(isFar ? view.opening->amplitude(view.turn / wavelength)
                        : view.opening->sum([&](const glm::dvec2& r) { return turns(view, r, wavelength); }));
    return power_ * pattern / (wavelength * wavelength * area_) * view.geometry;
}

double OpeningWave::propagatingShare(double wavelength, const glm::dvec2& incident) const {
    return oracle::propagatingShare(shape_, wavelength, incident);
}

double OpeningWave::spread(const View& view) const {
    return extent_ * (glm::length(view.turn) + 0.25 * extent_ * curvature(view));
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
