#include "optics/curve_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace fringe::optics {
namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// The part up to `separator`, which is taken off `rest` together with it.
std::string_view cut(std::string_view& rest, char separator) {
    const std::size_t end = std::min(rest.find(separator), rest.size());
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return part;
}

std::optional<double> finiteNumber(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
    return value;
}

}  // namespace

CurveFileError::CurveFileError(std::size_t line, const std::string& message)
    : std::runtime_error(message), line_(line) {}

std::vector<TableRow> readTable(std::string_view text, std::size_t columns) {
    assert(columns <= std::tuple_size_v<decltype(TableRow::values)>);
    std::vector<TableRow> rows;
    bool mayNameColumns = true;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::string_view line = trimmed(cut(text, '\n'));
        if (line.empty() || line.front() == '#') continue;
        const bool first = std::exchange(mayNameColumns, false);
        if (first && !finiteNumber(trimmed(line.substr(0, line.find(','))))) continue;

        TableRow row{number, {}};
        std::string_view rest = line;
        bool sound = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1 == columns;
        for (std::size_t column = 0; sound && column < columns; ++column) {
            const std::optional<double> value = finiteNumber(trimmed(cut(rest, ',')));
            sound = value.has_value();
            row.values[column] = value.value_or(0.0);
        }
        if (!sound)
            throw CurveFileError(number, fmt::format("must be {} finite numbers with commas between them, as "
                                                     "in \"550,0.25\"",
                                                     columns));
        rows.push_back(row);
    }
    return rows;
}

Curve parseCurve(std::string_view text) {
    Curve curve;
    std::size_t last = 1;
    for (const TableRow& row : readTable(text, 2)) {
        const auto [wavelength_nm, value] = std::pair{row.values[0], row.values[1]};
        if (!curve.empty() && wavelength_nm <= curve.back().wavelength_nm)
            throw CurveFileError(row.line,
                                 fmt::format("wavelength {} nm must be longer than the one before, {} nm",
                                             wavelength_nm, curve.back().wavelength_nm));
        if (value < 0.0) throw CurveFileError(row.line, fmt::format("value {} must be at least 0", value));
        curve.push_back({wavelength_nm, value});
        last = row.line;
    }
    if (curve.size() < 2) throw CurveFileError(last, "a curve needs two rows or more of wavelength_nm,value");
    if (curve.back().wavelength_nm <= kShortestVisible_nm ||
        curve.front().wavelength_nm >= kLongestVisible_nm)
        throw CurveFileError(last, fmt::format("no part of {} to {} nm is visible, which is 380 to 780 nm",
                                               curve.front().wavelength_nm, curve.back().wavelength_nm));
    return curve;
}

}  // namespace fringe::optics
