// What is said about gratings: power, where the far field begins, how each is computed, and what of them is
// shown wrongly.
#pragma once

#include <json/value.h>

#include <string>

#include "compile/spectral.hpp"
#include "scene/scene.hpp"

namespace fringe::cli {

// {"model": "physical", "beam_power_W", "leaving_power_W", "fresnel_number_at_1_m": {"across", "along"}}
Json::Value describeGrating(const scene::Grating& grating);

// {"name", "reason", "wavelengths" of a sum, "estimated_error", "cost_in_look_ups", "bytes"}, for a
// continuous spectrum; null where the aperture is not slits.
Json::Value describeEvaluator(const scene::Grating& grating, const optics::Spectrum& spectrum,
                              compile::ResponseRows rows, double tolerance);

// The scene's warnings: [{"light", "message"}], and as lines on standard error. They change no exit status.
Json::Value warningsJson(const scene::Scene& scene);
void printWarnings(const std::string& file, const scene::Scene& scene);

}  // namespace fringe::cli
