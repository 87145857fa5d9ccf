// Maxima of a sampled curve: which there are, where they lie between the samples, and how well that is known.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fringe::profile {

// Places and widths are in samples; sample i is at place i.
struct Maximum {
    double place;  // the centre of gravity of what stands out at the maximum
    double value;  // of the highest sample
    double
        width;  // full width, at half of the height or, if that is higher, where it parts from its neighbour
    double asymmetry;  // from the top, of a parabola through three samples, to `place`
    std::size_t top;   // the highest sample
};

// What counts as a maximum, for each sample.
struct Threshold {
    double least;       // what is lower is left out
    double separation;  // in samples: two maxima must be this far apart to be told apart
};

// The maxima of `values`, which are 0 or more, from left to right; the ends of the curve are none. Two maxima
// are one where the curve does not fall to 95 % of the lower between them. What is nearer to a higher one
// than the separation is its ripple, and what is nearer than three times that and below a tenth of it is its
// side lobe; neither counts.
std::vector<Maximum> findMaxima(std::span<const double> values, std::span<const Threshold> thresholds);

}  // namespace fringe::profile
