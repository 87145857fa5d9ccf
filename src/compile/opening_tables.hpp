// What of an opening depends on its shape and the beam's direction alone, and takes long to find: kept from
// scene to scene where there is a memo.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "compile/beam_profile.hpp"
#include "compile/table_memo.hpp"
#include "optics/aperture.hpp"
#include "optics/mask_spectrum.hpp"

namespace fringe::compile {

// Of an opening that a beam lights unevenly. Fourteen points of the table for each keep its interpolation,
// too, within 1e-5 of the peak.
inline constexpr std::uint32_t kPixelsAcross = 144;

struct MaskTables {
    optics::MaskSpectrum spectrum;
    std::vector<float>
        levels;  // as the device looks them up: half of the plane and a margin (shaders/masks.glsl)
};
// A draft has half as many points along either axis, where there are no more than 4096: 1e-3 of the peak off.
MaskTables tablesOf(const optics::AmplitudeGrid& grid, bool isDraft = false);

// The share of the power that propagates, linear between even steps of the wavelength, each of them worked
// out when it is first asked for: it takes milliseconds.
class OpeningShares {
public:
    OpeningShares(double step_nm, std::function<double(units::Length)> share);

    double at(double wavelength_nm);

    // Works out all steps, for a spectrum that asks for them anyhow.
    void findAll();

private:
    double knot(std::size_t i);

    double step_nm_;
    std::function<double(units::Length)> share_;
    std::vector<std::optional<double>> known_;
};

struct OpeningTables {
    std::shared_ptr<const MaskTables>
        mask;  // of what is looked up: a mask, an opening that a beam lights unevenly
    std::shared_ptr<const MaskTables>
        cells;  // of a lattice's cells that a beam lights unevenly, where needed
    std::shared_ptr<OpeningShares> shares;
};

// `profile`: where that of a beam counts across the opening. `incoming`: direction
// cosines of the beam. `memo` may be null; where it wants drafts, new tables are drafts. Precondition: the
// aperture is no slits, and with a profile a lattice has litCells().
OpeningTables openingTables(const optics::Aperture& aperture, const std::optional<UnevenBeam>& profile,
                            const glm::dvec2& incoming, TableMemo* memo);

}  // namespace fringe::compile
