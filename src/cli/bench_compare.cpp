#include "cli/bench_compare.hpp"

#include <algorithm>
#include <map>

#include "cli/bench_report.hpp"

namespace fringe::cli {
namespace {

constexpr double kScatters = 3.0;
constexpr double kRounding = 1e-6;  // of the peak: some roundings of 6e-8

double ratioOf(double now, double old) {
    return old > 0.0 ? now / old : 0.0;
}

BenchChange changeOf(const Json::Value& old, const Json::Value& now, double allowed) {
    const auto median = [](const Json::Value& row) { return row["time_ms"]["median"].asDouble(); };
    const auto spread = [](const Json::Value& row) { return row["time_ms"]["spread"].asDouble(); };
    const auto error = [](const Json::Value& row) { return row["error"]["rms"].asDouble(); };
    BenchChange change{.row = nameOf(now),
                       .time = ratioOf(median(now), median(old)),
                       .error = ratioOf(error(now), error(old)),
                       .slower = false,
                       .lessExact = false};
    change.slower =
        change.time > allowed && median(now) - median(old) > kScatters * (spread(now) + spread(old));
    change.lessExact = error(now) > allowed * error(old) && error(now) - error(old) > kRounding;
    return change;
}

}  // namespace

bool isReport(const Json::Value& json) {
    const auto has = [](const Json::Value& object, const char* key, auto isKind) {
        return object.isMember(key) && (object[key].*isKind)();
    };
    const auto isRow = [&](const Json::Value& row) {
        if (!row.isObject() || !has(row, "error", &Json::Value::isObject)) return false;
        for (const char* key : {"group", "case", "setting"})
            if (!has(row, key, &Json::Value::isString)) return false;
        const bool isTimed = row.isMember("time_ms");
        if (isTimed && !row["time_ms"].isObject()) return false;
        // Of a row that cannot be judged there are no errors.
        return (!row["error"].isMember("rms") || row["error"]["rms"].isNumeric()) &&
               (!isTimed || (has(row["time_ms"], "median", &Json::Value::isNumeric) &&
                             has(row["time_ms"], "spread", &Json::Value::isNumeric)));
    };
    return json.isObject() && has(json, "rows", &Json::Value::isArray) &&
           has(json, "device", &Json::Value::isString) &&
           std::all_of(json["rows"].begin(), json["rows"].end(), isRow);
}

BenchComparison compareReports(const Json::Value& old, const Json::Value& now, double allowed) {
    std::map<std::string, const Json::Value*> before;
    for (const Json::Value& row : old["rows"]) before[nameOf(row)] = &row;
    BenchComparison result;
    for (const Json::Value& row : now["rows"]) {
        const auto found = before.find(nameOf(row));
        if (found == before.end()) continue;
        result.changes.push_back(changeOf(*found->second, row, allowed));
        before.erase(found);
    }
    for (const auto& [name, row] : before) result.missing.push_back(name);
    return result;
}

}  // namespace fringe::cli
