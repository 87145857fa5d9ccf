// The sum of waves that have gone ways of different lengths, for any wavelength.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

namespace fringe::oracle {

// Ways are put into bins a sixteenth of the shortest wavelength wide, of which each keeps moments of what
// lies in it: the length of a way is looked at once, whatever the number of wavelengths. Taylor's series of a
// wave about a bin's middle, cut after the fourth power, is within (pi/16)^5/120 = 2.4e-6.
class Ways {
public:
    explicit Ways(double shortestWavelength);

    void add(double length, double weight);

    // Sum of weight exp(2 pi i length / wavelength), for wavelengths that are no shorter.
    std::complex<double> wave(double wavelength) const;

private:
    static constexpr std::size_t kMoments = 5;
    using Moments = std::array<double, kMoments>;

    double step_;
    std::int64_t first_ = 0;  // bin of moments_[0], whose middle is a way of first_ * step_
    std::vector<Moments> moments_;
};

}  // namespace fringe::oracle
