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

// A mask's pixels each with the amplitude that the beam has there. (Other openings: see Opening.)
OpeningShape inBeam(OpeningShape shape, const scene::Beam& beam) {
    auto* mask = std::get_if<optics::MaskAperture>(&shape);
    if (mask == nullptr) return shape;
    for (std::uint32_t row = 0; row < mask->rows; ++row) {
        for (std::uint32_t column = 0; column < mask->columns; ++column) {
            const glm::dvec2 middle = pixelMiddle(*mask, column, row);
            float& amplitude = mask->transmission[std::size_t{row} * mask->columns + column];
            amplitude *= static_cast<float>(std::sqrt(relativeIrradiance(beam, middle.x, middle.y)));
        }
    }
    return shape;
}

// The beam's profile for what does not take it up itself.
scene::Beam profileFor(const OpeningShape& shape, scene::Beam beam) {
    if (std::holds_alternative<optics::MaskAperture>(shape)) beam.profile = scene::BeamProfile::flat;
    return beam;
}

}  // namespace

OpeningWave::OpeningWave(const scene::Grating& grating, const OpeningShape& shape)
    : shape_(inBeam(shape, grating.beam)),
      beam_(profileFor(shape, grating.beam)),
      area_(openArea(shape_, beam_)),
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
    View view{{},
              {},
              glm::dvec2(direction) - incident,
              direction.z * facing / (distance * distance),
              std::abs(1.0 / distance - (focus_ ? 1.0 / *focus_ : 0.0))};
    if (facing <= 0.0) return view;
    constexpr double kShortest = 1e-9 * kFirst_nm;
    const double steepest = glm::length(view.turn) + 0.5 * extent_ * view.curvature;
    view.opening.emplace(shape_, steepest / kShortest, beam_);
    // Points of an uneven beam are many, and their ways need be found but once.
    const bool isEven = beam_.profile != scene::BeamProfile::gaussian;
    if (isEven && 0.25 * extent_ * extent_ * view.curvature < kLeastFresnelNumber * kShortest) return view;
    const glm::dvec3 axis(incident, std::sqrt(1.0 - glm::dot(incident, incident)));
    view.ways.emplace(kShortest);
    view.opening->forPoints(
        [&](const glm::dvec2& r, double weight) { view.ways->add(wayPast(r, offset, axis), weight); });
    return view;
}

// The beam reaches r earlier or later than the middle, and the point is further from it or nearer.
double OpeningWave::wayPast(const glm::dvec2& r, const glm::dvec3& offset, const glm::dvec3& incident) const {
    const glm::dvec3 at(r, 0.0);
    const double before = focus_ ? *focus_ - glm::length(*focus_ * incident - at) : glm::dot(incident, at);
    return before + glm::length(offset - at) - glm::length(offset);
}

double OpeningWave::irradiance(const View& view, double wavelength) const {
    if (!view.opening) return 0.0;
    const std::complex<double> amplitude =
        view.ways ? view.ways->wave(wavelength) : view.opening->amplitude(view.turn / wavelength);
    return power_ * std::norm(amplitude) / (wavelength * wavelength * area_) * view.geometry;
}

double OpeningWave::propagatingShare(double wavelength, const glm::dvec2& incident) const {
    return oracle::propagatingShare(shape_, beam_, wavelength, incident);
}

double OpeningWave::spread(const View& view) const {
    return extent_ * (glm::length(view.turn) + 0.25 * extent_ * view.curvature);
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
