// How much of each pixel of a grid lies inside outlines, exactly.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace fringe::optics {

struct Covered {
    double share;         // of the pixel
    glm::dvec2 centroid;  // of that share, off the pixel's middle, in pixels
};

// Row by row. The pixels are unit squares from (0, 0) to (columns, rows); what of an outline lies outside
// does not count. Outlines may turn either way: a hole is one that turns the other way than what it is in.
std::vector<Covered> coverage(std::span<const std::vector<glm::dvec2>> outlines, std::uint32_t columns,
                              std::uint32_t rows);

}  // namespace fringe::optics
