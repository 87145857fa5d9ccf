// Which tiles of the picture gratings may light. The rest can be rendered by a pipeline that has no gratings
// at all, to the same picture: drivers for processors run code of a pipeline for every point, even where it
// has nothing to do.
#pragma once

#include <cstdint>
#include <vector>

#include "compile/compiled_scene.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

struct LitTiles {
    static constexpr std::uint32_t kEdge = 32;  // pixels, whole workgroups

    std::uint32_t columns = 0, rows = 0;  // none where it is not known; then all may be lit
    std::vector<bool> lit;                // row by row

    bool isKnown() const { return !lit.empty(); }
    bool at(std::uint32_t column, std::uint32_t row) const {
        return lit[std::size_t{row} * columns + column];
    }
};

// A tile is lit where a ray through it may meet something matt that a grating may reach, or a mirror or
// glass. Not known for scenes without gratings.
LitTiles litTiles(const scene::Scene& scene, const CompiledScene& compiled);

}  // namespace fringe::compile
