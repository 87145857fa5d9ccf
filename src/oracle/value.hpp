// What a path brings back: radiance per channel, or the news that a formula taken as printed was 0/0.
#pragma once

#include <cmath>

#include "scene/scene.hpp"

namespace fringe::oracle {

struct Value {
    scene::Rgb rgb{0.0};     // without the part that was not finite
    bool nonFinite = false;  // once set it stays: NaN times any throughput is NaN

    Value& operator+=(const Value& other) {
        rgb += other.rgb;
        nonFinite = nonFinite || other.nonFinite;
        return *this;
    }

    friend Value operator*(const scene::Rgb& factor, const Value& value) {
        return {factor * value.rgb, value.nonFinite};
    }
};

// The value of a formula that may have been 0/0 in some channel: as in the thesis's listing, where every
// channel is added to all three (times 0 for two of them), one NaN spoils the whole.
inline Value flagged(const scene::Rgb& rgb) {
    const bool finite = std::isfinite(rgb.r) && std::isfinite(rgb.g) && std::isfinite(rgb.b);
    return finite ? Value{rgb, false} : Value{scene::Rgb(0.0), true};
}

}  // namespace fringe::oracle
