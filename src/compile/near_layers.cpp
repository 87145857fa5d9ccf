#include "compile/near_layers.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "compile/gratings.hpp"
#include "compile/number.hpp"
#include "compile/parallel.hpp"
#include "compile/spectral.hpp"
#include "optics/near_spectrum.hpp"

namespace fringe::compile {
namespace {

// Wavelengths that a spectrum has, of a continuous one those that are seen.
struct Range {
    double shortest_nm, longest_nm;
};

Range rangeOf(const optics::Spectrum& spectrum) {
    constexpr double kFirst_nm = 400.0, kLast_nm = 720.0, kStep_nm = 5.0, kFaint = 1e-3;
    Range range{kLast_nm, kFirst_nm};
    const auto include = [&](double wavelength_nm) {
        range.shortest_nm = std::min(range.shortest_nm, wavelength_nm);
        range.longest_nm = std::max(range.longest_nm, wavelength_nm);
    };
    double most = 0.0;
    for (const optics::Knot& knot : spectrum.density) most = std::max(most, knot.value);
    for (double at = kFirst_nm; at <= kLast_nm; at += kStep_nm)
        if (optics::valueAt(spectrum.density, at) > kFaint * most) include(at);
    for (const SpectralSample& line : lineSamples(spectrum)) include(line.wavelength_nm);
    return range;
}

// With all levels of averages, each a quarter of the one before, and a margin.
std::size_t entriesOf(std::uint32_t points) {
    std::size_t entries = 0;
    for (; points > 1; points /= 2) entries += std::size_t{points + 3} * (points + 3);
    return entries;
}

// The first and the last Fresnel number, of how many layers, and how large their tables are.
struct Layout {
    double first, last;
    std::uint32_t count;
    std::uint32_t across;  // samples of the opening
    std::uint32_t points;

