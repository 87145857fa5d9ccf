// Spectra, and curves of shares between 0 and 1: reflectances, efficiencies of orders.
#pragma once

#include <vector>

#include "scene/node.hpp"

namespace fringe::scene {

// Holds one visible watt. Lines without a width of their own get `linewidth`. Empty, with a problem recorded,
// where a file has no spectrum or where all the weights are 0.
optics::Spectrum spectrumOf(const Node& node, units::Length linewidth = {});

// The light that comes through a filter of the colour at `color`.
optics::Spectrum tinted(const optics::Spectrum& spectrum, const Node& color);

// A number, a colour, a table or a file: a curve from 0 to 1 that covers the visible range. Constant 0, with
// a problem recorded, where it is none.
optics::Curve shareOf(const Node& node);

// By ascending order. Problems are recorded, also where the orders together exceed 1.
std::vector<OrderEfficiency> efficienciesOf(const Node& node);

}  // namespace fringe::scene
