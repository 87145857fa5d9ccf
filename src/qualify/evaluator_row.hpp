// Run time against error of an evaluator, as `fringe bench` measures and shows it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "qualify/bench.hpp"

namespace fringe::qualify {

struct EvaluatorRow {
    std::string caseName;   // what is computed, such as "50 slits of 0.8/1.6 um, D65"
    std::string evaluator;  // by what: "table", "direct", ...
    std::string setting;    // of the evaluator, such as "81 wavelengths"
    std::string detail;     // what follows from case and tolerance: the choice of "auto", a table's entries

    // Against the oracle, relative to its highest value in the case; and CIEDE2000 with that value as white.
    double maxError = 0.0;
    double rmsError = 0.0;
    double worstInput = 0.0;            // where the error is largest: the change of the direction cosine, u
    double deltaE = 0.0;                // the largest
    std::uint64_t nonFinite = 0;        // results that are no number, left out of the errors
    std::uint64_t judged = 0;           // results in all
    std::optional<double> bound;        // of maxError, where something is promised
    std::optional<double> deltaEBound;  // of deltaE

    // Nothing where it was not timed. Milliseconds per million evaluations, and their ratio to those of the
    // case's first row, paired round by round.
    std::optional<Spread> perMillion_ms;
    std::optional<Spread> ratio;

    std::uint64_t tableBytes = 0;
    double buildSeconds = 0.0;  // of the tables, on the host

    // Whether it keeps what is promised, if anything is.
    bool isVerified() const {
        return (!bound || (maxError <= *bound && nonFinite == 0)) && (!deltaEBound || deltaE < *deltaEBound);
    }
};

}  // namespace fringe::qualify
