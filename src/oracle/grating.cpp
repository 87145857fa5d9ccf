#include "oracle/grating.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace fringe::oracle {

using glm::dot;
using glm::dvec2;

// Shares of the light that propagates, at even steps of the wavelength and linear between them; each is
// worked out when it is first asked for, by whichever thread asks.
class Grating::Shares {
public:
    explicit Shares(double step_nm) : step_nm_(step_nm), known_(steps() + 2) {
        for (auto& share : known_) share = std::numeric_limits<double>::quiet_NaN();
    }

    double at(const Wave& wave, const dvec2& incident, double wavelength_nm) {
        const double place = (wavelength_nm - kFirst_nm) / step_nm_;
        const auto below = std::min(static_cast<std::size_t>(std::max(place, 0.0)), steps());
        const double share = place - static_cast<double>(below);
        const double first = knot(wave, incident, below);
        return share == 0.0 ? first : first + share * (knot(wave, incident, below + 1) - first);
    }

private:
    std::size_t steps() const { return static_cast<std::size_t>((kLast_nm - kFirst_nm) / step_nm_); }

    double knot(const Wave& wave, const dvec2& incident, std::size_t i) {
        double value = known_[i];
        if (std::isnan(value)) {
            const double wavelength = 1e-9 * (kFirst_nm + step_nm_ * static_cast<double>(i));
            value = std::visit([&](const auto& w) { return w.propagatingShare(wavelength, incident); }, wave);
            known_[i] = value;
        }
        return value;
    }

    double step_nm_;
    std::vector<std::atomic<double>> known_;
};

Grating::Grating(const scene::Grating& grating, optics::Spectrum spectrum)
    : position_(grating.position),
      x_(glm::cross(grating.slitDirection, grating.normal)),
      y_(grating.slitDirection),
      z_(grating.normal),
      beam_(grating.beam),
      spectrum_(std::move(spectrum)),
      incident_(dot(grating.beam.direction, x_), dot(grating.beam.direction, y_)),
      wave_(makeWave(grating)),
      shares_(std::make_unique<Shares>(std::visit([](const auto& w) { return w.shareStep_nm(); }, wave_))) {}

Grating::Grating(Grating&&) noexcept = default;
Grating& Grating::operator=(Grating&&) noexcept = default;
Grating::~Grating() = default;

Grating::Wave Grating::makeWave(const scene::Grating& grating) {
    return std::visit(
        [&](const auto& aperture) -> Wave {
            if constexpr (std::is_same_v<decltype(aperture), const optics::Slits&>)
                return SlitWave(grating, aperture);
            else return OpeningWave(grating, aperture);
        },
        grating.aperture);
}

dvec3 Grating::local(const dvec3& world) const {
    return {dot(world, x_), dot(world, y_), dot(world, z_)};
}

std::optional<dvec3> Grating::sourceFor(const dvec3& position) const {
    const dvec3 offset = local(position - position_);
    if (offset.z <= 0.0) return {};
    const dvec3 source = std::visit([&](const auto& wave) { return wave.source(offset, incident_); }, wave_);
    return position_ + source.x * x_ + source.y * y_;
}

// So many that the waves from the ends of what is lit turn by half from one direction to the next.
std::vector<dvec2> Grating::directions() const {
    const double size = beam_.angularSize.si;
    if (size == 0.0) return {incident_};
    const dvec2 extent = std::visit([](const auto& wave) { return wave.extent(); }, wave_);
    const auto count = [&](double length) {
        return 2 + static_cast<int>(std::ceil(2.0 * length * size / (1e-9 * kFirst_nm)));
    };
    const int across = count(extent.x);
    const int along = count(extent.y);
    std::vector<dvec2> result;
    for (int i = 0; i < across; ++i) {
        for (int j = 0; j < along; ++j) {
            result.push_back(incident_ + size * dvec2((i + 0.5) / across - 0.5, (j + 0.5) / along - 0.5));
        }
    }
    return result;
}

template <class Use>
auto Grating::withViews(const dvec3& position, const dvec3& normal, const Use& use) const {
    const dvec3 offset = local(position - position_);
    const dvec3 facing = local(normal);
    return std::visit(
        [&](const auto& wave) {
            using View = decltype(wave.view(offset, facing, incident_));
            std::vector<View> views;
            if (offset.z > 0.0) {
                for (const dvec2& incident : directions())
                    views.push_back(wave.view(offset, facing, incident));
            }
            const auto perShare = [&](double wavelength_nm) {
                double sum = 0.0;
                for (const View& view : views) sum += wave.irradiance(view, 1e-9 * wavelength_nm);
                return views.empty() ? 0.0 : sum / static_cast<double>(views.size());
            };
            double spread = 0.0;
            for (const View& view : views) spread = std::max(spread, wave.spread(view));
            return use(perShare, spread);
        },
        wave_);
}

double Grating::irradiance(const dvec3& position, const dvec3& normal, double wavelength_nm) const {
    return beam_.power.si * withViews(position, normal, [&](const auto& perShare, double) {
               return perShare(wavelength_nm) / shares_->at(wave_, incident_, wavelength_nm);
           });
}

Xyz Grating::color(const dvec3& position, const dvec3& normal, const Passage& passage,
                   std::size_t steps) const {
    return withViews(position, normal, [&](const auto& perShare, double spread) {
        // Waves whose ways differ by the spread turn so often against each other from a wavelength to one
        // that is a nanometre longer, at most. Two samples a turn leave no alias of theirs in a sum over a
        // smooth spectrum. A measured one has knots, on whole nanometres, and a sum in steps of h errs by
        // h^2/12 times the change of slope at each: 5e-4 of the peak at 50 slits and 1 nm. A turn has eight
        // samples here, or a nanometre four.
        const double turnsPer_nm = 1e-9 * spread / (1e-18 * kFirst_nm * kFirst_nm);
        double broadest_nm = 0.0;
        for (const optics::Line& line : spectrum_.lines)
            broadest_nm = std::max(broadest_nm, line.width / units::nm);
        const auto enough = [&](double range_nm) {
            return static_cast<std::size_t>(std::ceil(2.0 * range_nm * turnsPer_nm));
        };
        constexpr double kVisible_nm = kLast_nm - kFirst_nm;
        const double perNanometre = std::min(std::ceil(8.0 * turnsPer_nm), 4.0);
        steps = std::max({steps, enough(kVisible_nm), static_cast<std::size_t>(perNanometre * kVisible_nm)});
        Xyz sum(0.0);
        // Eight standard deviations of a line are 3.4 of its widths.
        for (const auto& [wavelength_nm, power] :
             sampled(spectrum_, steps, std::max<std::size_t>(32, enough(3.4 * broadest_nm)))) {
            const Xyz perWatt = power * passage.at(wavelength_nm);
            if (perWatt == Xyz(0.0)) continue;
            sum += perShare(wavelength_nm) / shares_->at(wave_, incident_, wavelength_nm) * perWatt;
        }
        return beam_.power.si * sum;
    });
}

Xyz irradianceXyz(const scene::Scene& scene, std::size_t light, const dvec3& position, const dvec3& normal,
                  const optics::Curve& reflectance, std::size_t wavelengthSteps) {
    const scene::Light& source = scene.lights[light];
    const Grating grating(std::get<scene::Grating>(source.model), source.spectrum);
    return grating.color(position, normal, {reflectance, {}, filmResponse}, wavelengthSteps);
}

}  // namespace fringe::oracle
