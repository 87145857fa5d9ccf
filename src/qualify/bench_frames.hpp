// Whole frames against the clock: what samples buy, and what the size of a tile, of the picture, of the
// scene and the kind of its physics cost.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "qualify/bench_frame.hpp"

namespace fringe::qualify {

struct FrameCase {
    std::string_view name;
    std::string_view about;  // what its settings are, and what they are judged by
};

std::span<const FrameCase> frameCases();

struct FrameRow {
    std::string caseName;
    std::string setting;
    PictureError error;     // against what the case's `about` says
    bool verified = false;  // else the frame is wrong and was not timed
    Spread dispatch_ms;     // of a frame
    double compile_ms = 0.0;
    Spread ratio;  // of a frame to that of the case's first row, paired round by round; of the case "size"
                   // per pixel
};

// The rows of a case, whose settings take turns, so that a slow moment of the machine hits all. Nothing when
// it was cancelled. Throws gpu::DeviceError. Precondition: there is such a case.
std::vector<FrameRow> benchFrames(const gpu::Device& device, std::string_view caseName,
                                  const BenchControl& control);

}  // namespace fringe::qualify
