#include "profile/spectrometer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

namespace fringe::profile {
namespace {

using namespace units;

constexpr double kNanometres = 1e9;

// Below this share of the highest irradiance a maximum is left out if its light is of another wavelength than
// its place says, by more than so many times its reach.
constexpr double kWeak = 0.02;
constexpr double kStrayReach = 2.0;

const scene::Grating& gratingOf(const scene::Light& light) {
    const auto* grating = std::get_if<scene::Grating>(&light.model);
    const auto* slits = grating != nullptr ? std::get_if<optics::Slits>(&grating->aperture) : nullptr;
    if (slits == nullptr || slits->count < 2) {
        throw LineError(
            fmt::format("light \"{}\" is no grating of two or more slits; wavelengths need one", light.name));
    }
    return *grating;
}

dvec3 pointAt(const Samples& samples, double place) {
    const auto i = std::min(static_cast<std::size_t>(place), samples.points.size() - 2);
    return samples.points[i] + (place - static_cast<double>(i)) * (samples.points[i + 1] - samples.points[i]);
}

// How fast the sine changes per sample.
double sinePerSample(const Samples& samples, const Spectrometer& spectrometer, std::size_t i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, samples.points.size() - 1);
    if (!spectrometer.reaches(samples.points[before]) || !spectrometer.reaches(samples.points[after]))
        return 0.0;
    return std::abs(spectrometer.sine(samples.points[after]) - spectrometer.sine(samples.points[before])) /
           static_cast<double>(after - before);
}

// Mean wavelength of the light that stands out at a maximum: the light at its top less that at its edges, so
// that an even background does not count. 0 where nothing stands out.
double ownWavelength_nm(const Samples& samples, const Maximum& maximum) {
    const double last = static_cast<double>(samples.irradiance.size() - 1);
    double sum = samples.irradiance[maximum.top];
    double moment = sum * samples.meanWavelength_nm[maximum.top];
    for (const double side : {-0.5, 0.5}) {
        const double place = std::clamp(maximum.place + side * maximum.width, 0.0, last);
        const auto edge = static_cast<std::size_t>(std::lround(place));
        sum -= 0.5 * samples.irradiance[edge];
        moment -= 0.5 * samples.irradiance[edge] * samples.meanWavelength_nm[edge];
    }
    return sum > 0.0 ? moment / sum : 0.0;
}

// A maximum with a wavelength, while it is being read.
struct Entry {
    std::size_t maximum;  // index
    dvec3 point;
    double reach_nm;  // lines nearer than this are in it, unless another maximum is nearer
};

// The lines of the source that a maximum holds, if they are two or more.
std::optional<Blend> blendOf(const Spectrometer& spectrometer, const std::vector<SpectralMaximum>& maxima,
                             const std::vector<Entry>& entries, const Entry& entry) {
    const Reading& reading = *maxima[entry.maximum].reading;
    const auto away_nm = [&](const Entry& from, double wavelength_nm) {
        return std::abs(maxima[from.maximum].reading->wavelength_nm - wavelength_nm);
    };
    Blend blend{};
    for (const optics::Line& line : spectrometer.spectrum().lines) {
        const double wavelength_nm = line.wavelength / nm;
        const double own_nm = away_nm(entry, wavelength_nm);
        const bool isAnothers = std::any_of(entries.begin(), entries.end(), [&](const Entry& other) {
            return maxima[other.maximum].reading->order == reading.order &&
                   away_nm(other, wavelength_nm) < own_nm;
        });
        if (line.power > 0.0 && own_nm <= entry.reach_nm && !isAnothers)
            blend.lines_nm.push_back(wavelength_nm);
    }
    if (blend.lines_nm.size() < 2) return {};
    std::sort(blend.lines_nm.begin(), blend.lines_nm.end());
    double closest_nm = blend.lines_nm.back() - blend.lines_nm.front();
    for (std::size_t i = 1; i < blend.lines_nm.size(); ++i)
        closest_nm = std::min(closest_nm, blend.lines_nm[i] - blend.lines_nm[i - 1]);
    blend.slitsNeeded = reading.wavelength_nm / (std::abs(reading.order) * closest_nm);
    if (spectrometer.footprint(entry.point) > spectrometer.diffraction(reading.wavelength_nm))
        blend.focus = spectrometer.focusFor(entry.point);
    return blend;
}

}  // namespace

Spectrometer::Spectrometer(const scene::Light& light) : spectrum_(light.spectrum) {
    const scene::Grating& grating = gratingOf(light);
    const auto& slits = std::get<optics::Slits>(grating.aperture);
    const scene::Beam& beam = grating.beam;
    position_ = grating.position;
    along_ = grating.slitDirection;
    normal_ = grating.normal;
    across_ = glm::cross(along_, normal_);
    alphaIn_ = glm::dot(beam.direction, across_);
    const double betaIn = glm::dot(beam.direction, along_);
    conical_ = std::sqrt(1.0 - betaIn * betaIn);
    period_ = slits.period / m;
    slitWidth_ = slits.width / m;
    litWidth_ = std::min(slits.count * period_, beam.width / m);
    convergence_ = beam.focus ? 1.0 / (*beam.focus / m) : 0.0;
}

Spectrometer::Offset Spectrometer::offset(dvec3 point) const {
    const dvec3 from = point - position_;
    return {glm::dot(from, across_), glm::dot(from, along_), glm::dot(from, normal_)};
}

bool Spectrometer::reaches(dvec3 point) const {
    return offset(point).z > 0.0;
}

double Spectrometer::sine(dvec3 point) const {
    const Offset o = offset(point);
    assert(o.z > 0.0);
    return conical_ * o.x / std::hypot(o.x, o.z) - alphaIn_;
}

