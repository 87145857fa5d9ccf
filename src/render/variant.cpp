#include "render/variant.hpp"

#include <array>

#include "shaders/render_000.h"
#include "shaders/render_001.h"
#include "shaders/render_010.h"
#include "shaders/render_011.h"
#include "shaders/render_100.h"
#include "shaders/render_101.h"
#include "shaders/render_110.h"
#include "shaders/render_111.h"
#include "shaders/render_discs.h"
#include "shaders/render_tree.h"
#include "shaders/render_tree_discs.h"
#include "shaders/render_tree_gratings.h"

namespace fringe::render {

Variant variantFor(const compile::CompiledScene& scene) {
    const bool slits = !scene.slitGratings.empty(), openings = !scene.openingGratings.empty();
    if (scene.tree.depth > 0) {
        if (scene.inBands) return {true, true, true, true, true};
        const bool gratings = slits || openings;
        return {false, gratings, gratings, false, true};
    }
    if (!scene.opticalDiscs.empty()) return {true, true, true, true, false};
    return {scene.inBands, slits, openings, false, false};
}

Variant withoutGratings(Variant variant) {
    if (!variant.discs) variant.slits = variant.openings = false;
    return variant;
}

std::span<const std::uint32_t> embeddedShader(const Variant& variant) {
    static constexpr std::array<std::span<const std::uint32_t>, 8> kWithoutDiscs{
        render_000, render_001, render_010, render_011, render_100, render_101, render_110, render_111};
    if (variant.tree && variant.discs) return render_tree_discs;
    if (variant.tree && variant.slits) return render_tree_gratings;
    if (variant.tree) return render_tree;
    if (variant.discs) return render_discs;
    const std::size_t bands = variant.banded ? 4 : 0;
    const std::size_t slits = variant.slits ? 2 : 0;
    const std::size_t openings = variant.openings ? 1 : 0;
    return kWithoutDiscs.at(bands + slits + openings);
}

}  // namespace fringe::render
