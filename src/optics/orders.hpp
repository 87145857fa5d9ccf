// Orders of a grating: where they go and what they take.
#pragma once

namespace fringe::optics {

// Whether direction cosines belong to light: beyond, the wave is evanescent and carries nothing away.
bool propagates(double alpha, double beta);

// Share of the power that falls on a grating of slits (an amplitude grating) which order `order` takes,
// evanescent or not; `fill` is width/period. All together take `fill` (Born & Wolf 8.6.1).
double orderEfficiency(double fill, double order);

}  // namespace fringe::optics
