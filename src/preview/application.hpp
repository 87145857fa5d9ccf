// The preview: a window that shows a scene and lets the user look around in it and change it.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "gpu/device.hpp"
#include "preview/statistics.hpp"
#include "preview/wish.hpp"

namespace fringe::preview {

struct Options {
    Source source;  // a valid scene
    gpu::DeviceRequest device;
    std::uint32_t samples = 16;       // of every pixel, once nothing moves
    std::filesystem::path shaders{};  // a folder of the renderer's source; empty: as it was built
};

struct Outcome {
    Statistics statistics;
    std::vector<std::string> validationMessages;
};

// Opens the window and returns when the user has closed it, or `interrupted` has been set. Throws
// scene::SceneError when the scene is not valid in the first place, WindowError, or gpu::DeviceError when no
// device can show the window.
Outcome run(const Options& options, const std::atomic<bool>& interrupted);

}  // namespace fringe::preview
