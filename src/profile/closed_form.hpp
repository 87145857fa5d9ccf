// What the textbook says of the light of gratings and apertures on a surface, to be laid over a measured
// profile: closed forms of the far field (src/optics), in double precision on the host. Shares no code with
// the shaders and no table with src/compile.
//
// Taken as given: nothing is in the way, every slit is lit alike and as long as the beam is high. What is not
// in the far field is the beam itself: along slits its edges have Fresnel's ripple, and across many slits the
// pattern is the mean over the directions in which they are seen.
#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "profile/surface.hpp"

namespace fringe::profile {

// Of one grating or aperture.
class ClosedForm {
public:
    // Nothing where there is none: for lights of another kind, and for masks.
    static std::optional<ClosedForm> of(const scene::Light& light);

    // W/m^2 at a point of a surface with this unit normal. Of slits the mean over the points within
    // +-`reach`.
    double irradiance(dvec3 point, dvec3 normal, dvec3 reach) const;

private:
    // A wavelength, the watts that it stands for, and the range of wavelengths, 0 for a line.
    struct Node {
        double wavelength;  // metres
        double power;
        double cell;   // metres
        double scale;  // of the pattern, so that all the power arrives
    };
    struct Offset {
        double x, y, z;  // across, along, normal
    };

    // How slits are seen from a place.
    struct View {
        double sine;       // change of the direction cosine across them
        double halfWidth;  // of the range of sines that is averaged over
        double curvature;  // 1/metres, of the wave across them; 0 in the focus
        double along;      // metres along them, from where the beam's axis lands
        double distance;   // metres
    };

    explicit ClosedForm(const scene::Grating& grating);

    Offset offset(dvec3 point) const;
    double slitIrradiance(const optics::Slits& slits, dvec3 point, dvec3 normal, dvec3 reach) const;
    double openingIrradiance(dvec3 point, dvec3 normal) const;
    double sine(const Offset& o) const;
    double slitPattern(const optics::Slits& slits, const Node& node, const View& view) const;
    double disc(const Node& node, double slope, double halfLit, const View& view) const;
    double chord(const Node& node, double slope, double halfLit, const View& view) const;
    double beamAlongSlits(const Node& node, const View& view, double half) const;

    scene::Grating grating_;
    dvec3 across_;
    double alphaIn_, betaIn_;
    double conical_;        // sqrt(1 - betaIn^2)
    double convergence_;    // 1/metres: of the beam, where a lens focuses it
    double count_;          // of slits that are lit
    bool isRound_ = false;  // they fill a good part of an even, round beam
    std::vector<Node> nodes_;
};

// Of all gratings and apertures of a scene together.
struct ClosedFormProfile {
    std::vector<double> irradiance;  // W/m^2, of each sample
    std::size_t gratings;            // how many were added
    std::size_t masks;               // how many have no closed form and were left out
};

// At points of the line, evenly apart. Nothing if no light has a closed form, or when cancelled.
std::optional<ClosedFormProfile> closedFormAlong(const scene::Scene& scene, const SurfaceLine& line,
                                                 std::span<const dvec3> points,
                                                 const std::atomic<bool>& cancelled);

}  // namespace fringe::profile
