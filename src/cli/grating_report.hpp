// What `fringe info` says about a grating: its power, where its far field begins, and how it is computed.
#pragma once

#include <json/value.h>

#include "compile/spectral.hpp"
#include "scene/scene.hpp"

namespace fringe::cli {

// {"model": "physical", "beam_power_W", "leaving_power_W", "fresnel_number_at_1_m": {"across", "along"}}
Json::Value describeGrating(const scene::Grating& grating);

// {"name", "reason", "wavelengths" of a sum, "estimated_error", "cost_in_look_ups", "bytes"}, for a
// continuous spectrum; null where the aperture is not slits.
Json::Value describeEvaluator(const scene::Grating& grating, const optics::Spectrum& spectrum,
                              compile::ResponseRows rows, double tolerance);

}  // namespace fringe::cli
