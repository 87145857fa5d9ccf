#include "image/compare.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

namespace fringe::image {

namespace {

std::string sizeOf(const Picture& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

double distance(double a, double b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0.0;  // infinities have no difference of their own
    const double difference = std::abs(a - b);
    return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

}  // namespace

Difference compare(const Picture& a, const Picture& b, double tolerance) {
    assert(tolerance >= 0.0);
    if (a.width != b.width || a.height != b.height)
        throw MismatchError("the pictures have " + sizeOf(a) + " and " + sizeOf(b) +
                            " pixels; they must be of one size");

    if (a.quantity != b.quantity)
        throw MismatchError(std::string("one picture shows ") + nameOf(a.quantity) + ", the other " +
                            nameOf(b.quantity));

    Difference result;
    result.quantity = a.quantity;
    result.channels.resize(a.quantity == Quantity::color ? 3 : 1);
    const std::size_t channelCount = result.channels.size();
    std::array<double, 3> squares{};
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const RgbPixel &p = a.pixels[i], &q = b.pixels[i];
        const std::array distances = {distance(p.r, q.r), distance(p.g, q.g), distance(p.b, q.b)};
        for (std::size_t c = 0; c < channelCount; ++c) {
            result.channels[c].maxAbs = std::max(result.channels[c].maxAbs, distances[c]);
            squares[c] += distances[c] * distances[c];
        }

        const double largest = *std::max_element(distances.begin(), distances.end());
        if (largest > result.overall.maxAbs) {
            result.overall.maxAbs = largest;
            result.maxX = static_cast<std::uint32_t>(i % a.width);
            result.maxY = static_cast<std::uint32_t>(i / a.width);
        }
        result.nonFiniteMismatches += p.nonFinite != q.nonFinite ? 1 : 0;
        result.beyond += largest > tolerance || p.nonFinite != q.nonFinite ? 1 : 0;
    }

    const auto pixelCount = static_cast<double>(a.pixels.size());
    for (std::size_t c = 0; c < channelCount; ++c)
        result.channels[c].rmse = std::sqrt(squares[c] / pixelCount);
    result.overall.rmse =
        std::sqrt((squares[0] + squares[1] + squares[2]) / (static_cast<double>(channelCount) * pixelCount));
    result.psnr = -20.0 * std::log10(result.overall.rmse);  // infinite for equal pictures
    result.beyondFraction = static_cast<double>(result.beyond) / pixelCount;
    return result;
}

}  // namespace fringe::image
