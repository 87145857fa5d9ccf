// What a path brings back: colour, or the news that a formula taken as printed was 0/0.
#pragma once

#include "oracle/spectral.hpp"

namespace fringe::oracle {

struct Value {
    Xyz xyz{0.0};            // without the part that was not finite
    bool nonFinite = false;  // once set it stays: NaN times any throughput is NaN

    Value& operator+=(const Value& other) {
        xyz += other.xyz;
        nonFinite = nonFinite || other.nonFinite;
        return *this;
    }
};

}  // namespace fringe::oracle
