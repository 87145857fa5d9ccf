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

}  // namespace

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
    if (group == "frames") {
        return fmt::format("{:<16} {:<14} {:>10} {:>9} {:>7} {:>7} {:>9} {:>9} {:>7}", "frames", "setting",
                           "ms a frame", "+-", "ratio", "+-", "rms error", "largest", "Delta E");
    }
    return fmt::format("{:<20} {:<22} {:>10} {:>6} {:>7} {:>10} {:>7} {:>8} {:>8}", "skip", "against",
                       "ms a frame", "+-", "ratio", "compile ms", "ratio", "KiB left", "of KiB");
}

std::string tableLine(const Json::Value& row) {
    std::string line;
    if (row["group"] == "frames") {
        const Json::Value& error = row["error"];
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
    std::vector<plot::ScatterSeries> series;
    std::vector<plot::ScatterPoint> all;
    std::vector<qualify::Costs> costs;
    for (const Json::Value& row : report["rows"]) {
        const double time = row["time_ms"]["median"].asDouble(), error = row["error"]["rms"].asDouble();
        if (row["group"] == "skip" || !row["verified"].asBool() || !(time > 0.0) || !(error > 0.0)) continue;
        const std::string name = row["case"].asString();
        auto found =
            std::find_if(series.begin(), series.end(), [&](const auto& s) { return s.name == name; });
        if (found == series.end()) found = series.insert(series.end(), {name, {}});
        found->points.push_back({time, error, row["setting"].asString()});
        all.push_back(found->points.back());
        costs.push_back({time, error});
    }
    if (all.empty()) return std::nullopt;
    plot::Scatter scatter{.title = "Error against time",
                          .subtitle = report["device"].asString() + ", " + report["driver"].asString(),
                          .xLabel = "milliseconds of a frame, by the host's clock",
                          .yLabel = "root mean square error of a pixel, against the peak",
                          .series = std::move(series),
                          .front = {}};
    for (const std::size_t i : qualify::paretoFront(costs)) scatter.front.push_back(all[i]);
    return scatter;
}

}  // namespace fringe::cli
