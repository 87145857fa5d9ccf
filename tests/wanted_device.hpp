// The device that the tests run on.
#pragma once

#include <cstdlib>
#include <string>

namespace fringe {

// What FRINGE_DEVICE selects; empty for the first one that can.
inline std::string wantedDevice() {
    const char* selector = std::getenv("FRINGE_DEVICE");
    return selector != nullptr ? selector : "";
}

}  // namespace fringe