    std::size_t entries() const { return count * entriesOf(points); }
};

std::optional<double> widthOf(const std::optional<UnevenBeam>& profile) {
    return profile ? std::optional(profile->width) : std::nullopt;
}

Layout layoutFor(const scene::Grating& grating, const std::optional<UnevenBeam>& profile,
                 const NearestField& nearest, const optics::Spectrum& spectrum) {
    const Range range = rangeOf(spectrum);
    constexpr double kFresnel_nm = 1e9 * kFresnelWavelength;
    // Of the square that holds the light, not of the circle about the opening.
    const double half = optics::litHalf(grating.aperture, widthOf(profile));
    const double square = std::pow(half / (0.5 * openingExtent(grating.aperture)), 2);
    const auto numberAt = [&](double number, double wavelength_nm) {
        return std::min(square * number * kFresnel_nm / wavelength_nm, kMostLayer);
    };
    Layout layout{};
    layout.last = numberAt(nearest.fresnelNumber, range.shortest_nm);
    // A little apart, where all of it is one.
    layout.first = std::min(numberAt(nearest.leastNumber, range.longest_nm), 0.999 * layout.last);
    // Ripples of white light that a layer cannot follow are not seen; lines show all of them.
    const bool isContinuous = !spectrum.density.empty();
    const double steps =
        std::log((layout.last + device::LAYER_OFFSET) / (layout.first + device::LAYER_OFFSET)) /
        (isContinuous ? 0.02 : 0.01);
    layout.count = 1 + static_cast<std::uint32_t>(std::ceil(std::max(steps, 1.0)));
    // Samples must follow the phase at the rim, which turns by the Fresnel number over half of the opening,
    // and the directions of its image, out to the same number of fringes; and what lies around.
    layout.across = layout.last <= 4.0 ? 64 : layout.last <= 12.0 ? 128 : 256;
    // Four points for each; in a wide opening's white light two are enough, as fringes between its far ends
    // are not seen, and where there are many layers for lines.
    constexpr std::uint32_t kManyLayers = 6;
    const bool isCoarse = layout.across == 256 && (isContinuous || layout.count > kManyLayers);
    layout.points = (isCoarse ? 2 : 4) * layout.across;
    return layout;
}

std::vector<float> deviceTable(const std::vector<std::vector<float>>& levels) {
    std::vector<float> table;
    for (const std::vector<float>& level : levels) {
        const auto size = static_cast<std::int64_t>(std::lround(std::sqrt(level.size())));
        for (std::int64_t j = -1; j <= size + 1; ++j) {
            for (std::int64_t i = -1; i <= size + 1; ++i)
                table.push_back(
                    level[static_cast<std::size_t>((j + size) % size * size + (i + size) % size)]);
        }
    }
    return table;
}

}  // namespace

bool hasNearLayers(const optics::Aperture& aperture, const std::optional<UnevenBeam>& profile,
                   double fresnelNumber) {
    if (!(fresnelNumber > kLeastLayer) || std::holds_alternative<optics::LatticeAperture>(aperture))
        return false;
    return profile ? !profile->isWhole : !hasNearField(aperture);
}

std::size_t layerEntries(const scene::Grating& grating, const std::optional<UnevenBeam>& profile,
                         const NearestField& nearest, const optics::Spectrum& spectrum) {
    return layoutFor(grating, profile, nearest, spectrum).entries();
}

std::shared_ptr<const NearLayers> nearLayers(const scene::Grating& grating,
                                             const std::optional<UnevenBeam>& profile,
                                             const NearestField& nearest, const optics::Spectrum& spectrum,
                                             std::size_t most, TableMemo* memo) {
    const glm::dvec2 incoming = incomingCosines(grating);
    const std::optional<double> width = widthOf(profile);
    Layout layout = layoutFor(grating, profile, nearest, spectrum);
    layout.count = static_cast<std::uint32_t>(
        std::clamp(most / entriesOf(layout.points), std::size_t{2}, std::size_t{layout.count}));
    TableMemo::Key key = TableMemo::Key().add(grating.aperture).add(width.value_or(0.0));
    key.add(incoming.x).add(incoming.y).add(layout.first).add(layout.last);
    key.add(layout.count).add(layout.across).add(layout.points);
    return rememberedOrDraft(memo, std::move(key), [&](bool isDraft) {
        const std::uint32_t parts = isDraft ? 2 : 1;
        const std::uint32_t points = layout.points / parts, count = std::max(layout.count / parts, 2U);
        optics::AmplitudeSamples samples = optics::samplesOf(grating.aperture, width, layout.across / parts);
        const double first = layout.first + device::LAYER_OFFSET;
        const double ratio = std::pow((layout.last + device::LAYER_OFFSET) / first, 1.0 / (count - 1.0));
        NearLayers layers{{.count = static_cast<float>(count),
                           .entries = static_cast<float>(entriesOf(points)),
                           .points = static_cast<float>(points),
                           .across = static_cast<float>(samples.across),
                           .pixel_um = toFloat(1e6 * samples.pixel),
                           .half_um = toFloat(1e6 * samples.half),
                           .first = toFloat(layout.first),
                           .ratio = toFloat(std::log2(ratio)),
                           .upright = 0.0F,
                           .level = 0.0F,
                           .slanting = 0.0F},
                          {}};
        const optics::NearSpectrum nearSpectrum(std::move(samples), incoming, points, device::LAYER_STRETCH);
        const auto numberOf = [&](int layer) {
            const int last = static_cast<int>(count) - 1;
            return first * std::pow(ratio, std::clamp(layer, 0, last)) - device::LAYER_OFFSET;
        };
        std::vector<std::vector<float>> tables(count);
        inParallel(static_cast<int>(count), [&](int i) {
            tables[static_cast<std::size_t>(i)] =
                deviceTable(nearSpectrum.levels(numberOf(i - 1), numberOf(i), numberOf(i + 1)));
        });
        for (const std::vector<float>& table : tables)
            layers.values.insert(layers.values.end(), table.begin(), table.end());
        return layers;
    });
}

}  // namespace fringe::compile
