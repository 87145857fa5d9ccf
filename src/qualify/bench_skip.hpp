// What a feature costs that a scene doesn't need: the pipeline of a scene without it against that of the same
// scene with it, out of sight, so that both show the same picture.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "qualify/bench_frame.hpp"

namespace fringe::qualify {

// The names that benchSkip knows.
std::vector<std::string_view> skipCases();

struct PipelineCost {
    Spread frame_ms;              // dispatch
    Spread compile_ms;            // pipeline and first dispatch, of one workgroup
    std::size_t liveBytes = 0;    // of SPIR-V that its constants leave (live_code.hpp)
    std::size_t moduleBytes = 0;  // of the whole module, before what is dead is left out
};

struct SkipRow {
    std::string feature;   // or "smallest shader", "room", "everything"
    std::string without;   // the row of the same scene without it; empty: this is compared with nothing
    PictureError error;    // of the picture, against that of the room
    bool verified = true;  // else it is wrong and was not timed
    PipelineCost cost;
    std::optional<Spread> frameRatio, compileRatio;  // to that row, paired round by round
};

// The smallest shader, which draws nothing; the room that has none of the features; the room with each of
// those that are named, or with each where none is; and with everything, which is the general pipeline. What
// others are compared with is always there. Nothing when it was cancelled. Throws gpu::DeviceError.
std::vector<SkipRow> benchSkip(const gpu::Device& device, std::span<const std::string> names,
                               const BenchControl& control);

}  // namespace fringe::qualify
