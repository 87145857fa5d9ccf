// Physical quantities on the host: a number that cannot lose its unit.
// Every quantity holds SI base units in double precision; `1.6 * um` makes one and `pitch / um`
// gives back a plain number. Conversion to the floats of the device happens in src/compile alone.
#pragma once

#include <compare>
#include <numbers>

namespace fringe::units {

template <class Dimension>
struct Quantity {
    double si = 0.0;

    friend constexpr auto operator<=>(const Quantity&,
                                      const Quantity&) = default;  // NOLINT(modernize-use-nullptr)
    friend constexpr Quantity operator+(Quantity a, Quantity b) { return {a.si + b.si}; }
    friend constexpr Quantity operator-(Quantity a, Quantity b) { return {a.si - b.si}; }
    friend constexpr Quantity operator*(double k, Quantity a) { return {k * a.si}; }
    friend constexpr Quantity operator/(Quantity a, double k) { return {a.si / k}; }
    friend constexpr double operator/(Quantity a, Quantity b) { return a.si / b.si; }
};

using Length = Quantity<struct LengthDimension>;            // metre
using Angle = Quantity<struct AngleDimension>;              // radian
using Power = Quantity<struct PowerDimension>;              // watt
using Irradiance = Quantity<struct IrradianceDimension>;    // watt per square metre
using Radiance = Quantity<struct RadianceDimension>;        // watt per square metre and steradian
using Temperature = Quantity<struct TemperatureDimension>;  // kelvin

inline constexpr Length m{1.0}, cm{1e-2}, mm{1e-3}, um{1e-6}, nm{1e-9};
inline constexpr Angle rad{1.0}, deg{std::numbers::pi / 180.0};
inline constexpr Power W{1.0};
inline constexpr Irradiance W_per_m2{1.0};
inline constexpr Radiance W_per_m2_sr{1.0};
inline constexpr Temperature K{1.0};

}  // namespace fringe::units
