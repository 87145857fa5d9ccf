// Light behind long slits: the waves of all slits added up, each with its own way (docs/theory.md). Scalar
// theory with the radiance-invariant obliquity factor (J. Harvey, C. Vernold, A. Krywonos, P. Thompson,
// "Diffracted radiance", Applied Optics 38, 1999); a single slit is far from the point, the row of slits and
// the beam along them need not be.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "optics/aperture.hpp"
#include "oracle/section.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

class SlitWave {
public:
    SlitWave(const scene::Grating& grating, const optics::Slits& slits);

    // What does not depend on the wavelength for a surface at `offset` from the grating's middle (z > 0) with
    // the unit normal `normal`, in light that comes with the direction cosines `incident`.
    struct View {
        struct Slit {
            double way;     // metres, along the slit's shortest way
            double u;       // change of the direction cosine across the slits
            double weight;  // amplitude for an even section of 1 m, per metre of a slit's width
            double half;    // half of what is lit of the slit
            Travel travel;
        };
        std::vector<Slit> slits;
        double alphaIn;
        double betaIn;
    };
    View view(const glm::dvec3& offset, const glm::dvec3& normal, const glm::dvec2& incident) const;

    // W/m^2 for one watt of the beam at this wavelength, as if all of it propagated.
    double irradiance(const View& view, double wavelength) const;

    // Share of what passes the slits that propagates, for light with direction cosines `incident`; 1 where
    // the orders' efficiencies are given.
    double propagatingShare(double wavelength, const glm::dvec2& incident) const;

    // Steps of the wavelength at which the share is known well enough: it jumps where an order passes off.
    static double shareStep_nm() { return 1.0; }

    // Difference between the longest and the shortest way, metres.
    static double spread(const View& view);

    // Where along the slits the light comes from that reaches `offset`.
    glm::dvec3 source(const glm::dvec3& offset, const glm::dvec2& incident) const;

    // The part that is lit.
    glm::dvec2 extent() const;

private:
    double fromAmplitudeSlits(const View& view, double wavelength) const;
    double fromOrders(const View& view, double wavelength) const;
    std::complex<double> section(const View::Slit& slit, double wavelength) const;
    std::vector<std::complex<double>> waves(const View& view, double wavelength) const;

    struct Lit {
        double x;
        double half;       // of the beam along the slit
        double amplitude;  // over that at the middle
    };

    optics::Slits slits_;
    scene::Beam beam_;
    std::vector<scene::OrderEfficiency> efficiencies_;
    std::vector<Lit> lit_;
    double irradiance_;  // on the grating at the beam's middle; scaled to a stated efficiency
};

}  // namespace fringe::oracle
