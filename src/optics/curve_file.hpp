// Tables of numbers as text: lines that start with '#' are comments, the first other line may name the
// columns, and every further line holds numbers with commas between them. Empty lines do not count.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "optics/spectrum.hpp"

namespace fringe::optics {

class CurveFileError : public std::runtime_error {
public:
    CurveFileError(std::size_t line, const std::string& message);
    // Counted from 1.
    std::size_t line() const noexcept { return line_; }

private:
    std::size_t line_;
};

struct TableRow {
    std::size_t line;  // of the text, counted from 1
    std::array<double, 4> values;
};

// The rows of a table of at most four columns. Throws CurveFileError where a line does not hold `columns`
// finite numbers.
std::vector<TableRow> readTable(std::string_view text, std::size_t columns);

// A spectrum or a reflectance: wavelength_nm,value with ascending wavelengths and values of at least 0; two
// rows or more, some part of them visible. Throws CurveFileError, whose what() is without the line.
Curve parseCurve(std::string_view text);

}  // namespace fringe::optics
