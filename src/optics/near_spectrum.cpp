#include "optics/near_spectrum.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <type_traits>
#include <utility>

#include "optics/spline_table.hpp"

namespace fringe::optics {
namespace {

using glm::dvec2;
using std::numbers::pi;
using ComplexFloat = std::complex<float>;

struct Free {
    void operator()(void* data) const { fftwf_free(data); }
};
using ComplexData = std::unique_ptr<ComplexFloat, Free>;
using RealData = std::unique_ptr<float, Free>;

ComplexData complexData(std::size_t count) {
    ComplexData data(reinterpret_cast<ComplexFloat*>(fftwf_alloc_complex(count)));
    std::fill_n(data.get(), count, ComplexFloat(0.0F));
    return data;
}
fftwf_complex* raw(const ComplexData& data) {
    return reinterpret_cast<fftwf_complex*>(data.get());
}

ComplexFloat turned(double turns) {
    return ComplexFloat(std::polar(1.0, 2.0 * pi * turns));
}

// Of a lag in a table of `points`: what repeats itself too nearly for cubic B-splines to follow is left out.
double sampled(std::uint32_t lag, std::uint32_t points) {
    constexpr double kWhole = 0.25, kNone = 0.45;
    const double place = std::clamp((double(lag) / points - kWhole) / (kNone - kWhole), 0.0, 1.0);
    return std::pow(std::cos(0.5 * pi * place), 2);
}

}  // namespace

// FFTW makes plans in one thread at a time, but carries them out in many.
struct NearSpectrum::Plans {
    struct Destroy {
        void operator()(fftwf_plan plan) const { fftwf_destroy_plan(plan); }
    };
    using Plan = std::unique_ptr<std::remove_pointer_t<fftwf_plan>, Destroy>;

    Plan forward, back, line;  // of a convolution, and of one of its lines
    Plan lags;                 // of a pattern
    std::vector<Plan> tables;  // of the levels

