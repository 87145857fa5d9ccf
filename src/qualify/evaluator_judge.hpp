// What evaluators are judged by: inputs, the oracle's colours at them, and how far results are from these.
#pragma once

#include <atomic>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "qualify/evaluator_probe.hpp"
#include "qualify/evaluator_row.hpp"

namespace fringe::qualify {

// First 0 itself and places in the first order, then small angles and large ones, orders and their side
// lobes. What lies where the undeviated light changes hands belongs to neither side and is left out.
std::vector<EvaluatorWindow> drawWindows(const EvaluatorCase& which, std::uint64_t seed, std::size_t count);

struct EvaluatorTruth {
    std::vector<glm::dvec3> values;
    double peak = 0.0;      // the largest of X, Y and Z
    glm::dvec3 white{1.0};  // D65 of the largest Y
};

EvaluatorTruth truthOf(std::vector<glm::dvec3> values);

// The reference's, of as many of the first windows as `patterns` of one wavelength allow, at least 48 and at
// most 2048. Without values when it was cancelled.
EvaluatorTruth oracleTruth(const EvaluatorCase& which, std::span<const EvaluatorWindow> windows,
                           double patterns, const std::atomic<bool>& cancelled);

// Into the row's errors. `got(i)`: the i-th result, and whether it is a number.
void judge(const EvaluatorTruth& truth, std::span<const EvaluatorWindow> windows,
           const std::function<std::pair<glm::dvec3, bool>(std::size_t)>& got, EvaluatorRow& row);

}  // namespace fringe::qualify
