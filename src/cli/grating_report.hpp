// What `fringe info` says about a grating: its power, and where its far field begins.
#pragma once

#include <json/value.h>

#include "scene/scene.hpp"

namespace fringe::cli {

// {"model": "physical", "beam_power_W", "leaving_power_W", "fresnel_number_at_1_m": {"across", "along"}}
Json::Value describeGrating(const scene::Grating& grating);

}  // namespace fringe::cli
