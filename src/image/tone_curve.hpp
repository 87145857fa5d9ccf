// Tone curves: how luminances become those of a display, so that what is brighter than its white is not all
// white.
#pragma once

#include <array>
#include <string_view>

namespace fringe::image {

enum class ToneCurve {
    linear,    // as they are; white from 1 on
    reinhard,  // L (1 + L / w^2) / (1 + L), white at w = 16, four stops above that of linear (E. Reinhard et
               // al., "Photographic tone reproduction for digital images", SIGGRAPH 2002, equation 4)
    filmic,    // with a toe and a shoulder as film has them, white at 7.2 (K. Narkowicz, "ACES filmic tone
               // mapping curve", 2016)
};

// The name that options go by.
struct NamedToneCurve {
    std::string_view name;
    ToneCurve curve;
};
inline constexpr std::array kToneCurves{NamedToneCurve{"linear", ToneCurve::linear},
                                        NamedToneCurve{"reinhard", ToneCurve::reinhard},
                                        NamedToneCurve{"filmic", ToneCurve::filmic}};

// 0 to 0, ascending, and but for linear at most 1. Precondition: luminance >= 0, which may be infinite.
double toned(ToneCurve curve, double luminance);

}  // namespace fringe::image
