#include "image/tone_curve.hpp"

#include <algorithm>

namespace fringe::image {
namespace {

constexpr double kReinhardWhite = 16.0;

double filmic(double luminance) {
    return luminance * (2.51 * luminance + 0.03) / (luminance * (2.43 * luminance + 0.59) + 0.14);
}

}  // namespace

double toned(ToneCurve curve, double luminance) {
    constexpr double kWhite = 1e6;  // beyond, the formula would divide infinities
    switch (curve) {
        case ToneCurve::linear:
            return luminance;
        case ToneCurve::reinhard:
            if (luminance >= kReinhardWhite) return 1.0;
            return luminance * (1.0 + luminance / (kReinhardWhite * kReinhardWhite)) / (1.0 + luminance);
        case ToneCurve::filmic:
            return luminance >= kWhite ? 1.0 : std::min(filmic(luminance), 1.0);
    }
    return luminance;
}

}  // namespace fringe::image
