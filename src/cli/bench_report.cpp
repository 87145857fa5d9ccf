#include "cli/bench_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "qualify/pareto.hpp"

namespace fringe::cli {
namespace {

Json::Value toJson(const qualify::Spread& spread) {
    Json::Value json;
    json["median"] = spread.median;
    json["spread"] = spread.half;
    return json;
}

Json::Value toJson(const qualify::PictureError& error) {
    Json::Value json;
    json["largest"] = error.largest;
    json["rms"] = error.rms;
    json["delta_e"] = error.deltaE;
    json["share_wrong"] = error.wrong;
    return json;
}

std::string number(const Json::Value& value, const char* format) {
    return value.isNull() ? "-" : fmt::format(fmt::runtime(format), value.asDouble());
}

std::string kib(const Json::Value& bytes) {
    return fmt::format("{:.1f}", bytes.asDouble() / 1024.0);
}

// What is said of an evaluator beside its name.
std::string wordsOf(const Json::Value& row) {
    const std::string setting = row["setting"].asString(), detail = row["detail"].asString();
    return setting.empty() || detail.empty() ? setting + detail : setting + ", " + detail;
}

// Every leaf of a row, by its keys joined by dots.
void flatten(const Json::Value& value, const std::string& key, std::map<std::string, std::string>& cells) {
    if (value.isObject()) {
        for (const std::string& member : value.getMemberNames())
            flatten(value[member], key.empty() ? member : key + "." + member, cells);
    } else if (value.isDouble()) {
        cells[key] = fmt::format("{:.9g}", value.asDouble());
    } else {
        cells[key] = value.asString();
    }
}

// As RFC 4180 has it.
std::string csvCell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted;
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    return fmt::format("\"{}\"", quoted);
}

plot::ScatterSeries& seriesNamed(const std::string& name, std::vector<plot::ScatterSeries>& all) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& series) { return series.name == name; });
    return found != all.end() ? *found : all.emplace_back(plot::ScatterSeries{name, {}});
}

std::vector<plot::ScatterPoint> frontOf(const std::vector<plot::ScatterPoint>& points) {
    std::vector<qualify::Costs> costs;
    for (const plot::ScatterPoint& point : points) costs.push_back({point.x, point.y});
    std::vector<plot::ScatterPoint> front;
    for (const std::size_t i : qualify::paretoFront(costs)) front.push_back(points[i]);
    return front;
}

}  // namespace

Json::Value toJson(const qualify::EvaluatorRow& row) {
    Json::Value json;
    json["group"] = "evaluators";
    json["case"] = row.caseName;
    json["evaluator"] = row.evaluator;
    json["setting"] = row.setting;
    json["detail"] = row.detail;
    json["error"]["judged"] = Json::UInt64{row.judged};
    json["error"]["not_finite"] = Json::UInt64{row.nonFinite};
    if (row.judged > row.nonFinite) {
        json["error"]["largest"] = row.maxError;
        json["error"]["rms"] = row.rmsError;
        json["error"]["delta_e"] = row.deltaE;
        json["error"]["worst_u"] = row.worstInput;
    }
    if (row.bound) json["bound"] = *row.bound;
    if (row.deltaEBound) json["delta_e_bound"] = *row.deltaEBound;
    json["verified"] = row.isVerified();
    if (row.perMillion_ms) json["time_ms"] = toJson(*row.perMillion_ms);
    if (row.ratio) json["ratio"] = toJson(*row.ratio);
    json["table_bytes"] = Json::UInt64{row.tableBytes};
    json["build_s"] = row.buildSeconds;
    return json;
}

Json::Value toJson(const qualify::FrameRow& row) {
    Json::Value json;
    json["group"] = "frames";
    json["case"] = row.caseName;
    json["setting"] = row.setting;
    json["error"] = toJson(row.error);
    json["verified"] = row.verified;
    json["compile_ms"] = row.compile_ms;
    if (row.verified) {
        json["time_ms"] = toJson(row.dispatch_ms);
        json["ratio"] = toJson(row.ratio);
    }
    return json;
}

Json::Value toJson(const qualify::SkipRow& row) {
    Json::Value json;
    json["group"] = "skip";
    json["case"] = row.feature;
    json["setting"] = row.without.empty() ? "" : "against " + row.without;
    json["error"] = toJson(row.error);
    json["verified"] = row.verified;
    json["compile_ms"] = toJson(row.cost.compile_ms);
    json["spirv_bytes"]["left"] = Json::UInt64{row.cost.liveBytes};
    json["spirv_bytes"]["module"] = Json::UInt64{row.cost.moduleBytes};
    if (row.verified) json["time_ms"] = toJson(row.cost.frame_ms);
    if (row.frameRatio) json["ratio"] = toJson(*row.frameRatio);
    if (row.compileRatio) json["compile_ratio"] = toJson(*row.compileRatio);
    return json;
}

std::string nameOf(const Json::Value& row) {
    std::string name = row["group"].asString() + ": " + row["case"].asString();
    for (const char* key : {"evaluator", "setting"})
        if (!row[key].asString().empty()) name += ", " + row[key].asString();
    return name;
}

std::string tableHead(const std::string& group) {
    if (group == "evaluators") {
        return fmt::format("{:<12} {:<31} {:>12} {:>7} {:>7} {:>9} {:>9} {:>8} {:>8}", "evaluator", "setting",
                           "ms a million", "+-", "ratio", "rms error", "largest", "Delta E", "KiB");
    }
    if (group == "frames") {
        return fmt::format("{:<16} {:<14} {:>10} {:>9} {:>7} {:>7} {:>9} {:>9} {:>7}", "frames", "setting",
                           "ms a frame", "+-", "ratio", "+-", "rms error", "largest", "Delta E");
    }
    return fmt::format("{:<20} {:<22} {:>10} {:>6} {:>7} {:>10} {:>7} {:>8} {:>8}", "skip", "against",
                       "ms a frame", "+-", "ratio", "compile ms", "ratio", "KiB left", "of KiB");
}

