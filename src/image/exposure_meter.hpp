// Automatic exposure: meters a picture as it comes, in bounded memory.
//
// The measure is the highlights: what a fringe pattern must not lose is its maxima, and the dark around them,
// however much of the picture it fills, says nothing. A pixel's value is its largest linear channel once its
// colour has no channel below 0, so for a neutral one its luminance; a saturated red reaches the limit of the
// display long before its luminance does, and would be bleached if that alone counted. Pixels more than ten
// stops below the brightest are dark to any display and are left out; of the rest the 99th percentile, as
// image appearance models take it for the white of a picture (iCAM06: Kuang, Johnson and Fairchild, J. Vis.
// Commun. Image R. 18, 2007), is put half a stop below display white, the headroom that ISO 12232 leaves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/develop.hpp"

namespace fringe::image {

class ExposureMeter {
public:
    // Meters what `development` would show; its exposure does not count.
    explicit ExposureMeter(const Development& development);

    void add(std::span<const Pixel> pixels);

    // Stops, rounded to a hundredth, so that the number as printed gives the same picture again.
    // 0 while there is no light at all.
    double exposure() const;

private:
    DisplayTransform displayed_;
    std::vector<std::uint64_t> counts_;  // by the leading bits of the value, 128 bins an octave
};

}  // namespace fringe::image
