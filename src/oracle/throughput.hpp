// What mirrors and glass leave of the light on its way to the eye, wavelength by wavelength.
#pragma once

#include <functional>
#include <vector>

#include "oracle/spectral.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

// A product of factors. Those that depend on the wavelength are kept as the mirrors they come from, and
// worked out where light is summed over wavelengths.
class Throughput {
public:
    void passShare(double share) { share_ *= share; }
    void reflectFrom(scene::Metal metal, double cosine) { mirrors_.push_back({metal, cosine}); }

    // `share` of a wavelength in nanometres is left.
    void passFilter(std::function<double(double)> share) { filters_.push_back(std::move(share)); }

    bool isConstant() const { return mirrors_.empty() && filters_.empty(); }
    double constantPart() const { return share_; }
    double at(double wavelength_nm) const;

    // The largest over the visible range, as seen in steps of 10 nm.
    double brightest() const;

private:
    struct Mirror {
        scene::Metal metal;
        double cosine;  // of the angle of incidence
    };

    double share_ = 1.0;
    std::vector<Mirror> mirrors_;
    std::vector<std::function<double(double)>> filters_;
};

// What becomes of light that a surface sends on to the film: its reflectance, the way, and the film.
struct Passage {
    const optics::Curve& reflectance;
    const Throughput& throughput;
    Response response;

    Xyz at(double wavelength_nm) const {
        const double left = curveAt(reflectance, wavelength_nm);
        return left == 0.0 ? Xyz(0.0) : left * throughput.at(wavelength_nm) * response(wavelength_nm);
    }
};

}  // namespace fringe::oracle
