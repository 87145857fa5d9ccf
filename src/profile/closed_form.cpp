#include "profile/closed_form.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <numbers>

#include "optics/energy.hpp"
#include "optics/integrals.hpp"
#include "optics/orders.hpp"
#include "optics/quadrature.hpp"
#include "optics/transform.hpp"

namespace fringe::profile {
namespace {

using namespace units;
using optics::sincSquared;

constexpr double kNanometre = 1e-9;

// Up to so many slits the orders overlap enough to be taken together.
constexpr double kFewSlits = 64.0;

// So many Fresnel widths inside of both edges their ripple is below 0.9 %, and in a continuum hidden.
constexpr double kFarFromEdge = 100.0;

// How far from its middle an order is followed, in orders: beyond, of more than kFewSlits, 1e-5 is left.
constexpr double kOrderReach = 1.6;

// Below this many turns at its ends a wave counts as flat.
constexpr double kFlat = 1e-4;

// From this share of a round beam's width on, the slits at its sides are shorter than those in its middle
// (by 2 %).
constexpr double kRoundFrom = 0.2;

// Up to so many turns of the wave across a round beam it is added up chord by chord, so many lobes far.
constexpr double kMostTurns = 30.0, kDiscLobes = 40.0;

// Pieces of a round beam, of eight chords each; one more for every turn of the wave.
constexpr double kFewestPieces = 3.0;

// Sines that stand for a range of them: of the wave of one wavelength, for each half of its lobe; of a
// continuum.
constexpr double kPerLobe = 8.0, kMostSines = 64.0;
constexpr int kSines = 7;

double sinc2Integral(double x) {
    return std::copysign(0.5 * optics::centralShare(std::abs(x)), x);
}

// Mean of sinc^2(count t) for t within +-h.
double lobeMean(double count, double t, double h) {
    if (h * count < 1e-3) return sincSquared(count * t);
    return (sinc2Integral(count * (t + h)) - sinc2Integral(count * (t - h))) / (2.0 * h * count);
}

// Mean of (sin(N pi t)/(N sin(pi t)))^2, 1 in every order, for t within +-h: the array factor as a Fourier
// series (1 + 2 sum of (1 - k/N) cos(2 pi k t))/N, each term averaged.
double fewSlitsMean(double count, double t, double h) {
    double sum = 1.0;
    for (double k = 1.0; k < count; ++k) {
        const double mean = h > 0.0 ? optics::sinc(2.0 * k * h) : 1.0;
        sum += 2.0 * (1.0 - k / count) * mean * std::cos(2.0 * std::numbers::pi * k * t);
    }
    return sum / count;
}

// Integral of exp(2 pi i (curvature x^2/2 - slope x)/wavelength) over |x| < half, over 2 half and but for a
// phase that does not depend on `half`: what a strip of a wave sends in a direction that differs by `slope`,
// or to a place near it. Fresnel's pattern of two edges; where the wave is not curved, sinc.
std::complex<double> stripAmplitude(double half, double slope, double curvature, double wavelength) {
    const double width = 2.0 * half;
    if (std::abs(curvature) * half * half < kFlat * wavelength)
        return optics::sinc(width * slope / wavelength);
    const double scale = std::sqrt(2.0 * std::abs(curvature) / wavelength);
    const double foot = std::abs(slope / curvature);
    const double low = scale * (-half - foot), high = scale * (half - foot);
    const std::complex<double> inside = low < -kFarFromEdge && high > kFarFromEdge
                                            ? std::complex<double>(1.0, 1.0)
                                            : optics::fresnelIntegrals(high) - optics::fresnelIntegrals(low);
    return (curvature > 0.0 ? inside : std::conj(inside)) / (scale * width);
}

double strip(double half, double slope, double curvature, double wavelength) {
    return std::norm(stripAmplitude(half, slope, curvature, wavelength));
}

// Half of the range of a function's change within +-reach, as a straight line.
template <class Function>
double halfChange(dvec3 point, dvec3 reach, const Function& function) {
    return 0.5 * std::abs(function(point + reach) - function(point - reach));
}

}  // namespace

std::optional<ClosedForm> ClosedForm::of(const scene::Light& light) {
    const auto* grating = std::get_if<scene::Grating>(&light.model);
    if (grating == nullptr || std::holds_alternative<optics::MaskAperture>(grating->aperture)) return {};
    ClosedForm form(*grating);
    const optics::Curve all = optics::constantCurve(1.0);
    // One node for each nanometre of a continuum.
    for (const optics::Node& node : optics::densityNodes(light.spectrum.density, all)) {
        const double middle = (std::floor(node.wavelength_nm) + 0.5) * kNanometre;
        if (form.nodes_.empty() || form.nodes_.back().wavelength != middle)
            form.nodes_.push_back({middle, 0.0, kNanometre, 1.0});
        form.nodes_.back().power += node.weight;
    }
    for (const optics::Line& line : light.spectrum.lines)
        for (const optics::Node& node : optics::lineNodes(line, all))
            form.nodes_.push_back({node.wavelength_nm * kNanometre, node.weight, 0.0, 1.0});

    const scene::Beam& beam = grating->beam;
    const double width = beam.width / m, height = beam.height / m;
    const double open = optics::openFraction(grating->aperture, width, height, beam.profile);
    const double leaving = grating->efficiency.value_or(open);
    const double power = beam.power / W;
    for (Node& node : form.nodes_) {
        const double eta =
            optics::propagatingShare(grating->aperture, node.wavelength * m, form.alphaIn_, form.betaIn_);
        if (const auto* slits = std::get_if<optics::Slits>(&grating->aperture)) {
            const double fill = slits->count > 1 ? slits->width / slits->period : 1.0;
            const double onPlane = power * optics::centralIrradiance(width, height, beam.profile);
            node.scale = onPlane * (open > 0.0 ? leaving / open : 0.0) *
                         (grating->efficiencies.empty() ? fill * fill / eta : 1.0);
        } else {
            node.scale = power * leaving / (optics::area(grating->aperture) * eta);
        }
    }
    return form;
}

ClosedForm::ClosedForm(const scene::Grating& grating)
    : grating_(grating),
      across_(glm::cross(grating.slitDirection, grating.normal)),
      alphaIn_(glm::dot(grating.beam.direction, across_)),
      betaIn_(glm::dot(grating.beam.direction, grating.slitDirection)),
      conical_(std::sqrt(1.0 - betaIn_ * betaIn_)),
      convergence_(grating.beam.focus ? 1.0 / (*grating.beam.focus / m) : 0.0),
      count_(1.0) {
    if (auto* slits = std::get_if<optics::Slits>(&grating_.aperture)) {
        if (slits->count == 1) slits->period = slits->width;
        const double inBeam = grating.beam.width / slits->period;
        count_ = std::max(1.0, std::min(1.0 * slits->count, inBeam));
        isRound_ = grating.beam.profile == scene::BeamProfile::flat && slits->count > kRoundFrom * inBeam;
    }
}

ClosedForm::Offset ClosedForm::offset(dvec3 point) const {
    const dvec3 from = point - grating_.position;
    return {glm::dot(from, across_), glm::dot(from, grating_.slitDirection), glm::dot(from, grating_.normal)};
}

double ClosedForm::irradiance(dvec3 point, dvec3 normal, dvec3 reach) const {
    if (offset(point).z <= 0.0) return 0.0;
    const auto* slits = std::get_if<optics::Slits>(&grating_.aperture);
    return slits != nullptr ? slitIrradiance(*slits, point, normal, reach) : openingIrradiance(point, normal);
}

// ---- slits --------------------------------------------------------------------------------------

double ClosedForm::sine(const Offset& o) const {
    return conical_ * o.x / std::hypot(o.x, o.z) - alphaIn_;
}

// E = E0 N d z/rho^2 facing (N d/lambda) sum of the orders, times the beam's section along the slits
// (docs/theory.md, "Slits").
double ClosedForm::slitIrradiance(const optics::Slits& slits, dvec3 point, dvec3 normal, dvec3 reach) const {
    const Offset o = offset(point);
    const double rho = std::hypot(o.x, o.z), distance = rho / conical_;
    const double along = o.y - distance * betaIn_;  // from where the light comes
    const dvec3 source = grating_.position + along * grating_.slitDirection;
    const double facing = glm::dot(glm::normalize(source - point), normal);
    if (facing <= 0.0) return 0.0;

    const double alpha = conical_ * o.x / rho;
    const double fromReach = halfChange(point, reach, [&](dvec3 p) { return sine(offset(p)); });
    const double fromLamp = 0.5 * (grating_.beam.angularSize / rad);
    const View view{sine(o), std::hypot(fromReach, fromLamp), (1.0 - alpha * alpha) / distance - convergence_,
                    along, distance};

    double sum = 0.0;
    for (const Node& node : nodes_)
        sum += node.power * node.scale / node.wavelength * slitPattern(slits, node, view);
    const double lit = count_ * (slits.period / m);
    return sum * lit * lit * o.z / (rho * rho) * facing;
}

// Mean over the view's sines of sinc^2(a u/lambda) times the array factor, 1 in order 0, or where the orders
// have given shares, of their sum; times the irradiance along the slits over that in the beam.
double ClosedForm::slitPattern(const optics::Slits& slits, const Node& node, const View& view) const {
    const double period = slits.period / m, halfLit = 0.5 * count_ * period;
    const double perOrder = node.wavelength / period;  // of the sine
    const double t = view.sine / perOrder, h = view.halfWidth / perOrder;
    const double cell = 0.5 * std::abs(t) * node.cell / node.wavelength;  // half, of the wavelength's range
    // Half of the orders that different slits see there.
    const double window = halfLit * std::abs(view.curvature) / perOrder;

    const double along = beamAlongSlits(node, view, 0.5 * (grating_.beam.height / m));
    // A round beam in its own near field is geometry, chord by chord, but for the ripple of the chords' ends.
    const bool isDisc = isRound_ && 0.25 * window * count_ < kMostTurns;
    const double reach = window + h + (isDisc ? kDiscLobes / count_ : kOrderReach);

    // One order's image of the lit slits.
    const auto image = [&](double order) {
        if (std::abs(t - order) > reach) return 0.0;
        if (!isRound_ && window * count_ < kFlat) return along * lobeMean(count_, t - order, h);
        const int sines = static_cast<int>(std::clamp(std::ceil(kPerLobe * h * count_), 1.0, kMostSines));
        double sum = 0.0;
        for (int i = 0; i < sines; ++i) {
            const double at = t + h * ((2.0 * i + 1.0) / sines - 1.0) - order;
            const double slope = at * perOrder;
            if (isDisc) sum += disc(node, slope, halfLit, view);
            else if (isRound_) sum += chord(node, slope, halfLit, view);
            else sum += along * strip(halfLit, slope, view.curvature, node.wavelength);
        }
        return sum / sines;
    };
    // The same in a continuum: the ranges of neighbouring wavelengths meet, so what one leaves out of an
    // order the next has. Order 0 does not change with wavelength.
    const auto share = [&](double order) {
        if (node.cell == 0.0 || order == 0.0) return image(order);
        const double spread = std::hypot(window, h);
        if (std::abs(t - order) > spread + cell + kOrderReach) return 0.0;
        double sum = 0.0;
        for (int i = 0; i < kSines; ++i)
            sum += lobeMean(count_, t + spread * ((2.0 * i + 1.0) / kSines - 1.0) - order, cell);
        return along * sum / kSines;
    };

    if (!grating_.efficiencies.empty()) {
        double sum = 0.0;
        for (const scene::OrderEfficiency& given : grating_.efficiencies)
            sum += optics::valueAt(given.efficiency, node.wavelength / kNanometre) * share(given.order);
        return sum;
    }
    const double envelope = sincSquared(t * (slits.width / slits.period));
    if (count_ <= kFewSlits) {
        const double blur = std::hypot(window, h, cell);
        return along * envelope * fewSlitsMean(count_, t, blur);
    }
    double sum = 0.0;
    for (double order = std::round(t - window - h) - 1.0; order <= std::round(t + window + h) + 1.0; ++order)
        sum += share(order);
    return envelope * sum;
}

// An order of slits in a round beam: chords across it, each with Fresnel's pattern of its two ends, over the
// square of the lit width; times the irradiance along the slits as beamAlongSlits() has it.
double ClosedForm::disc(const Node& node, double slope, double halfLit, const View& view) const {
    const double radius = 0.5 * (grating_.beam.width / m), wavelength = node.wavelength;
    const double straight = conical_ * conical_ / view.distance;
    const double bent = straight - convergence_;
    const double ends = std::asin(std::min(1.0, halfLit / radius));
    const double turns =
        (std::abs(slope) * halfLit + 0.5 * std::abs(view.curvature) * halfLit * halfLit) / wavelength;
    static const optics::GaussRule rule = optics::gaussLegendre(8);
    const auto pieces = static_cast<int>(kFewestPieces + turns);
    std::complex<double> sum = 0.0;
    for (int piece = 0; piece < pieces; ++piece) {
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double angle = ends * ((2.0 * piece + 1.0 + rule.nodes[i]) / pieces - 1.0);
            const double x = radius * std::sin(angle), half = radius * std::cos(angle);
            const double way = 0.5 * view.curvature * x * x - slope * x;
            sum += rule.weights[i] * half * stripAmplitude(half, view.along * straight, bent, wavelength) *
                   std::polar(2.0 * half, 2.0 * std::numbers::pi * way / wavelength);
        }
    }
    const double width = 2.0 * halfLit;
    return std::norm(sum * (ends / pieces) / width) * straight / wavelength;
}

