#include "compile/discs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "compile/number.hpp"
#include "optics/track.hpp"

namespace fringe::compile {
namespace {

using namespace units;

// Orders that are followed: all that can propagate, but no more than these. Beyond, those of a coarse track
// carry 0.2 % of the light at most, as the sum of 2/(pi m)^2 from here on tells.
constexpr int kMostOrders = 96;

// With so many orders the evanescent ones carry nothing that matters.
constexpr int kManyOrders = 24;

optics::Track trackOf(const scene::OpticalDisc& disc) {
    return {disc.pitch, disc.pitWidth, (disc.metal ? disc.coverIndex : 1.0) * disc.pitDepth, disc.pitShare};
}

// [-last..last][band]
void appendGiven(const std::vector<scene::OrderEfficiency>& efficiencies, int last,
                 std::vector<float>& values) {
    for (int order = -last; order <= last; ++order) {
        const auto found =
            std::find_if(efficiencies.begin(), efficiencies.end(),
                         [order](const scene::OrderEfficiency& e) { return e.order == order; });
        for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band) {
            values.push_back(found == efficiencies.end()
                                 ? 0.0F
                                 : toFloat(optics::valueAt(found->efficiency, bandMiddle_nm(band))));
        }
    }
}

}  // namespace

device::OpticalDisc compileOpticalDisc(const scene::OpticalDisc& disc, SpectralTables& tables,
                                       std::vector<float>& values) {
    const optics::Track track = trackOf(disc);
    const double pits = disc.pitShare * (disc.pitWidth / disc.pitch);
    const bool isGiven = !disc.efficiencies.empty();
    const double furthest = std::min(2.0 * disc.pitch / optics::kShortestVisible, double{kMostOrders});

    device::OpticalDisc packed{};
    packed.pitch_um = toFloat(disc.pitch / um);
    packed.depth_um = toFloat(track.depth / um);
    packed.bend = toFloat(disc.metal ? disc.coverIndex : 1.0);
    packed.index = toFloat(disc.coverIndex);
    packed.metal = disc.metal ? tables.metal(*disc.metal) : device::NO_METAL;
    packed.pits = toFloat(pits);
    packed.scattering = isGiven ? 0.0F : toFloat(pits * (1.0 - disc.pitShare));
    packed.pitWidth_um = toFloat(disc.pitWidth / um);
    packed.correlation_um = toFloat(track.correlationLength() / um);
    packed.hubRadiusSquared = toFloat(disc.metalInnerRadius * disc.metalInnerRadius);
    packed.innerRadiusSquared = toFloat(disc.dataInnerRadius * disc.dataInnerRadius);
    packed.outerRadiusSquared = toFloat(disc.dataOuterRadius * disc.dataOuterRadius);
    packed.isGiven = isGiven ? 1U : 0U;

    packed.scatteringShares = count(values.size());
    for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band)
        values.push_back(toFloat(optics::propagatingScattering(track, bandMiddle_nm(band) * nm)));

    if (isGiven) {
        packed.orders = count(values.size());
        int last = 0;
        for (const scene::OrderEfficiency& e : disc.efficiencies) last = std::max(last, std::abs(e.order));
        packed.orderCount = static_cast<device::uint>(std::min(last, static_cast<int>(furthest)));
        appendGiven(disc.efficiencies, static_cast<int>(packed.orderCount), values);
    } else if (optics::isWideGroove(track)) {
        packed.grooveSlope = toFloat(optics::steepestSlope(track));
        packed.orderCount = kMostOrders;
        packed.isCoarse = 1U;
    } else {
        packed.orderCount = static_cast<device::uint>(furthest);
        packed.isCoarse = packed.orderCount > kManyOrders ? 1U : 0U;
    }
    return packed;
}

std::vector<float> discSpectra(const SpectralTables& tables) {
    std::vector<float> directory, values;
    const std::size_t start = 3 * tables.spectra().size() * tables.reflectances().size();
    const auto here = [&] { return static_cast<float>(start + values.size()); };  // exact up to 2^24
    const auto append = [&](glm::dvec3 color) {
        for (int i = 0; i < 3; ++i) values.push_back(toFloat(color[i]));
    };
    const auto appendSpectrum = [&](const optics::Spectrum& spectrum, std::size_t reflectance) {
        constexpr int kSteps = 400;
        directory.push_back(here());
        std::vector<glm::dvec3> density;
        for (int i = 0; i <= kSteps; ++i) {
            const double wavelength_nm = optics::kShortestVisible_nm + i;
            density.push_back(optics::valueAt(spectrum.density, wavelength_nm) *
                              tables.response(reflectance, wavelength_nm));
            append(density.back());
        }
        glm::dvec3 sum(0.0);
        append(sum);
        for (int i = 1; i <= kSteps; ++i) {
            const auto at = static_cast<std::size_t>(i);
            sum += 0.5 * (density[at - 1] + density[at]);
            append(sum);
        }
        const std::vector<SpectralSample> lines = lineSamples(spectrum);
        directory.push_back(here());
        directory.push_back(static_cast<float>(lines.size()));
        for (const SpectralSample& line : lines) {
            values.push_back(toFloat(1e-3 * line.wavelength_nm));
            append(line.power * tables.response(reflectance, line.wavelength_nm));
        }
    };
    for (const optics::Spectrum& spectrum : tables.spectra()) {
        for (std::size_t reflectance = 0; reflectance < tables.reflectances().size(); ++reflectance)
            appendSpectrum(spectrum, reflectance);
    }
    directory.insert(directory.end(), values.begin(), values.end());
    return directory;
}

}  // namespace fringe::compile
