// The evaluators of slits against the oracle and against the clock: each on gratings from one slit to a
// million, verified first, then timed.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/device.hpp"
#include "optics/spectrum.hpp"
#include "qualify/bench.hpp"

namespace fringe::qualify {

// Slits seen through windows of u as wide as a pixel of 0.2 mm a metre
// away.
struct EvaluatorCase {
    std::string_view name;
    std::uint32_t count;
    double width_um;
    double period_um;
    optics::Spectrum spectrum;
    double largestSine;     // of the angles at which light leaves, to either side
    double incoming = 0.0;  // direction cosine of the beam across the slits
};

std::span<const EvaluatorCase> evaluatorCases();

struct EvaluatorRequest {
    double tolerance = 1e-3;              // for "auto", and for settings that follow from it
    std::vector<std::string> evaluators;  // these alone; empty: all
    std::uint64_t seed = 1;
    // Work of the oracle for a case, in patterns of one wavelength; it says how many inputs are judged, at
    // least 48 and at most 2048.
    double oraclePatterns = 4e7;
    int repetitions = 7;  // that are timed; 0: judged alone
    std::function<void(const BenchRow&)> onRow = [](const BenchRow&) {};
};

// A row for each evaluator and setting that the case can have; "auto" is the first. Times are the host's
// clock around dispatches of about 60 ms, and around the processor's own sum on two threads. Throws
// gpu::DeviceError.
std::vector<BenchRow> benchEvaluators(const gpu::Device& device, const EvaluatorCase& which,
                                      const EvaluatorRequest& request);

}  // namespace fringe::qualify
