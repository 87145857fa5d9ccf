// Apertures: the openings that light passes, in the plane of the grating. x runs across the slits, y along
// them.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <variant>
#include <vector>

#include "units/units.hpp"

namespace fringe::optics {

// `count` long slits of `width`, `period` from centre to centre. Invariant: width <= period where there are
// several.
struct Slits {
    std::uint32_t count;
    units::Length width;
    units::Length period;

    bool operator==(const Slits&) const = default;
};

struct RectangularAperture {
    units::Length width;   // across, along x
    units::Length height;  // along y
};

// A ring where innerDiameter > 0.
struct CircularAperture {
    units::Length diameter;
    units::Length innerDiameter;
};

// A simple polygon. Invariant: at least three vertices, counter-clockwise, centroid at 0.
struct PolygonalAperture {
    std::vector<glm::dvec2> vertices;  // metres
};

// A picture of the opening, row by row from the top (largest y); its middle is at 0.
struct MaskAperture {
    std::uint32_t columns;
    std::uint32_t rows;
    units::Length pixel;              // edge of a pixel
    std::vector<float> transmission;  // of the amplitude, 0 to 1
};

using Cell = std::variant<RectangularAperture, CircularAperture, PolygonalAperture>;

// The same opening at i * first + j * second, counted about the middle. Invariant: neither vector is along
// the other.
struct LatticeAperture {
    Cell cell;
    glm::dvec2 first;  // metres
    glm::dvec2 second;
    std::uint32_t firstCount;
    std::uint32_t secondCount;
};

using Aperture = std::variant<Slits, RectangularAperture, CircularAperture, PolygonalAperture,
                              LatticeAperture, MaskAperture>;

}  // namespace fringe::optics
