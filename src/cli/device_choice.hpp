// Which device a command runs on, and whether it behaved.
#pragma once

#include <string>
#include <vector>

#include "gpu/device.hpp"

namespace fringe::cli {

// The device asked for by --device, else by FRINGE_DEVICE; under the validation layer where FRINGE_VALIDATION
// says so.
gpu::DeviceRequest deviceRequest(const std::string& selector);

// True when the validation layer had nothing to say; else it is on standard error.
bool passedValidation(const gpu::Device& device);
bool passedValidation(const std::vector<std::string>& messages);

}  // namespace fringe::cli
