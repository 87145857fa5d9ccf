// The evaluators of slits against the oracle and against the clock: each on gratings from one slit to a
// million, verified first, then timed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gpu/device.hpp"
#include "qualify/evaluator_cases.hpp"
#include "qualify/evaluator_row.hpp"

namespace fringe::qualify {

struct EvaluatorRequest {
    double tolerance = 1e-3;              // for "auto", and for settings that follow from it
    std::vector<std::string> evaluators;  // these alone; empty: all
    std::uint64_t seed = 1;
    // Work of the oracle for a case, in patterns of one wavelength; it says how many inputs are judged, at
    // least 48 and at most 2048.
    double oraclePatterns = 1e8;
};

// A row for each evaluator and setting that the case can have; "auto" is the first. Times are the host's
// clock around dispatches of about 60 ms, and around the processor's own sum on two threads; the evaluators
// take turns, so that a slow moment of the machine hits all. With no rounds they are judged alone. Nothing
// when it was cancelled. Throws gpu::DeviceError.
std::vector<EvaluatorRow> benchEvaluators(const gpu::Device& device, const EvaluatorCase& which,
                                          const EvaluatorRequest& request, const BenchControl& control);

}  // namespace fringe::qualify
