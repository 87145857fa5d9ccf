// Two reports of `fringe bench`, an old one and a new one: what got slower or less exact, as ratios.
#pragma once

#include <json/json.h>

#include <string>
#include <vector>

namespace fringe::cli {

struct BenchChange {
    std::string row;  // its name
    double time;      // new over old; 0 where either has none
    double error;     // the same, of root mean squares
    bool slower;
    bool lessExact;
};

struct BenchComparison {
    std::vector<BenchChange> changes;  // of rows in both reports, in the order of the new one
    std::vector<std::string> missing;  // rows of the old report alone
};

// Whether that is a report whose rows can be compared.
bool isReport(const Json::Value& json);

// Of two reports. `allowed`: the ratio beyond which something counts as slower or less exact. A time must
// besides differ by more than three times what the two scatter, an error by more than what 32 bits round a
// value of the peak to.
BenchComparison compareReports(const Json::Value& old, const Json::Value& now, double allowed);

}  // namespace fringe::cli
