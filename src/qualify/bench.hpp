// Run time against error, as `fringe bench` measures and shows it: one row for each way of computing
// something on a case.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace fringe::qualify {

struct BenchRow {
    std::string caseName;   // what is computed, such as "50 slits of 0.8/1.6 um, D65"
    std::string evaluator;  // by what: "table", "direct", ...
    std::string setting;    // of the evaluator, such as "81 wavelengths"

    // Against the oracle, relative to its highest value in the case; and CIEDE2000 with that value as white.
    double maxError = 0.0;
    double rmsError = 0.0;
    double worstInput = 0.0;       // where the error is largest: the change of the direction cosine, u
    std::optional<double> deltaE;  // the largest; nothing where the case has no colour
    std::uint64_t nonFinite = 0;   // results that are no number, left out of the errors

    // Time per million evaluations by the clock that the report names: the median over the repetitions, and
    // half the distance between the quartiles.
    double perMillion_ms = 0.0;
    double spread_ms = 0.0;

    std::uint64_t tableBytes = 0;
    double buildSeconds = 0.0;  // of the tables, on the host
};

}  // namespace fringe::qualify
