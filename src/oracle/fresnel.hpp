// Reflection and refraction at a smooth interface.
#pragma once

#include <complex>
#include <optional>

#include "oracle/ray.hpp"

namespace fringe::oracle {

// Share of unpolarised light that an interface reflects, 0..1: the mean of Fresnel's two equations in complex
// arithmetic, which makes one function of glass, total internal reflection (1) and metal (M. Born, E. Wolf,
// "Principles of Optics", 7th ed., 1.5.2 and 14.2). `relativeIndex` is the index behind the interface over
// the one before it, n + i k with k >= 0; `cosine` is of the angle of incidence, in 0..1.
double reflectance(double cosine, std::complex<double> relativeIndex);

inline dvec3 reflected(const dvec3& direction, const dvec3& normal) {
    return direction - 2.0 * glm::dot(direction, normal) * normal;
}

// Snell's law. `normal` is unit and points against `direction`. Nothing if the reflection is total.
std::optional<dvec3> refracted(const dvec3& direction, const dvec3& normal, double relativeIndex);

}  // namespace fringe::oracle
