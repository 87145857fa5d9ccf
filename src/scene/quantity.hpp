// Quantities as scene files write them: a number and a unit in a string, "1.6 um".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fringe::scene {

enum class Dimension { length, angle, power, irradiance, radiance, temperature };

// "length", "angle", ...: the name that the schema's keyword "unit" uses.
std::string_view nameOf(Dimension dimension);
std::optional<Dimension> dimensionNamed(std::string_view name);

// The units of a dimension, the way messages and the schema's patterns write them (u for micro).
std::vector<std::string> unitsOf(Dimension dimension);

// A quantity taken apart. Spaces around it and between number and unit do not count.
struct QuantityText {
    double number;          // finite; may be negative, so that a message can say what is wrong with that
    std::string_view unit;  // what follows the number; may be empty, or no unit at all
};

// Empty where the text does not begin with a finite decimal number.
std::optional<QuantityText> splitQuantity(std::string_view text);

// The SI value of one such unit; a micro sign is as good as u. Empty where the dimension has no such unit.
std::optional<double> unitInSi(std::string_view unit, Dimension dimension);

// The SI value of a quantity which is known to be one of that dimension.
double quantityInSi(std::string_view text, Dimension dimension);

}  // namespace fringe::scene
