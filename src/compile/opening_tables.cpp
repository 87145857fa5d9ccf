#include "compile/opening_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <variant>

#include "compile/near_field.hpp"
#include "compile/parallel.hpp"
#include "compile/uneven_lattice.hpp"
#include "optics/energy.hpp"

namespace fringe::compile {
namespace {

using optics::kLongestVisible_nm, optics::kShortestVisible_nm;

std::vector<float> deviceLevels(const optics::MaskSpectrum& spectrum) {
    std::vector<float> table;
    for (const optics::MaskSpectrum::Level& level : spectrum.levels()) {
        const std::int64_t columns = level.columns, rows = level.rows, stride = columns / 2 + 1;
        for (std::int64_t j = -1; j <= rows + 1; ++j) {
            for (std::int64_t i = -1; i <= columns / 2 + 2; ++i) {
                // The mirror image of a column beyond the half that is there.
                const bool isMirrored = i < 0 || i > columns / 2;
                const std::int64_t column = std::abs(i < 0 ? i : isMirrored ? columns - i : i);
                const std::int64_t row = ((isMirrored ? -j : j) % rows + rows) % rows;
                table.push_back(level.values[static_cast<std::size_t>(row * stride + column)]);
            }
        }
    }
    return table;
}

// So that the share is right to 5e-4, and to 3e-3 next to a wavelength at which an order of a fine lattice
// passes off.
double shareStep_nm(double cellExtent, bool isLattice) {
    if (cellExtent >= 5e-6) return 50.0;
    if (cellExtent >= 3e-6) return 25.0;
    return isLattice ? 5.0 : 10.0;
}
// Of drafts: three wavelengths, between which the share of narrow openings is some hundredths off.
constexpr double kDraftStep_nm = 200.0;

}  // namespace

MaskTables tablesOf(const optics::AmplitudeGrid& grid, bool isDraft) {
    optics::MaskSpectrum spectrum(grid, isDraft ? 4 : 8);
    std::vector<float> levels = deviceLevels(spectrum);
    return {std::move(spectrum), std::move(levels)};
}

OpeningShares::OpeningShares(double step_nm, std::function<double(units::Length)> share)
    : step_nm_(step_nm),
      share_(std::move(share)),
      known_(static_cast<std::size_t>((kLongestVisible_nm - kShortestVisible_nm) / step_nm) + 1) {}

double OpeningShares::at(double wavelength_nm) {
    const double place = std::max(wavelength_nm - kShortestVisible_nm, 0.0) / step_nm_;
    const auto i = std::min(static_cast<std::size_t>(place), known_.size() - 2);
    const double below = knot(i);
    return below + (place - static_cast<double>(i)) * (knot(i + 1) - below);
}

void OpeningShares::findAll() {
    inParallel(static_cast<int>(known_.size()), [&](int i) { knot(static_cast<std::size_t>(i)); });
}

double OpeningShares::knot(std::size_t i) {
    if (!known_[i]) known_[i] = share_((kShortestVisible_nm + step_nm_ * static_cast<double>(i)) * units::nm);
    return *known_[i];
}

OpeningTables openingTables(const optics::Aperture& aperture, const std::optional<UnevenBeam>& profile,
                            const glm::dvec2& incoming, TableMemo* memo) {
    TableMemo::Key key = TableMemo::Key().add(aperture).add(profile ? profile->width : 0.0);
    OpeningTables tables;
    if (profile && profile->isWhole) {  // no rim sends anything past the last directions
        tables.shares = std::make_shared<OpeningShares>(100.0, [](units::Length) { return 1.0; });
        return tables;
    }
    if (const auto* lattice = std::get_if<optics::LatticeAperture>(&aperture);
        lattice != nullptr && profile) {
        const std::optional<LitCells> lit = litCells(*lattice, profile->width);
        if (!lit->isWhole)
            tables.cells = rememberedOrDraft(memo, key, [&](bool isDraft) {
                return tablesOf(cellAmplitudes(*lattice, profile->width, *lit), isDraft);
            });
    } else if (profile) {
        tables.mask = rememberedOrDraft(memo, key, [&](bool isDraft) {
            return tablesOf(optics::gaussianGrid(aperture, profile->width, kPixelsAcross), isDraft);
        });
    } else if (const auto* mask = std::get_if<optics::MaskAperture>(&aperture)) {
        tables.mask = rememberedOrDraft(
            memo, key, [&](bool isDraft) { return tablesOf(optics::gridOf(*mask), isDraft); });
    }
    key.add(incoming.x).add(incoming.y);
    tables.shares = *rememberedOrDraft(memo, std::move(key), [&](bool isDraft) {
        const bool isLattice = std::holds_alternative<optics::LatticeAperture>(aperture);
        const double step_nm = isDraft ? kDraftStep_nm : shareStep_nm(openingExtent(aperture), isLattice);
        return std::make_shared<OpeningShares>(
            step_nm, [aperture, incoming, mask = tables.mask](units::Length wavelength) {
                return mask ? mask->spectrum.propagatingShare(wavelength, incoming.x, incoming.y)
                            : optics::propagatingShare(aperture, wavelength, incoming.x, incoming.y);
            });
    });
    return tables;
}

}  // namespace fringe::compile
