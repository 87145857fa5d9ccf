#include "compile/uneven_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace fringe::compile {

using glm::dvec2;

std::optional<LitCells> litCells(const optics::LatticeAperture& lattice, double beamWidth) {
    constexpr double kReach = 3.7;      // radii of the beam, as gaussianGrid() has it
    constexpr double kWideInCells = 2;  // an order's neighbours then add 1e-8 of the peak halfway
    constexpr std::uint32_t kMostCells = 512;
    const double radius = 0.5 * beamWidth;
    const double area = std::abs(lattice.first.x * lattice.second.y - lattice.first.y * lattice.second.x);
    LitCells lit{0, 0,
                 2.0 * radius >=
                     2.0 * kWideInCells * std::max(glm::length(lattice.first), glm::length(lattice.second))};
    // Cells of a row lie so far apart, square to the other row; as many as the row has, even or odd.
    const auto within = [&](std::uint32_t count, dvec2 other) {
        const double reached = kReach * radius * glm::length(other) / area;
        if (reached > 0.5 * count) {
            lit.isWhole = false;
            return count;
        }
        const std::uint32_t odd = count % 2;
        return odd + 2 * static_cast<std::uint32_t>(std::ceil(reached - 0.5 * odd));
    };
    lit.firstCount = std::min(within(lattice.firstCount, lattice.second), lattice.firstCount);
    lit.secondCount = std::min(within(lattice.secondCount, lattice.first), lattice.secondCount);
    if (!lit.isWhole && std::max(lit.firstCount, lit.secondCount) > kMostCells) return {};
    return lit;
}

optics::AmplitudeGrid cellAmplitudes(const optics::LatticeAperture& lattice, double beamWidth,
                                     const LitCells& lit) {
    optics::AmplitudeGrid cells{lit.firstCount, lit.secondCount, dvec2(1.0), {}, 0.0, {}, false};
    for (std::uint32_t j = lit.secondCount; j-- > 0;) {
        for (std::uint32_t i = 0; i < lit.firstCount; ++i) {
            const dvec2 place = (i - 0.5 * (lit.firstCount - 1.0)) * lattice.first +
                                (j - 0.5 * (lit.secondCount - 1.0)) * lattice.second;
            const double amplitude = std::exp(-4.0 * glm::dot(place, place) / (beamWidth * beamWidth));
            cells.amplitudes.push_back(static_cast<float>(amplitude));
            cells.area += amplitude * amplitude;
        }
    }
    return cells;
}

dvec2 cellVariance(const optics::AmplitudeGrid& cells) {
    dvec2 squares(0.0);
    double sum = 0.0;
    auto amplitude = cells.amplitudes.begin();
    for (std::uint32_t j = 0; j < cells.rows; ++j) {
        for (std::uint32_t i = 0; i < cells.columns; ++i, ++amplitude) {
            const dvec2 place(i - 0.5 * (cells.columns - 1.0), j - 0.5 * (cells.rows - 1.0));
            squares += double{*amplitude} * place * place;
            sum += *amplitude;
        }
    }
    return squares / sum;
}

}  // namespace fringe::compile
