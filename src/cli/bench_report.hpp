// What `fringe bench` found, as JSON rows, and what is made of them: tables, CSV, a chart. Of a row `group`,
// `case` and `setting` are the name; `error` and `time_ms` are what it is about.
#pragma once

#include <json/json.h>

#include <optional>
#include <string>

#include "plot/scatter.hpp"
#include "qualify/bench_frames.hpp"
#include "qualify/bench_skip.hpp"
#include "qualify/evaluator_row.hpp"

namespace fringe::cli {

Json::Value toJson(const qualify::EvaluatorRow& row);
Json::Value toJson(const qualify::FrameRow& row);
Json::Value toJson(const qualify::SkipRow& row);

// A row's name: "frames: spheres, 10000".
std::string nameOf(const Json::Value& row);

// The line over rows of a group, and that of a row.
std::string tableHead(const std::string& group);
std::string tableLine(const Json::Value& row);

// A header with every key of any row, those of nested objects joined by dots, and a line for each row.
std::string csvOf(const Json::Value& rows);

// Error against time, of the rows that have both, above zero: of evaluators, a series for each; where there
// are none, of frames, a series for each case. The fronts are those of single cases. Nothing where there are
// no such rows.
std::optional<plot::Scatter> scatterOf(const Json::Value& report);

}  // namespace fringe::cli