std::string tableLine(const Json::Value& row) {
    std::string line;
    const Json::Value& error = row["error"];
    if (row["group"] == "evaluators") {
        line =
            fmt::format("{:<12} {:<31} {:>12} {:>7} {:>7} {:>9} {:>9} {:>8} {:>8}",
                        row["evaluator"].asString(), wordsOf(row), number(row["time_ms"]["median"], "{:.2f}"),
                        number(row["time_ms"]["spread"], "{:.2f}"), number(row["ratio"]["median"], "{:.2f}"),
                        number(error["rms"], "{:.1e}"), number(error["largest"], "{:.1e}"),
                        number(error["delta_e"], "{:.2f}"), kib(row["table_bytes"]));
        if (error["not_finite"].asUInt64() > 0)
            line += fmt::format("  {} of {} not a number", error["not_finite"].asUInt64(),
                                error["judged"].asUInt64());
        if (row["verified"].asBool()) return line;
        line += fmt::format("  BEYOND {:g}", row["bound"].asDouble());
        if (!row["delta_e_bound"].isNull())
            line += fmt::format(" or Delta E {:g}", row["delta_e_bound"].asDouble());
        return line;
    }
    if (row["group"] == "frames") {
        line = fmt::format("{:<16} {:<14} {:>10} {:>9} {:>7} {:>7} {:>9.1e} {:>9.1e} {:>7.2f}",
                           row["case"].asString(), row["setting"].asString(),
                           number(row["time_ms"]["median"], "{:.2f}"),
                           number(row["time_ms"]["spread"], "{:.2f}"),
                           number(row["ratio"]["median"], "{:.3f}"), number(row["ratio"]["spread"], "{:.3f}"),
                           error["rms"].asDouble(), error["largest"].asDouble(), error["delta_e"].asDouble());
    } else {
        line = fmt::format(
            "{:<20} {:<22} {:>10} {:>6} {:>7} {:>10} {:>7} {:>8} {:>8}", row["case"].asString(),
            row["setting"].asString(), number(row["time_ms"]["median"], "{:.2f}"),
            number(row["time_ms"]["spread"], "{:.2f}"), number(row["ratio"]["median"], "{:.3f}"),
            number(row["compile_ms"]["median"], "{:.1f}"), number(row["compile_ratio"]["median"], "{:.2f}"),
            kib(row["spirv_bytes"]["left"]), kib(row["spirv_bytes"]["module"]));
    }
    return row["verified"].asBool() ? line : line + "  WRONG, not timed";
}

std::string csvOf(const Json::Value& rows) {
    std::vector<std::string> columns;
    std::vector<std::map<std::string, std::string>> lines;
    for (const Json::Value& row : rows) {
        flatten(row, "", lines.emplace_back());
        for (const auto& [key, cell] : lines.back())
            if (std::find(columns.begin(), columns.end(), key) == columns.end()) columns.push_back(key);
    }
    std::string text;
    const auto addLine = [&](auto cellOf) {
        std::vector<std::string> cells;
        for (const std::string& column : columns) cells.push_back(csvCell(cellOf(column)));
        text += fmt::format("{}\n", fmt::join(cells, ","));
    };
    addLine([](const std::string& column) { return column; });
    for (const auto& line : lines) {
        addLine([&](const std::string& column) {
            const auto cell = line.find(column);
            return cell == line.end() ? std::string() : cell->second;
        });
    }
    return text;
}

std::optional<plot::Scatter> scatterOf(const Json::Value& report) {
    const auto has = [&](const char* group) {
        return std::any_of(report["rows"].begin(), report["rows"].end(),
                           [&](const Json::Value& row) { return row["group"] == group; });
    };
    const bool isOfEvaluators = has("evaluators");
    plot::Scatter scatter{.title = "Error against time",
                          .subtitle = report["device"].asString() + ", " + report["driver"].asString(),
                          .xLabel = isOfEvaluators
                                        ? "milliseconds for a million evaluations, by the host's clock"
                                        : "milliseconds of a frame, by the host's clock",
                          .yLabel = isOfEvaluators ? "largest error, against the peak of the case"
                                                   : "root mean square error of a pixel, against the peak",
                          .series = {},
                          .fronts = {}};
    std::map<std::string, std::vector<plot::ScatterPoint>> cases;
    for (const Json::Value& row : report["rows"]) {
        if (row["group"] != (isOfEvaluators ? "evaluators" : "frames")) continue;
        const double time = row["time_ms"]["median"].asDouble(),
                     error = row["error"][isOfEvaluators ? "largest" : "rms"].asDouble();
        if (!(time > 0.0) || !(error > 0.0)) continue;
        const plot::ScatterPoint point{
            time, error,
            isOfEvaluators ? row["evaluator"].asString() + " " + wordsOf(row) : row["setting"].asString()};
        seriesNamed(row[isOfEvaluators ? "evaluator" : "case"].asString(), scatter.series)
            .points.push_back(point);
        cases[row["case"].asString()].push_back(point);
    }
    if (cases.empty()) return std::nullopt;
    if (cases.size() == 1) scatter.title += ": " + cases.begin()->first;
    for (const auto& [name, points] : cases) scatter.fronts.push_back(frontOf(points));
    return scatter;
}

}  // namespace fringe::cli
