// The colour of slits per unit of u, the change of direction cosine across them, by brute force: the patterns
// of all wavelengths added up in double precision, without tables. What the device's evaluators are judged
// by.
#pragma once

#include <functional>
#include <vector>

#include "oracle/spectral.hpp"

namespace fringe::oracle {

struct SlitLight {
    double count;
    double width_um;
    double period_um;
    optics::Spectrum spectrum;
    std::function<double(double wavelength_nm)> propagatingShare;  // of what leaves, that is not evanescent
    double undeviatedUpTo = 0.0;  // |u| below which the term sinc^2(count period u/wavelength) is left out
};

class SlitColor {
public:
    explicit SlitColor(SlitLight light);

    // CIE XYZ per unit of u of one watt that leaves, as the mean over a window of u.
    Xyz mean(double u, double width) const;

    // Whether that is the value in the middle: one point instead of a dozen and more.
    bool isNarrow(double width) const;

private:
    struct Line {
        double wavelength_um;
        Xyz color;
    };

    Xyz at(double u) const;
    double finestIn(double width) const;
    double featuresIn(double width) const;
    std::vector<double> pieces(double from, double to) const;
    double density(double u, double wavelength_um) const;
    Xyz weight(double wavelength_nm) const;

    SlitLight light_;
    std::vector<Xyz> weights_;  // of the continuous spectrum, per nanometre
    std::vector<Line> lines_;
};

}  // namespace fringe::oracle
