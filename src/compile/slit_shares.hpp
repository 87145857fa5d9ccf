// The share of what slits send out that is not evanescent, over the whole spectrum.
#pragma once

#include <memory>
#include <vector>

#include "compile/slit_response.hpp"

namespace fringe::compile {

class TableMemo;

// LitSlits::propagatingShare() at every `step_nm` of the visible range, both ends included
// (continuousSamples()). From the memo, if there is one: thousands of slits take most of a millisecond for
// each. A draft is that of fewer slits, and straight lines between some wavelengths.
std::shared_ptr<const std::vector<double>> propagatingShares(const LitSlits& lit, double step_nm,
                                                             TableMemo* memo);

}  // namespace fringe::compile
