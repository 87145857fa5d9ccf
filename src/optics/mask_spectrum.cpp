#include "optics/mask_spectrum.hpp"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <complex>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <numeric>
#include <span>

#include "optics/integrals.hpp"
#include "optics/shares.hpp"
#include "optics/spline_table.hpp"

namespace fringe::optics {
namespace {

using glm::dvec2;
using std::numbers::pi;
using units::m;

// Points of the table along an axis: those wanted for each pixel, in a table that stays in memory caches and
// textures; four for each where that is not enough.
std::uint32_t tableSize(std::uint32_t pixels, std::uint32_t pointsPerPixel) {
    constexpr std::uint32_t kLargest = 4096;
    return std::max(std::min(std::bit_ceil(pointsPerPixel * pixels), kLargest), std::bit_ceil(4 * pixels));
}

// rows x (columns + 2) reals that FFTW turns, in place, into rows x (columns/2 + 1) complex numbers.
class Grid {
public:
    Grid(std::uint32_t columns, std::uint32_t rows)
        : columns_(columns), rows_(rows), data_(fftwf_alloc_real(std::size_t{rows} * (columns + 2))) {
        std::fill_n(data_.get(), std::size_t{rows} * (columns + 2), 0.0F);
    }

    float& real(std::uint32_t column, std::uint32_t row) {
        return data_.get()[std::size_t{row} * (columns_ + 2) + column];
    }
    std::complex<float>* complexNumbers() { return reinterpret_cast<std::complex<float>*>(data_.get()); }
    std::size_t complexCount() const { return std::size_t{rows_} * (columns_ / 2 + 1); }

    void transform() {
        execute(fftwf_plan_dft_r2c_2d(static_cast<int>(rows_), static_cast<int>(columns_), data_.get(),
                                      reinterpret_cast<fftwf_complex*>(data_.get()), FFTW_ESTIMATE));
    }
    void transformBack() {
        execute(fftwf_plan_dft_c2r_2d(static_cast<int>(rows_), static_cast<int>(columns_),
                                      reinterpret_cast<fftwf_complex*>(data_.get()), data_.get(),
                                      FFTW_ESTIMATE));
    }

private:
    static void execute(fftwf_plan plan) {
        fftwf_execute(plan);
        fftwf_destroy_plan(plan);
    }