// The same where the light comes straight from one chord.
double ClosedForm::chord(const Node& node, double slope, double halfLit, const View& view) const {
    const double radius = 0.5 * (grating_.beam.width / m), x = slope / view.curvature;
    const double half = std::sqrt(std::max(0.0, radius * radius - x * x));
    if (half <= 0.0) return 0.0;
    return beamAlongSlits(node, view, half) * strip(halfLit, slope, view.curvature, node.wavelength);
}

// The irradiance along the slits over that in the beam: Fresnel's, between the beam's two edges, or a
// Gaussian that stays one.
double ClosedForm::beamAlongSlits(const Node& node, const View& view, double half) const {
    const scene::Beam& beam = grating_.beam;
    const double straight = conical_ * conical_ / view.distance, y = view.along;
    const double bent = straight - convergence_;
    if (beam.profile == scene::BeamProfile::gaussian) {
        const double spread = node.wavelength / (std::numbers::pi * half * straight);
        const double radius = std::hypot(half * bent / straight, spread);
        return half / radius * std::exp(-2.0 * y * y / (radius * radius));
    }
    return 4.0 * half * half * straight / node.wavelength * strip(half, y * straight, bent, node.wavelength);
}

// ---- openings -----------------------------------------------------------------------------------

// E = Phi gamma |A|^2/(lambda^2 area eta) facing/R^2 (src/optics/energy.hpp).
double ClosedForm::openingIrradiance(dvec3 point, dvec3 normal) const {
    constexpr int kDirections = 5;  // in the lamp, across and along
    const double lamp = grating_.beam.angularSize / rad;
    const int directions = lamp > 0.0 ? kDirections : 1;
    const Offset o = offset(point);
    const double distance = glm::distance(point, grating_.position);
    const double facing = glm::dot((grating_.position - point) / distance, normal);
    if (facing <= 0.0) return 0.0;
    const auto shift = [&](int k) { return lamp * ((k + 0.5) / directions - 0.5); };
    double sum = 0.0;
    for (int i = 0; i < directions * directions; ++i) {
        const glm::dvec2 turn(o.x / distance - alphaIn_ - shift(i % directions),
                              o.y / distance - betaIn_ - shift(i / directions));
        for (const Node& node : nodes_) {
            const double amplitude = std::norm(optics::transform(grating_.aperture, turn / node.wavelength));
            sum += node.power * node.scale * amplitude / (node.wavelength * node.wavelength);
        }
    }
    return sum / (directions * directions) * (o.z / distance) * facing / (distance * distance);
}