    Plans(int convolution, int pattern, std::uint32_t points) {
        const auto size = static_cast<std::size_t>(convolution) * static_cast<std::size_t>(convolution);
        const std::size_t most = std::max(size, std::size_t{points} * (points / 2 + 1));
        const ComplexData data = complexData(most), other = complexData(most);
        auto* real = reinterpret_cast<float*>(other.get());
        for (auto [plan, sign] : {std::pair(&forward, FFTW_FORWARD), std::pair(&back, FFTW_BACKWARD)})
            plan->reset(
                fftwf_plan_dft_2d(convolution, convolution, raw(data), raw(data), sign, FFTW_ESTIMATE));
        line.reset(fftwf_plan_dft_1d(convolution, raw(data), raw(data), FFTW_FORWARD, FFTW_ESTIMATE));
        lags.reset(fftwf_plan_dft_r2c_2d(pattern, pattern, real, raw(data), FFTW_ESTIMATE));
        for (auto level = static_cast<int>(points); level > 1; level /= 2)
            tables.emplace_back(fftwf_plan_dft_c2r_2d(level, level, raw(data), real, FFTW_ESTIMATE));
    }
};

NearSpectrum::NearSpectrum(AmplitudeSamples samples, dvec2 incoming, std::uint32_t points, double stretch)
    : samples_(std::move(samples)),
      incoming_(incoming),
      points_(points),
      stretch_(stretch),
      peak_(std::pow(std::accumulate(samples_.amplitudes.begin(), samples_.amplitudes.end(), 0.0), 2)),
      plans_(std::make_unique<Plans>(static_cast<int>(3 * samples_.across),
                                     static_cast<int>(2 * samples_.across), points)) {}

NearSpectrum::~NearSpectrum() = default;

// As a convolution (L. I. Bluestein, "A linear filtering approach to the computation of discrete Fourier
// transform", IEEE Transactions on Audio and Electroacoustics 18, 451, 1970), which lets frequencies be as
// far apart as one likes: here 1/(2 across pixel) times `stretch`, enough for all of |A|^2.
void NearSpectrum::addPattern(double number, double stretch, double weight,
                              std::vector<float>& pattern) const {
    const std::uint32_t across = samples_.across, size = 3 * across;
    const double perStep = 0.25 * stretch / across;  // turns of a half square, of a frequency or a sample
    const double pixel = samples_.pixel / samples_.half, middle = 0.5 * (across - 1.0);

    const ComplexData data = complexData(std::size_t{size} * size), line = complexData(size);
    for (std::uint32_t row = 0; row < across; ++row) {
        for (std::uint32_t column = 0; column < across; ++column) {
            const float amplitude = samples_.amplitudes[std::size_t{row} * across + column];
            if (amplitude == 0.0F) continue;
            const dvec2 steps(column - middle, middle - row), place = pixel * steps;
            const double aside = glm::dot(incoming_, place), square = glm::dot(steps, steps);
            const double turns = 0.5 * number * (glm::dot(place, place) - aside * aside) - perStep * square;
            data.get()[std::size_t{row} * size + column] = amplitude * turned(turns);
        }
    }
    for (std::uint32_t i = 0; i < size; ++i) {
        const double steps = i < 2 * across ? double(i) : double(i) - size;
        line.get()[i] = turned(perStep * std::pow(steps - 0.5 * (across + 1.0), 2)) / float(size);
    }
    fftwf_execute_dft(plans_->line.get(), raw(line), raw(line));
    fftwf_execute_dft(plans_->forward.get(), raw(data), raw(data));
    for (std::uint32_t row = 0; row < size; ++row)
        for (std::uint32_t column = 0; column < size; ++column)
            data.get()[std::size_t{row} * size + column] *= line.get()[row] * line.get()[column];
    fftwf_execute_dft(plans_->back.get(), raw(data), raw(data));

    const auto factor = static_cast<float>(weight * stretch * stretch / peak_);
    for (std::uint32_t row = 0; row < 2 * across; ++row) {
        for (std::uint32_t column = 0; column < 2 * across; ++column) {
            // The frequency 0 comes first.
            const std::uint32_t j = (row + across) % (2 * across), i = (column + across) % (2 * across);
            pattern[std::size_t{j} * 2 * across + i] +=
                factor * std::norm(data.get()[std::size_t{row} * size + column]);
        }
    }
}

std::vector<std::vector<float>> NearSpectrum::levels(double below, double number, double above) const {
    const std::uint32_t across = samples_.across, size = 2 * across;
    std::vector<float> pattern(std::size_t{size} * size, 0.0F);
    // Light from the rim and from the middle turn against each other by half the Fresnel number. Where a step
    // is too short to matter the pattern in its middle will do; two points have the hat's second moment.
    constexpr double kShort = 0.15, kSecondMoment = 0.408;
    const double finest = kShort + 0.02 * number;
    if (std::max(number - below, above - number) <= kShort) {
        addPattern(number, 1.0, 1.0, pattern);
    } else {
        for (const double end : {below, above}) {
            const double range = std::abs(end - number), count = std::ceil(range / finest);
            for (double i = 0.5; i < count; i += 1.0) {
                const double past = i / count,
                             at = number + (count > 1.0 ? past : kSecondMoment) * (end - number);
                addPattern(at, (at + stretch_) / (number + stretch_),
                           2.0 * (1.0 - past) / count * range / (above - below), pattern);
            }
        }
    }

    const std::size_t half = across + 1;
    const ComplexData lags = complexData(size * half);
    const RealData real(fftwf_alloc_real(pattern.size()));
    std::copy(pattern.begin(), pattern.end(), real.get());
    fftwf_execute_dft_r2c(plans_->lags.get(), real.get(), raw(lags));

    std::vector<std::vector<float>> levels;
    for (std::uint32_t points = points_; points > 1; points /= 2) {
        const ComplexData table = complexData(std::size_t{points} * (points / 2 + 1));
        const std::uint32_t count = std::min(across, points / 2);
        std::vector<float> weights = lagWeights(count, points, levels.empty() ? 0.0 : 1.0 / points);
        for (std::uint32_t lag = 0; levels.empty() && lag < count; ++lag)
            weights[lag] *= static_cast<float>(sampled(lag, points));
        const auto scale = 1.0F / (float(size) * float(size));
        for (std::uint32_t j = 0; j < 2 * count - 1; ++j) {
            const bool isUp = j >= count;
            const std::uint32_t lagY = isUp ? 2 * count - 1 - j : j;
            for (std::uint32_t lagX = 0; lagX < count; ++lagX) {
                table.get()[std::size_t{isUp ? points - lagY : lagY} * (points / 2 + 1) + lagX] =
                    scale * weights[lagX] * weights[lagY] *
                    lags.get()[(isUp ? size - lagY : lagY) * half + lagX];
            }
        }
        std::vector<float> values(std::size_t{points} * points);
        const RealData result(fftwf_alloc_real(values.size()));
        fftwf_execute_dft_c2r(plans_->tables[levels.size()].get(), raw(table), result.get());
        std::copy_n(result.get(), values.size(), values.begin());
        levels.push_back(std::move(values));
    }
    return levels;
}

}  // namespace fringe::optics