    struct Free {
        void operator()(float* data) const { fftwf_free(data); }
    };
    std::uint32_t columns_;
    std::uint32_t rows_;
    std::unique_ptr<float, Free> data_;
};

// Twice the mask holds its autocorrelation, at all lags from -(pixels - 1) to pixels - 1.
Grid autocorrelation(const AmplitudeGrid& mask) {
    Grid grid(2 * mask.columns, 2 * mask.rows);
    for (std::uint32_t row = 0; row < mask.rows; ++row)
        for (std::uint32_t column = 0; column < mask.columns; ++column)
            grid.real(column, row) = mask.amplitudes[std::size_t{row} * mask.columns + column];
    grid.transform();
    for (std::size_t i = 0; i < grid.complexCount(); ++i)
        grid.complexNumbers()[i] = std::norm(grid.complexNumbers()[i]);
    grid.transformBack();
    return grid;
}

// The table of the lags' weighted autocorrelation, of the size that `level` has.
std::vector<float> weightedTransform(Grid& lags, const AmplitudeGrid& mask, const MaskSpectrum::Level& level,
                                     std::span<const float> acrossWeights, std::span<const float> downWeights,
                                     float scale) {
    Grid table(level.columns, level.rows);
    for (std::uint32_t j = 0; j < 2 * mask.rows; ++j) {
        const bool isUp = j > mask.rows;
        const std::uint32_t lagY = isUp ? 2 * mask.rows - j : j;
        if (lagY >= downWeights.size()) continue;
        for (std::uint32_t i = 0; i < 2 * mask.columns; ++i) {
            const bool isLeft = i > mask.columns;
            const std::uint32_t lagX = isLeft ? 2 * mask.columns - i : i;
            if (lagX >= acrossWeights.size()) continue;
            table.real(isLeft ? level.columns - lagX : lagX, isUp ? level.rows - lagY : lagY) =
                scale * acrossWeights[lagX] * downWeights[lagY] * lags.real(i, j);
        }
    }
    table.transform();
    std::vector<float> values(table.complexCount());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = table.complexNumbers()[i].real();
    return values;
}

// Of the four cubic B-splines around a point `t` behind the second.
std::array<double, 4> splineWeights(double t) {
    const double s = 1.0 - t;
    return {s * s * s / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
            (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0, t * t * t / 6.0};
}

}  // namespace

MaskSpectrum::MaskSpectrum(const AmplitudeGrid& mask, std::uint32_t pointsPerPixel)
    : extent_(dvec2(mask.columns, mask.rows) * mask.pixel),
      pixel_(mask.pixel),
      peak_(std::pow(
          std::accumulate(mask.amplitudes.begin(), mask.amplitudes.end(), 0.0) * (pixel_.x * pixel_.y), 2)),
      area_(mask.area),
      edges_(mask.edges),
      hasHats_(mask.hasHats) {
    assert(peak_ > 0.0);

    // FFTW's round trip multiplies by the number of points.
    const double pixels = 4.0 * mask.columns * mask.rows;
    const auto scale = static_cast<float>(std::pow(pixel_.x * pixel_.y, 2) / (pixels * peak_));
    Grid lags = autocorrelation(mask);
    const std::uint32_t columns = tableSize(mask.columns, pointsPerPixel);
    const std::uint32_t rows = tableSize(mask.rows, pointsPerPixel);
    for (std::uint32_t size = std::max(columns, rows); size > 1; size /= 2) {
        Level level{std::min(columns, size), std::min(rows, size), {}};
        const double width = levels_.empty() ? 0.0 : 1.0 / size;
        const auto weights = [&](std::uint32_t pixels, std::uint32_t points) {
            return lagWeights(std::min(pixels, points / 2), points, width);
        };
        level.values = weightedTransform(lags, mask, level, weights(mask.columns, level.columns),
                                         weights(mask.rows, level.rows), scale);
        levels_.push_back(std::move(level));
    }
}

double MaskSpectrum::coefficient(std::int64_t i, std::int64_t j) const {
    std::int64_t column = i & (columns() - 1);
    std::int64_t row = j;
    if (column > columns() / 2) {
        column = columns() - column;
        row = -row;
    }
    row &= rows() - 1;
    return values()[static_cast<std::size_t>(row * (columns() / 2 + 1) + column)];
}

double MaskSpectrum::pixelFactor(dvec2 f_per_m) const {
    const double factor = sinc(pixel_.x * f_per_m.x) * sinc(pixel_.y * f_per_m.y);
    return std::pow(factor, hasHats_ ? 4 : 2);
}

// The mask's rows run down while y runs up, so the row of frequencies is -y.
double MaskSpectrum::relativePower(dvec2 f_per_m) const {
    const double x = f_per_m.x * pixel_.x * columns(), y = -f_per_m.y * pixel_.y * rows();
    const double left = std::floor(x), up = std::floor(y);
    const std::array<double, 4> across = splineWeights(x - left), down = splineWeights(y - up);
    const auto column = static_cast<std::int64_t>(left) - 1, row = static_cast<std::int64_t>(up) - 1;
    double sum = 0.0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            sum += across[static_cast<std::size_t>(i)] * down[static_cast<std::size_t>(j)] *
                   coefficient(column + i, row + j);
    return sum * pixelFactor(f_per_m);
}

// See edgesBeyond() of polygon_share.cpp.
double MaskSpectrum::evanescentEdges(double wavelength, dvec2 incident) const {
    const Incidence in{wavelength, incident};
    double sum = 0.0;
    for (const Edge& edge : edges_)
        sum += edge.weight * (1.0 / reach(in, edge.normal) + 1.0 / reach(in, -edge.normal));
    return wavelength / (4.0 * pi * pi * area_) * sum;
}

double MaskSpectrum::propagatingShare(units::Length wavelength, double alphaIn, double betaIn) const {
    constexpr double kWide = 200.0;  // wavelengths; beyond, the sum takes longer than a frame
    const dvec2 incident(alphaIn, betaIn);
    const double wave = wavelength / m;
    const bool repeats = hasHats_ && std::max(pixel_.x, pixel_.y) > 0.25 * wave;
    if (std::max(extent_.x, extent_.y) > kWide * wave || repeats)
        return 1.0 - evanescentEdges(wave, incident);

    // |A|^2 is band-limited: its integral over the plane is the sum over this grid. A point near the edge of
    // what propagates counts by how much of its surroundings does.
    const dvec2 step(0.5 / extent_.x, 0.5 / extent_.y);
    const dvec2 sineStep = wave * step;
    const auto fromX = static_cast<std::int64_t>((-1.0 - alphaIn) / sineStep.x) - 1;
    const auto toX = static_cast<std::int64_t>((1.0 - alphaIn) / sineStep.x) + 1;
    const auto fromY = static_cast<std::int64_t>((-1.0 - betaIn) / sineStep.y) - 1;
    const auto toY = static_cast<std::int64_t>((1.0 - betaIn) / sineStep.y) + 1;
    double sum = 0.0;
    for (std::int64_t j = fromY; j <= toY; ++j) {
        for (std::int64_t i = fromX; i <= toX; ++i) {
            const dvec2 steps(static_cast<double>(i), static_cast<double>(j));
            const dvec2 out = incident + sineStep * steps;
            const double sine = glm::length(out);
            const double span = sine == 0.0 ? 1.0 : glm::dot(glm::abs(out), sineStep) / sine;
            const double covered = std::clamp(0.5 + (1.0 - sine) / span, 0.0, 1.0);
            if (covered > 0.0) sum += covered * relativePower(step * steps);
        }
    }
    return sum * peak_ * step.x * step.y / area_;
}

double shareOf(const MaskAperture& mask, const Incidence& in) {
    return MaskSpectrum(gridOf(mask)).propagatingShare(in.wavelength * m, in.direction.x, in.direction.y);
}

}  // namespace fringe::optics