// ---- a scene ------------------------------------------------------------------------------------

std::optional<ClosedFormProfile> closedFormAlong(const scene::Scene& scene, const SurfaceLine& line,
                                                 std::span<const dvec3> points,
                                                 const std::atomic<bool>& cancelled) {
    std::vector<ClosedForm> forms;
    ClosedFormProfile profile{std::vector<double>(points.size(), 0.0), 0, 0};
    for (const scene::Light& light : scene.lights) {
        if (auto form = ClosedForm::of(light)) forms.push_back(std::move(*form));
        else if (std::holds_alternative<scene::Grating>(light.model)) ++profile.masks;
        if (cancelled) return {};
    }
    if (forms.empty()) return {};
    profile.gratings = forms.size();
    const scene::Shape& shape = scene.objects[line.object].shape;
    const dvec3 reach = 0.5 / static_cast<double>(points.size()) * (line.to - line.from);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (cancelled) return {};
        const auto foot = footOn(shape, points[i]);
        const dvec3 own = foot ? foot->normal : line.normal;
        const dvec3 normal = glm::dot(own, line.normal) >= 0.0 ? own : -own;
        for (const ClosedForm& form : forms)
            profile.irradiance[i] += form.irradiance(points[i], normal, reach);
    }
    return profile;
}

}  // namespace fringe::profile
