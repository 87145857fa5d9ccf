#include "image/exposure_meter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace fringe::image {

namespace {

// Positive floats ordered by their leading bits: exponent and 7 bits of mantissa.
constexpr unsigned kShift = 16;
constexpr std::size_t kBinsPerOctave = 128;

std::size_t binOf(float value) {
    return std::bit_cast<std::uint32_t>(value) >> kShift;
}

double middleOf(std::size_t bin) {
    return std::bit_cast<float>((static_cast<std::uint32_t>(bin) << kShift) | (1U << (kShift - 1)));
}

constexpr std::size_t kDarkStops = 10;
constexpr double kPercentile = 0.99;
constexpr double kHeadroom = 0.5;  // stops

Development withoutExposure(Development development) {
    development.exposure = 0.0;
    return development;
}

}  // namespace

ExposureMeter::ExposureMeter(const Development& development)
    : displayed_(withoutExposure(development)), counts_(binOf(std::numeric_limits<float>::infinity())) {}

void ExposureMeter::add(std::span<const Pixel> pixels) {
    constexpr double least = std::numeric_limits<float>::min(), most = std::numeric_limits<float>::max();
    for (const Pixel& pixel : pixels) {
        if (pixel.nonFinite) continue;
        const glm::dvec3 rgb = withoutNegative(displayed_(pixel));
        const double value = std::max({rgb.x, rgb.y, rgb.z});
        if (value >= least) ++counts_[binOf(static_cast<float>(std::min(value, most)))];
    }
}

double ExposureMeter::exposure() const {
    const auto brightest =
        std::find_if(counts_.rbegin(), counts_.rend(), [](auto count) { return count > 0; });
    if (brightest == counts_.rend()) return 0.0;
    const auto end = brightest.base();
    const auto first = end - std::min<std::ptrdiff_t>(end - counts_.begin(), kDarkStops * kBinsPerOctave);
    const auto lit = static_cast<double>(std::accumulate(first, end, std::uint64_t{0}));

    auto at = first;
    for (auto below = static_cast<double>(*at); below < kPercentile * lit;)
        below += static_cast<double>(*++at);
    const double white = middleOf(static_cast<std::size_t>(at - counts_.begin()));
    return std::round(100.0 * (-kHeadroom - std::log2(white))) / 100.0;
}

}  // namespace fringe::image
