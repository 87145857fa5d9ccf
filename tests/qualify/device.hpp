// The device that these tests run on, with the validation layer.
#pragma once

#include <cstdlib>

#include "gpu/device.hpp"

namespace fringe::qualify {

inline const gpu::Device& device() {
    const char* selector = std::getenv("FRINGE_DEVICE");
    static const gpu::Device one({.selector = selector != nullptr ? selector : "", .validation = true});
    return one;
}

}  // namespace fringe::qualify
