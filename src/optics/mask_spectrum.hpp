// The far field of a mask, or of an opening on a grid of pixels: |A|^2 on a fine grid of frequencies, which
// serves every wavelength.
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "optics/amplitude_grid.hpp"

namespace fringe::optics {

// |A(f)|^2 / |A(0)|^2 as a sum of cubic B-splines, times what a single pixel makes of it. The coefficients
// are the transform of the mask's autocorrelation, divided beforehand by the B-spline's own transform, so
// what is left of the interpolation's error is aliasing (as in a non-uniform FFT). Relative to the peak it
// stays below 5e-4, and in pictures without lone pixels at far corners below 5e-5, while the table has eight
// points or more for each pixel; it grows as the inverse fourth power towards four points (masks of more than
// 512 pixels).
class MaskSpectrum {
public:
    // Takes the time of two fast Fourier transforms of the table's size, which has at least so many points
    // for each pixel, up to eight, where that is no more than 4096. The mask may not be all opaque.
    explicit MaskSpectrum(const AmplitudeGrid& mask, std::uint32_t pointsPerPixel = 8);

    // Relative to the peak; `f_per_m` as in transform().
    double relativePower(glm::dvec2 f_per_m) const;

    // |A(0)|^2 in m^4.
    double peak() const { return peak_; }

    // m^2: integral of the squared amplitude.
    double area() const { return area_; }

    // Of what is open.
    std::span<const Edge> edges() const { return edges_; }

    // Width and height of a pixel in metres, whether it is a hat, and how many there are from corner to
    // corner.
    glm::dvec2 pixel() const { return pixel_; }
    bool hasHats() const { return hasHats_; }
    double pixelsAcross() const { return glm::length(extent_ / pixel_); }

    // As propagatingShare(). Error 1e-4 from 5 to 200 wavelengths across and 1e-3 below; of wider masks what
    // is evanescent (below 1e-2) is known to a fourth. Where the pixels are hats
    // and wider than a quarter of a wavelength its edges give the share.
    double propagatingShare(units::Length wavelength, double alphaIn, double betaIn) const;

    // Coefficient of the B-spline at frequency (i/columns, j/rows)/pixel: values()[j * (columns/2 + 1) + i]
    // for 0 <= i <= columns/2, 0 <= j < rows. The others follow from the periods `columns`, `rows` and from
    // symmetry: (i, j) has the value of (-i, -j).
    std::span<const float> values() const { return levels_.front().values; }
    std::uint32_t columns() const { return levels_.front().columns; }
    std::uint32_t rows() const { return levels_.front().rows; }

    // The same averaged over more and more of its surroundings, for pixels that see so much at once. Level k
    // is the table under a Gaussian whose standard deviation is 2^k times the smaller step of the first, with
    // half as many points along an axis as the level before wherever these are more than that width asks for.
    // Level 0 is not averaged, the last one is even.
    struct Level {
        std::uint32_t columns;
        std::uint32_t rows;
        std::vector<float> values;
    };
    std::span<const Level> levels() const { return levels_; }

private:
    double coefficient(std::int64_t i, std::int64_t j) const;
    double pixelFactor(glm::dvec2 f_per_m) const;
    double evanescentEdges(double wavelength, glm::dvec2 incident) const;

    glm::dvec2 extent_;  // of the mask, metres
    glm::dvec2 pixel_;   // metres
    double peak_;        // m^4
    double area_;        // m^2
    std::vector<Edge> edges_;
    bool hasHats_;
    std::vector<Level> levels_;
};

}  // namespace fringe::optics
