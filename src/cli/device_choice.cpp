#include "cli/device_choice.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

namespace fringe::cli {
namespace {

bool environmentFlag(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0' && std::string_view(value) != "0";
}

}  // namespace

gpu::DeviceRequest deviceRequest(const std::string& selector) {
    const char* fromEnvironment = std::getenv("FRINGE_DEVICE");
    const std::string fallback = fromEnvironment != nullptr ? fromEnvironment : "";
    return {.selector = selector.empty() ? fallback : selector,
            .validation = environmentFlag("FRINGE_VALIDATION")};
}

bool passedValidation(const gpu::Device& device) {
    return passedValidation(device.validationMessages());
}

bool passedValidation(const std::vector<std::string>& messages) {
    for (const std::string& message : messages) fmt::print(stderr, "fringe: validation: {}\n", message);
    return messages.empty();
}

}  // namespace fringe::cli
