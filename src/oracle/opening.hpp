// Light behind openings of any shape by adding up the waves from their area.
#pragma once

#include <complex>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "optics/aperture.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

// Everything but slits.
using OpeningShape = std::variant<optics::RectangularAperture, optics::CircularAperture,
                                  optics::PolygonalAperture, optics::LatticeAperture, optics::MaskAperture>;

// A line across an opening, along y, that stands for a strip `weight` wide; negative where it takes away.
struct Chord {
    double x;
    double low, high;
    double weight;
};

// Strips of a shape (of a lattice: its cell), for sums of waves that turn up to `turnsPerMetre` times per
// metre. Not for masks.
std::vector<Chord> chords(const OpeningShape& shape, double turnsPerMetre);

// Where the middle of a mask's pixel is.
glm::dvec2 pixelMiddle(const optics::MaskAperture& mask, std::uint32_t column, std::uint32_t row);

// Power that passes for an irradiance of 1 W/m^2.
double openArea(const OpeningShape& shape);

// The same for the beam's irradiance over that at its middle.
double openArea(const OpeningShape& shape, const scene::Beam& beam);

// Diameter of a circle about the middle that holds all of it; `cell`: of a lattice's cell, else the same.
double extent(const OpeningShape& shape);
double cellExtent(const OpeningShape& shape);

// Sums of waves over the area that turn up to `turnsPerMetre` times per metre, each with the amplitude that
// the beam has there, over that at its middle, where its profile is a Gaussian. (A mask takes it up itself,
// see OpeningWave.)
class Opening {
public:
    Opening(const OpeningShape& shape, double turnsPerMetre);
    Opening(const OpeningShape& shape, double turnsPerMetre, const scene::Beam& beam);

    // Of exp(-2 pi i f.r). Square metres.
    std::complex<double> amplitude(const glm::dvec2& turnsPerMetre) const;

    // Calls use(r, weight) for points whose weighted sum is that integral over the area, for any such wave.
    void forPoints(const std::function<void(const glm::dvec2&, double)>& use) const;

private:
    std::complex<double> maskAmplitude(const optics::MaskAperture& mask, const glm::dvec2& f) const;

    OpeningShape shape_;
    double turnsPerMetre_;
    std::optional<scene::Beam> gaussian_;
    std::vector<Chord> chords_;
};

}  // namespace fringe::oracle
