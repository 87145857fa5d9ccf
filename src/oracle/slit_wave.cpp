#include "oracle/slit_wave.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <numbers>

#include "oracle/beam.hpp"
#include "oracle/quadrature.hpp"
#include "oracle/sinc.hpp"
#include "oracle/spectral.hpp"

namespace fringe::oracle {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

// Rows of slits narrower than this share the section along the slits: the edge of a round beam that is wider
// than a millimetre bends by less than 0.05 um over it, a ten-thousandth of Fresnel's unit at any distance of
// interest.
constexpr double kNarrow = 20e-6;

// More slits than this do not change the share that propagates: 2 / (pi^2 count) of an order at the horizon.
constexpr std::uint32_t kManySlits = 2000;

// Power per metre of a slit at `x`, relative to the irradiance at the beam's middle.
double chordPower(const scene::Beam& beam, double x) {
    if (beam.profile != scene::BeamProfile::gaussian) return 2.0 * halfChord(beam, x);
    return relativeIrradiance(beam, x, 0.0) * 0.5 * beam.height.si * std::sqrt(0.5 * pi);
}

}  // namespace

SlitWave::SlitWave(const scene::Grating& grating, const optics::Slits& slits)
    : slits_(slits),
      beam_(grating.beam),
      efficiencies_(grating.efficiencies),
      irradiance_(peakIrradiance(grating.beam)) {
    double passing = 0.0;
    for (std::uint32_t i = 0; i < slits.count; ++i) {
        const double x = (i - 0.5 * (slits.count - 1.0)) * slits.period.si;
        const double half = halfChord(beam_, x);
        if (half <= 0.0) continue;
        lit_.push_back({x, half, std::sqrt(relativeIrradiance(beam_, x, 0.0))});
        passing += irradiance_ * slits.width.si * chordPower(beam_, x);
    }
    if (grating.efficiency) irradiance_ *= *grating.efficiency / passing;
}

SlitWave::View SlitWave::view(const glm::dvec3& offset, const glm::dvec3& normal,
                              const glm::dvec2& incident) const {
    View view{{}, incident.x, incident.y};
    for (const auto& [x, half, amplitude] : lit_) {
        const Front front = frontAt(beam_, incident, x);
        const double across = offset.x - x;
        const double fromSlit = std::hypot(across, offset.z);
        // The shortest way keeps the direction cosine along the slit.
        const double conical = std::sqrt(1.0 - front.beta * front.beta);
        const double distance = fromSlit / conical;
        const glm::dvec3 direction(across / distance, front.beta, offset.z / distance);
        const double facing = std::max(0.0, -glm::dot(direction, normal));
        const double spreading = direction.z * facing / (distance * distance);
        view.slits.push_back({.way = front.way + conical * fromSlit + front.beta * offset.y,
                              .u = direction.x - front.alpha,
                              .weight = amplitude * std::sqrt(spreading),
                              .half = half,
                              .travel = {.foot = offset.y - distance * front.beta,
                                         .curvature = conical * conical / distance,
                                         .convergence = front.convergence}});
    }
    return view;
}

double SlitWave::irradiance(const View& view, double wavelength) const {
    if (view.slits.empty()) return 0.0;
    return efficiencies_.empty() ? fromAmplitudeSlits(view, wavelength) : fromOrders(view, wavelength);
}

Complex SlitWave::section(const View::Slit& slit, double wavelength) const {
    if (beam_.profile == scene::BeamProfile::gaussian)
        return gaussianSection(0.5 * beam_.height.si, slit.travel, wavelength);
    return evenSection(slit.half, slit.travel, wavelength);
}

// Of each slit, per metre of its width.
std::vector<Complex> SlitWave::waves(const View& view, double wavelength) const {
    const bool shared = lit_.back().x - lit_.front().x < kNarrow;
    Complex along = section(view.slits[view.slits.size() / 2], wavelength);
    std::vector<Complex> result;
    result.reserve(view.slits.size());
    for (const View::Slit& slit : view.slits) {
        if (!shared) along = section(slit, wavelength);
        result.push_back(slit.weight * along * std::polar(1.0, 2.0 * pi * slit.way / wavelength));
    }
    return result;
}

double SlitWave::fromAmplitudeSlits(const View& view, double wavelength) const {
    const std::vector<Complex> wave = waves(view, wavelength);
    Complex sum = 0.0;
    for (std::size_t i = 0; i < wave.size(); ++i)
        sum += wave[i] * slits_.width.si * sinc(slits_.width.si * view.slits[i].u / wavelength);
    return irradiance_ * std::norm(sum) / (wavelength * wavelength);
}

// Each order as a grating without gaps that turns the light by the order's angle, with the order's share of
// the power; between orders there is no interference on average over a period.
double SlitWave::fromOrders(const View& view, double wavelength) const {
    const std::vector<Complex> wave = waves(view, wavelength);
    const double period = slits_.period.si;
    double total = 0.0;
    for (const scene::OrderEfficiency& order : efficiencies_) {
        const double alpha = view.alphaIn + order.order * wavelength / period;
        if (alpha * alpha + view.betaIn * view.betaIn >= 1.0) continue;  // evanescent
        Complex sum = 0.0;
        for (std::size_t i = 0; i < wave.size(); ++i)
            sum += wave[i] * period * sinc(period * view.slits[i].u / wavelength - order.order);
        total += curveAt(order.efficiency, 1e9 * wavelength) * std::norm(sum);
    }
    return irradiance_ * total / (wavelength * wavelength);
}

// The pattern of physics is even in its scale: light with a part along the slits behaves as light of a longer
// wavelength without one. Integrated over the direction cosine, a few points to each side lobe.
double SlitWave::propagatingShare(double wavelength, const glm::dvec2& incident) const {
    if (!efficiencies_.empty()) return 1.0;
    const double conical = std::sqrt(1.0 - incident.y * incident.y);
    const double count = std::min(slits_.count, kManySlits);
    const double a = slits_.width.si / wavelength;
    const double d = slits_.period.si / wavelength;
    const auto lobes = static_cast<std::size_t>(2.0 * conical * (count * d + a)) + 1;
    const std::size_t panels = (lobes + 1) / 2;
    double sum = 0.0;
    forNodes(-conical, conical, panels, [&](double alpha, double weight) {
        const double u = alpha - incident.x;
        const double oneSlit = sinc(a * u);
        const double divisor = count * std::sin(pi * d * u);
        const double array = std::abs(divisor) < 1e-9 ? 1.0 : std::sin(pi * count * d * u) / divisor;
        sum += weight * oneSlit * oneSlit * array * array;
    });
    return sum * count * a;
}

double SlitWave::spread(const View& view) {
    if (view.slits.empty()) return 0.0;
    const auto [least, most] =
        std::minmax_element(view.slits.begin(), view.slits.end(),
                            [](const View::Slit& p, const View::Slit& q) { return p.way < q.way; });
    return most->way - least->way;
}

glm::dvec3 SlitWave::source(const glm::dvec3& offset, const glm::dvec2& incident) const {
    const double half = 0.5 * beam_.height.si;
    const double distance = std::hypot(offset.x, offset.z) / std::sqrt(1.0 - incident.y * incident.y);
    return {0.0, std::clamp(offset.y - distance * incident.y, -half, half), 0.0};
}

glm::dvec2 SlitWave::extent() const {
    if (lit_.empty()) return {0.0, 0.0};
    return {lit_.back().x - lit_.front().x + slits_.width.si, beam_.height.si};
}

}  // namespace fringe::oracle
