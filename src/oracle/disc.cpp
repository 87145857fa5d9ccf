#include "oracle/disc.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "oracle/fresnel.hpp"
#include "oracle/lighting.hpp"
#include "oracle/metals.hpp"
#include "oracle/sinc.hpp"

namespace fringe::oracle {
namespace {

using glm::dot;
using std::numbers::pi;
using units::nm, units::um;

double squared(double x) {
    return x * x;
}

// A disc at one wavelength; directions are those away from the surface, by their cosines across and along the
// track.
class Track {
public:
    Track(const OpticalDisc& surface, double wavelength_nm)
        : disc_(surface.model),
          propagatingScattering_(surface.propagatingScattering),
          wavelength_nm_(wavelength_nm),
          index_(disc_.metal ? disc_.coverIndex : 1.0),
          duty_(disc_.pitWidth / disc_.pitch),
          step_(wavelength_nm * nm / disc_.pitch) {}

    double step() const { return step_; }

    // Of a direction with this cosine with the normal, in the medium over the track.
    double cosineInside(double cosine) const {
        return std::sqrt(1.0 - (1.0 - squared(cosine)) / squared(index_));
    }

    // Phase by which the light from a pit lags.
    double phase(double cosIn, double cosOut) const {
        const double depths = disc_.pitDepth / (wavelength_nm_ * nm);
        return 2.0 * pi * index_ * depths * (cosineInside(cosIn) + cosineInside(cosOut));
    }

    // The tracks' common part: share of an order by its amplitude.
    double scalarShare(int order, double cosIn, double cosOut) const {
        const std::complex<double> lag = std::polar(1.0, phase(cosIn, cosOut)) - 1.0;
        const std::complex<double> amplitude = disc_.pitShare * duty_ * sinc(order * duty_) * lag;
        return std::norm(amplitude + (order == 0 ? 1.0 : 0.0));
    }

    double scatteredShare(double cosIn, double cosOut) const {
        const std::complex<double> lag = std::polar(1.0, phase(cosIn, cosOut)) - 1.0;
        return std::norm(lag) * duty_ * disc_.pitShare * (1.0 - disc_.pitShare);
    }

    // A wide groove is a parabola: the part of it that sends light into an order is where its slope's mirror
    // does, |d phase/dx| = 2 pi |order|/pitch, and grows evenly with the order.
    double grooveShare(int order, double cosIn, double cosOut) const {
        if (order == 0) return 1.0 - duty_;
        const double steepest = 4.0 * phase(cosIn, cosOut) / (disc_.pitWidth / disc_.pitch);
        const double ordersReached = steepest / (2.0 * pi);
        return std::abs(order) < ordersReached ? duty_ / (2.0 * ordersReached) : 0.0;
    }

    // `alpha`, `beta`: where the light comes from. Share of order `order` of what the mirror reflects: as
    // given, or by scalar theory, where propagating orders share what evanescent ones would take.
    double share(int order, double alpha, double beta, double cosOut) const {
        if (!disc_.efficiencies.empty()) {
            for (const scene::OrderEfficiency& given : disc_.efficiencies)
                if (given.order == order) return curveAt(given.efficiency, wavelength_nm_);
            return 0.0;
        }
        const double cosIn = std::sqrt(1.0 - squared(alpha) - squared(beta));
        if (disc_.pitShare == 1.0 && disc_.pitWidth >= 10.0 * um) return grooveShare(order, cosIn, cosOut);
        double sum = 0.0;
        const int last = static_cast<int>(2.0 / step_);
        for (int m = -last; m <= last; ++m) {
            const double cosSquared = 1.0 - squared(m * step_ - alpha) - squared(beta);
            if (cosSquared > 0.0) sum += scalarShare(m, cosIn, std::sqrt(cosSquared));
        }
        const double scattered = disc_.pitShare == 1.0 ? 0.0
                                                       : scatteredShare(cosIn, cosIn) *
                                                             curveAt(propagatingScattering_, wavelength_nm_);
        return scalarShare(order, cosIn, cosOut) * (1.0 - scattered) / sum;
    }

    double coverReflectance(double cosine) const {
        return disc_.metal ? reflectance(cosine, disc_.coverIndex) : 0.0;
    }

    // What cover and mirror leave of light that comes and goes under these cosines.
    double mirror(double cosIn, double cosOut) const {
        if (!disc_.metal) return reflectance(0.5 * (cosIn + cosOut), disc_.coverIndex);
        const double in = coverReflectance(cosIn), out = coverReflectance(cosOut);
        const double inside = 0.5 * (cosineInside(cosIn) + cosineInside(cosOut));
        const double metal =
            reflectance(inside, refractiveIndex(*disc_.metal, wavelength_nm_ * nm) / disc_.coverIndex);
        return (1.0 - in) * (1.0 - out) * metal / (1.0 - metal * std::sqrt(in * out));
    }

private:
    const scene::OpticalDisc& disc_;
    const optics::Curve& propagatingScattering_;
    double wavelength_nm_;
    double index_;  // over the track
    double duty_;
    double step_;  // of the direction cosine, from order to order
};

struct TrackFrame {
    dvec3 radial, along, normal;

