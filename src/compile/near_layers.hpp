// Near fields that the device looks up: of polygons and masks, and of openings that cut a Gaussian beam.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "compile/beam_profile.hpp"
#include "compile/interface.hpp"
#include "compile/near_field.hpp"
#include "compile/table_memo.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

// From this Fresnel number on, at 550 nm, a near field is looked up: below, the far field is off by less than
// 1e-3 of its peak.
inline constexpr double kLeastLayer = 0.03;

// The largest of which there are layers. Beyond, the image of the opening has the ripples of this one.
inline constexpr double kMostLayer = 40.0;

// The layers of all openings of a scene together, in entries: 96 MB.
inline constexpr std::size_t kMostLayerEntries = std::size_t{24} << 20;

// Patterns of one opening for a row of Fresnel numbers.
struct NearLayers {
    device::LayerRow row;       // without edges
    std::vector<float> values;  // as shaders/near_layers.glsl looks them up
};

// `profile`: of the beam, as compileOpening() has it.
bool hasNearLayers(const optics::Aperture& aperture, const std::optional<UnevenBeam>& profile,
                   double fresnelNumber);

// Entries that it needs for as many layers as its ripples ask for. Precondition, here and below:
// hasNearLayers().
std::size_t layerEntries(const scene::Grating& grating, const std::optional<UnevenBeam>& profile,
                         const NearestField& nearest, const optics::Spectrum& spectrum);

// `most`: entries that there may be. Fewer layers follow fewer ripples; there are two at least.
std::shared_ptr<const NearLayers> nearLayers(const scene::Grating& grating,
                                             const std::optional<UnevenBeam>& profile,
                                             const NearestField& nearest, const optics::Spectrum& spectrum,
                                             std::size_t most, TableMemo* memo);

}  // namespace fringe::compile