int Spectrometer::order(double sine, double wavelength_nm) const {
    return static_cast<int>(std::lround(sine * period_ * kNanometres / wavelength_nm));
}

double Spectrometer::envelopeSlope(double sine, double wavelength_nm) const {
    const double perSine = std::numbers::pi * slitWidth_ * kNanometres / wavelength_nm;
    const double x = perSine * sine;
    if (std::abs(x) < 1e-3) return -2.0 / 3.0 * x * perSine;  // the series' first term
    return 2.0 * perSine * (std::cos(x) / std::sin(x) - 1.0 / x);
}

// The light's way is longer than the distance from the slits' middle line by its slope along them.
double Spectrometer::distance(dvec3 point) const {
    const Offset o = offset(point);
    return std::hypot(o.x, o.z) / conical_;
}

// Of the wave that straight travel gives, across the slits in their plane: (1 - alpha^2) over the distance.
double Spectrometer::curvature(dvec3 point) const {
    const double alpha = sine(point) + alphaIn_;
    return (1.0 - alpha * alpha) / distance(point);
}

double Spectrometer::footprint(dvec3 point) const {
    const Offset o = offset(point);
    const double rho = std::hypot(o.x, o.z);
    return litWidth_ * std::abs(1.0 - convergence_ / curvature(point)) * conical_ * o.z * o.z /
           (rho * rho * rho);
}

double Spectrometer::focusFor(dvec3 point) const {
    return 1.0 / curvature(point);
}

std::vector<Threshold> thresholdsFor(const Samples& samples, const Spectrometer* spectrometer) {
    constexpr double kLeast = 0.005;
    // Waves are told apart at Rayleigh's distance; a tenth less leaves room for the samples' places. The
    // ripples of one footprint all lie within it.
    constexpr double kApart = 0.9;
    const std::size_t count = samples.points.size();
    std::vector<int> orders(count, 0);
    std::map<int, double> highest;  // irradiance in each order
    std::vector<Threshold> thresholds(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double mean_nm = samples.meanWavelength_nm[i];
        if (spectrometer != nullptr && mean_nm > 0.0 && spectrometer->reaches(samples.points[i])) {
            orders[i] = spectrometer->order(spectrometer->sine(samples.points[i]), mean_nm);
            const double slope = sinePerSample(samples, *spectrometer, i);
            const double extent = std::hypot(kApart * spectrometer->diffraction(mean_nm),
                                             spectrometer->footprint(samples.points[i]));
            if (slope > 0.0) thresholds[i].separation = extent / slope;
        }
        double& value = highest[orders[i]];
        value = std::max(value, samples.irradiance[i]);
    }
    for (std::size_t i = 0; i < count; ++i) thresholds[i].least = kLeast * highest[orders[i]];
    return thresholds;
}

std::vector<SpectralMaximum> readMaxima(const Samples& samples, const Spectrometer* spectrometer) {
    std::vector<SpectralMaximum> result;
    std::vector<Entry> entries;
    const double weak = kWeak * *std::max_element(samples.irradiance.begin(), samples.irradiance.end());
    for (const Maximum& maximum : findMaxima(samples.irradiance, thresholdsFor(samples, spectrometer))) {
        const dvec3 point = pointAt(samples, maximum.place);
        const double mean_nm = ownWavelength_nm(samples, maximum);
        if (spectrometer == nullptr || mean_nm <= 0.0 || !spectrometer->reaches(point)) {
            if (spectrometer == nullptr || maximum.value >= weak) result.push_back({maximum, {}});
            continue;
        }
        const double sine = spectrometer->sine(point);
        const int order = spectrometer->order(sine, mean_nm);
        if (order == 0) {
            if (maximum.value >= weak) result.push_back({maximum, {}});
            continue;
        }
        const double nmPerSine = std::abs(spectrometer->wavelength_nm(1.0, order));
        const double nmPerSample = nmPerSine * sinePerSample(samples, *spectrometer, maximum.top);
        const double wavelength_nm = spectrometer->wavelength_nm(sine, order);
        const double width_nm = maximum.width * nmPerSample;
        const double evenly =
            1.0 / std::sqrt(12.0);  // standard deviation of what lies anywhere in a width of 1
        // The slope of the slits' own pattern pulls a Gaussian of this width by slope width^2/(8 ln 2).
        const double pull_nm = std::abs(spectrometer->envelopeSlope(sine, wavelength_nm)) * width_nm *
                               width_nm / (8.0 * std::numbers::ln2 * nmPerSine);
        // Where the wave spreads wider than the footprint, that does not shape the maximum.
        const double footprint = spectrometer->footprint(point),
                     wave = spectrometer->diffraction(wavelength_nm);
        const double ownFootprint =
            footprint > 0.0 ? footprint * footprint / std::hypot(footprint, wave) : 0.0;
        const double uncertainty_nm = std::hypot(nmPerSample * std::hypot(evenly, maximum.asymmetry),
                                                 nmPerSine * ownFootprint * evenly, pull_nm);
        const double reach_nm =
            std::max(0.5 * width_nm, nmPerSine * spectrometer->diffraction(wavelength_nm));
        if (maximum.value < weak && std::abs(wavelength_nm - mean_nm) > kStrayReach * reach_nm) continue;
        entries.push_back({result.size(), point, reach_nm});
        result.push_back({maximum, Reading{order, wavelength_nm, uncertainty_nm, width_nm, {}}});
    }
    for (const Entry& entry : entries)
        result[entry.maximum].reading->blend = blendOf(*spectrometer, result, entries, entry);
    return result;
}

}  // namespace fringe::profile
