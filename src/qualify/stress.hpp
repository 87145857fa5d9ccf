// Numerical stability, measured: a function of the shaders evaluated on a device at millions of random and
// adversarial inputs, and judged at the very floats that the device got by double precision that shares no
// code with it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gpu/device.hpp"
#include "qualify/draw.hpp"

namespace fringe::qualify {

// Of one evaluation. The error is absolute, in units of the function's peak or of the size of what it is
// about: a case says which.
struct Judgement {
    double error;
    double ulps;
    double got;
    double expected;
};

struct StressCase {
    std::string_view name;
    std::string_view function;              // as the shaders call it, and their file
    std::optional<double> bound;            // on the error; nothing: shown, not judged
    std::string_view reason;                // where the bound comes from, or why there is none
    std::span<const std::uint32_t> shader;  // binding 0: inputs, 1: results, one evaluation after another
    std::uint32_t variant;                  // specialisation constant 0; 1 and 2: how many inputs and results
    std::vector<std::string_view> inputs;   // names of the floats of an evaluation
    std::uint32_t results;                  // floats that it gives
    void (*draw)(Draw& draw, std::span<float> inputs);
    Judgement (*judge)(std::span<const float> inputs, std::span<const float> results);
    std::uint64_t fullCount;  // evaluations that `--full` makes
};

// Every case that the program has.
std::span<const StressCase> stressCases();

struct StressRequest {
    std::uint64_t seed = 1;
    std::uint64_t count = 1;
};

// An input, in full.
struct Witness {
    std::uint64_t number;  // of the evaluation
    std::vector<float> inputs;
    std::vector<float> results;
    Judgement judgement;  // of finite results
};

struct StressReport {
    std::uint64_t count = 0;
    std::uint64_t nonFinite =
        0;  // evaluations with a result that is no number; the rest counts for the errors
    double largest = 0.0;
    double most = 0.0;  // the 99.9th percentile
    double largestUlps = 0.0;
    double mostUlps = 0.0;
    std::optional<Witness> worst;  // that with the largest error
    std::optional<Witness> firstNonFinite;
    double seconds = 0.0;

    // Whether all results are numbers, within the bound.
    bool keeps(double bound) const { return nonFinite == 0 && largest <= bound; }
};

// Evaluations 0..count-1 of a case. Throws gpu::DeviceError.
StressReport stress(const gpu::Device& device, const StressCase& stressCase, const StressRequest& request);

}  // namespace fringe::qualify