    explicit TrackFrame(const TrackPoint& at)
        : radial(glm::normalize(at.position - at.center)),
          along(glm::cross(at.normal, radial)),
          normal(at.normal) {}
};

// The density of scattered light over the changes of direction cosine, per unit of both, as independent
// tracks have it, each with a random sequence of pits and lands of exponential lengths.
double scatteringDensity(const scene::OpticalDisc& disc, double wavelength_nm, double u, double v) {
    const double width = disc.pitWidth / (wavelength_nm * nm);
    const double turns = 2.5 * width * (1.0 - disc.pitShare);
    return width * squared(sinc(width * u)) * 2.0 * turns / (1.0 + squared(2.0 * pi * turns * v));
}

}  // namespace

optics::Curve propagatingScattering(const scene::OpticalDisc& disc) {
    optics::Curve curve;
    for (double wavelength_nm = kFirst_nm; wavelength_nm <= kLast_nm; wavelength_nm += 10.0) {
        constexpr int kSteps = 256;
        double sum = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const double radius = (i + 0.5) / kSteps;
            for (int j = 0; j < kSteps; ++j) {
                const double angle = 0.5 * pi * (j + 0.5) / kSteps;
                sum += 2.0 * pi * radius *
                       scatteringDensity(disc, wavelength_nm, radius * std::cos(angle),
                                         radius * std::sin(angle));
            }
        }
        curve.push_back({wavelength_nm, sum / (double{kSteps} * kSteps)});
    }
    return curve;
}

double mirroredShare(const OpticalDisc& surface, const TrackPoint& at, bool isTrack, double wavelength_nm) {
    const Track track(surface, wavelength_nm);
    const TrackFrame frame(at);
    const double cosine = dot(at.toEye, at.normal);
    const double share =
        isTrack ? track.share(0, -dot(at.toEye, frame.radial), -dot(at.toEye, frame.along), cosine) : 1.0;
    return track.coverReflectance(cosine) + share * track.mirror(cosine, cosine);
}

Xyz diffracted(const World& world, const OpticalDisc& surface, const TrackPoint& at,
               const Throughput& throughput, const Sampler& sampler, Dimension dimension) {
    const TrackFrame frame(at);
    const double alphaOut = dot(at.toEye, frame.radial), betaOut = dot(at.toEye, frame.along);
    const double cosOut = dot(at.toEye, frame.normal);
    Xyz sum(0.0);

    for (std::size_t spectrum = 0; spectrum < world.palette.spectrumCount(); ++spectrum) {
        const Passage passage = world.palette.passage(Palette::kWhite, throughput);
        for (const auto& [wavelength_nm, power] : world.palette.fineSamples(spectrum)) {
            const Track track(surface, wavelength_nm);
            const int last = static_cast<int>(2.0 / track.step());
            for (int order = -last; order <= last; ++order) {
                if (order == 0) continue;
                const double alpha = order * track.step() - alphaOut, beta = -betaOut;
                const double cosSquared = 1.0 - squared(alpha) - squared(beta);
                if (cosSquared <= 0.0) continue;
                const double cosIn = std::sqrt(cosSquared);
                const dvec3 direction = alpha * frame.radial + beta * frame.along + cosIn * frame.normal;
                const double radiance = emittedRadiance(world, at.position, at.normal, direction, spectrum);
                if (radiance == 0.0) continue;
                sum += radiance * power * track.share(order, alpha, beta, cosOut) *
                       track.mirror(cosIn, cosOut) * passage.at(wavelength_nm);
            }
        }
    }
    if (surface.model.pitShare == 1.0 || !surface.model.efficiencies.empty()) return sum;

    for (const Arrival& arrival : arrivals(world, at.position, at.normal, sampler, dimension)) {
        const double cosIn = dot(arrival.direction, frame.normal);
        const double u = alphaOut + dot(arrival.direction, frame.radial),
                     v = betaOut + dot(arrival.direction, frame.along);
        Throughput scattered = throughput;
        scattered.passFilter([&, cosIn, u, v](double wavelength_nm) {
            const Track track(surface, wavelength_nm);
            return track.scatteredShare(cosIn, cosOut) *
                   scatteringDensity(surface.model, wavelength_nm, u, v) * track.mirror(cosIn, cosOut);
        });
        sum += arrival.irradiance * world.palette.color(arrival.spectrum, Palette::kWhite, scattered);
    }
    return sum;
}

}  // namespace fringe::oracle
