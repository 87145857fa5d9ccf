// The device that these tests run on, with the validation layer.
#pragma once

#include "gpu/device.hpp"
#include "wanted_device.hpp"

namespace fringe::qualify {

inline const gpu::Device& device() {
    static const gpu::Device one({.selector = wantedDevice(), .validation = true});
    return one;
}

}  // namespace fringe::qualify
