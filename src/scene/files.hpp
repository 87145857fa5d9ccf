// The files that a scene names. What is wrong with one is a problem at the key that names it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "optics/spectrum.hpp"
#include "scene/node.hpp"

namespace fringe::scene {

// Where the file is: relative to the folder of the scene file.
std::filesystem::path pathOf(const Node& file);

// The same for messages: whole, in double quotes.
std::string pathText(const Node& file);

// The text of a file of at most 16 MiB; empty, with a problem recorded, where it cannot be read.
std::optional<std::string> textOf(const Node& file);

// The curve in a CSV file (optics::parseCurve); empty, with a problem recorded, where it holds none.
std::optional<optics::Curve> curveOf(const Node& file);

// The curves of several orders in a CSV file: its first line that is no comment names the orders after the
// name of the wavelengths, "wavelength_nm, -1, 0, 1", each further line has as many numbers. Empty, with a
// problem recorded, where it holds none.
std::optional<std::vector<OrderEfficiency>> orderCurvesOf(const Node& file);

}  // namespace fringe::scene
