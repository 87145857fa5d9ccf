// How different two colours look: CIELAB and the CIEDE2000 formula (CIE 142, ISO/CIE 11664-6). A difference
// of 1 is about the least that is noticed side by side.
#pragma once

#include <glm/vec3.hpp>

namespace fringe::optics {

struct Lab {
    double l;  // lightness, 100 for white
    double a;  // green to red
    double b;  // blue to yellow
};

// CIE 1976 L*a*b*, of colours seen beside this white.
Lab labFromXyz(const glm::dvec3& xyz, const glm::dvec3& white);

// CIEDE2000 with all weights 1.
double colorDifference(const Lab& first, const Lab& second);

}  // namespace fringe::optics
