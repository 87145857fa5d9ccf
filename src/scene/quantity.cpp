#include "scene/quantity.hpp"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include "units/units.hpp"

namespace fringe::scene {
namespace {

struct Unit {
    std::string_view text;
    Dimension dimension;
    double si;
};

constexpr std::array kUnits{
    Unit{"m", Dimension::length, units::m.si},
    Unit{"cm", Dimension::length, units::cm.si},
    Unit{"mm", Dimension::length, units::mm.si},
    Unit{"um", Dimension::length, units::um.si},
    Unit{"nm", Dimension::length, units::nm.si},
    Unit{"deg", Dimension::angle, units::deg.si},
    Unit{"rad", Dimension::angle, units::rad.si},
    Unit{"mrad", Dimension::angle, 1e-3 * units::rad.si},
    Unit{"W", Dimension::power, units::W.si},
    Unit{"mW", Dimension::power, 1e-3 * units::W.si},
    Unit{"uW", Dimension::power, 1e-6 * units::W.si},
    Unit{"kW", Dimension::power, 1e3 * units::W.si},
    Unit{"W/m^2", Dimension::irradiance, units::W_per_m2.si},
    Unit{"mW/cm^2", Dimension::irradiance, 10.0 * units::W_per_m2.si},
    Unit{"W/m^2/sr", Dimension::radiance, units::W_per_m2_sr.si},
    Unit{"K", Dimension::temperature, units::K.si},
};

struct DimensionName {
    Dimension dimension;
    std::string_view name;
};

constexpr std::array kDimensionNames{
    DimensionName{Dimension::length, "length"},     DimensionName{Dimension::angle, "angle"},
    DimensionName{Dimension::power, "power"},       DimensionName{Dimension::irradiance, "irradiance"},
    DimensionName{Dimension::radiance, "radiance"}, DimensionName{Dimension::temperature, "temperature"},
};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

// Of "inf", "nan" and a bare point, which from_chars takes or leaves as it likes, none is a number here.
bool beginsWithNumber(std::string_view text) {
    if (!text.empty() && text.front() == '-') text.remove_prefix(1);
    if (text.empty()) return false;
    return isDigit(text[0]) || (text[0] == '.' && text.size() > 1 && isDigit(text[1]));
}

// "um" may also be written with the micro sign or with the Greek letter mu.
bool isSameUnit(std::string_view written, std::string_view known) {
    for (const std::string_view micro : {"\u00b5", "\u03bc"}) {
        if (written.starts_with(micro)) {
            return known.starts_with('u') && written.substr(micro.size()) == known.substr(1);
        }
    }
    return written == known;
}

}  // namespace

std::string_view nameOf(Dimension dimension) {
    for (const DimensionName& entry : kDimensionNames) {
        if (entry.dimension == dimension) return entry.name;
    }
    return {};
}

std::optional<Dimension> dimensionNamed(std::string_view name) {
    for (const DimensionName& entry : kDimensionNames) {
        if (entry.name == name) return entry.dimension;
    }
    return std::nullopt;
}

std::vector<std::string> unitsOf(Dimension dimension) {
    std::vector<std::string> texts;
    for (const Unit& unit : kUnits) {
        if (unit.dimension == dimension) texts.emplace_back(unit.text);
    }
    return texts;
}

std::optional<QuantityText> splitQuantity(std::string_view text) {
    text = trimmed(text);
    if (!beginsWithNumber(text)) return std::nullopt;
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
    return QuantityText{number, trimmed(text.substr(static_cast<std::size_t>(end - text.data())))};
}

std::optional<double> unitInSi(std::string_view unit, Dimension dimension) {
    for (const Unit& known : kUnits) {
        if (known.dimension == dimension && isSameUnit(unit, known.text)) return known.si;
    }
    return std::nullopt;
}

double quantityInSi(std::string_view text, Dimension dimension) {
    const std::optional<QuantityText> parts = splitQuantity(text);
    assert(parts);
    const std::optional<double> unit = unitInSi(parts->unit, dimension);
    assert(unit);
    return parts->number * *unit;
}

}  // namespace fringe::scene
