#include "scene/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "optics/curve_file.hpp"
#include "scene/wording.hpp"

namespace fringe::scene {
namespace {

constexpr std::uintmax_t kLargest = std::uintmax_t{16} << 20U;  // bytes; a curve has some thousand lines

void refuseContent(const Node& file, const optics::CurveFileError& error) {
    file.refuse(fmt::format("line {} of {}: {}", error.line(), pathText(file), error.what()));
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

std::string_view withoutBlanks(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<int> ordersOf(std::string_view header, std::size_t line) {
    std::vector<int> orders;
    const std::vector<std::string_view> names = split(header, ',');
    for (std::size_t column = 1; column < names.size(); ++column) {
        const std::string_view name = withoutBlanks(names[column]);
        int order = 0;
        const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), order);
        if (name.empty() || error != std::errc{} || end != name.data() + name.size()) {
            throw optics::CurveFileError(
                line,
                fmt::format("{} is no order; name them, as in \"wavelength_nm, -1, 0, 1\"", inQuotes(name)));
        }
        if (std::find(orders.begin(), orders.end(), order) != orders.end())
            throw optics::CurveFileError(line, fmt::format("order {} is there twice; keep one", order));
        orders.push_back(order);
    }
    if (orders.empty())
        throw optics::CurveFileError(line, "names no order; name them, as in \"wavelength_nm, -1, 0, 1\"");
    return orders;
}

// Each order's column, with that of the wavelengths, becomes a text of two columns with the lines where they
// are in the file.
std::vector<OrderEfficiency> parseOrderCurves(std::string_view text) {
    std::vector<int> orders;
    std::vector<std::string> columns;
    std::size_t number = 0;
    for (const std::string_view whole : split(text, '\n')) {
        ++number;
        const std::string_view line = withoutBlanks(whole);
        const bool counts = !line.empty() && line.front() != '#';
        if (counts && orders.empty()) {
            orders = ordersOf(line, number);
            columns.assign(orders.size(), std::string(number - 1, '\n') + "wavelength_nm,value\n");
            continue;
        }
        if (!counts) {
            for (std::string& column : columns) column += '\n';
            continue;
        }
        const std::vector<std::string_view> fields = split(line, ',');
        if (fields.size() != orders.size() + 1) {
            throw optics::CurveFileError(
                number, fmt::format("has {} columns; write {}, as in the line that names the orders",
                                    fields.size(), orders.size() + 1));
        }
        for (std::size_t i = 0; i < columns.size(); ++i)
            columns[i] += fmt::format("{},{}\n", fields[0], fields[i + 1]);
    }
    if (orders.empty())
        throw optics::CurveFileError(number, "there are no lines; begin with \"wavelength_nm, -1, 0, 1\"");
    std::vector<OrderEfficiency> curves;
    for (std::size_t i = 0; i < orders.size(); ++i)
        curves.push_back({orders[i], optics::parseCurve(columns[i])});
    return curves;
}

}  // namespace

std::filesystem::path pathOf(const Node& file) {
    return file.folder() / file.text();
}

std::string pathText(const Node& file) {
    constexpr std::size_t kLongestPath = 4096;
    return inQuotes(pathOf(file).string(), kLongestPath);
}

std::optional<std::string> textOf(const Node& file) {
    const std::filesystem::path path = pathOf(file);
    std::error_code error;
    const auto refuse = [&](std::string_view why) {
        file.refuse(
            fmt::format("{} {}; write the path of a CSV file, relative to the folder of the scene file",
                        pathText(file), why));
        return std::nullopt;
    };
    if (!std::filesystem::exists(path, error)) return refuse("does not exist");
    if (!std::filesystem::is_regular_file(path, error)) return refuse("is no file");
    if (std::filesystem::file_size(path, error) > kLargest) return refuse("has more than 16 MiB");
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    if (stream) text << stream.rdbuf();
    if (!stream) return refuse("cannot be read");
    return std::move(text).str();
}

std::optional<optics::Curve> curveOf(const Node& file) {
    const std::optional<std::string> text = textOf(file);
    if (!text) return std::nullopt;
    try {
        return optics::parseCurve(*text);
    } catch (const optics::CurveFileError& error) {
        refuseContent(file, error);
        return std::nullopt;
    }
}

std::optional<std::vector<OrderEfficiency>> orderCurvesOf(const Node& file) {
    const std::optional<std::string> text = textOf(file);
    if (!text) return std::nullopt;
    try {
        return parseOrderCurves(*text);
    } catch (const optics::CurveFileError& error) {
        refuseContent(file, error);
        return std::nullopt;
    }
}

}  // namespace fringe::scene
