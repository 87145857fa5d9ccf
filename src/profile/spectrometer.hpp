// A grating as a spectrometer: from a place on a surface to the wavelength that it sends there, exactly, by
// the conical grating equation in direction cosines (J. E. Harvey and C. L. Vernold, "Description of
// diffraction grating behavior in direction cosine space", Applied Optics 37, 8158, 1998): alpha_out =
// alpha_in + m wavelength/period, beta_out = beta_in.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "profile/maxima.hpp"
#include "profile/surface.hpp"

namespace fringe::profile {

// Slits of a scene, as seen from places that their light reaches. Lengths in metres, wavelengths in
// nanometres.
class Spectrometer {
public:
    // Throws LineError where the light is no grating of several slits.
    explicit Spectrometer(const scene::Light& light);

    // Whether light of the grating can go there: in front of it.
    bool reaches(dvec3 point) const;

    // Change of the direction cosine across the slits on the way to a point: order m of a wavelength is at
    // m wavelength/period. Precondition: reaches(point).
    double sine(dvec3 point) const;

    double wavelength_nm(double sine, int order) const { return sine * period_ / order * 1e9; }

    // The order in which light of about this wavelength has this sine.
    int order(double sine, double wavelength_nm) const;

    // Extent in sines of the image that one wavelength makes there: of the wave (wavelength over the lit
    // width), and of the beam's footprint, which vanishes where the beam is focused.
    double diffraction(double wavelength_nm) const { return wavelength_nm * 1e-9 / litWidth_; }
    double footprint(dvec3 point) const;

    // How steep the pattern of one slit is there: d ln(sinc^2(width sine/wavelength))/d sine.
    double envelopeSlope(double sine, double wavelength_nm) const;

    // Distance of the focus that brings the beam together at a point, for Beam::focus.
    double focusFor(dvec3 point) const;

    double litSlits() const { return litWidth_ / period_; }
    double distance(dvec3 point) const;
    const optics::Spectrum& spectrum() const { return spectrum_; }

private:
    struct Offset {
        double x, y, z;  // across, along, normal
    };
    Offset offset(dvec3 point) const;
    double curvature(dvec3 point) const;

    dvec3 position_, across_, along_, normal_;
    double alphaIn_, conical_;  // of the beam: its direction cosine across the slits; sqrt(1 - betaIn^2)
    double period_, slitWidth_, litWidth_;
    double convergence_;  // 1 / distance of the focus; 0 for a parallel beam
    optics::Spectrum spectrum_;
};

// The profile as it was sampled: place, irradiance and mean wavelength of each sample.
struct Samples {
    std::vector<dvec3> points;
    std::vector<double> irradiance;         // W/m^2
    std::vector<double> meanWavelength_nm;  // 0 in the dark
    double step;                            // metres
};

// Wavelengths of the source that one maximum holds.
struct Blend {
    std::vector<double> lines_nm;
    double slitsNeeded;  // lit slits that would tell the closest two apart
    std::optional<double>
        focus;  // metres, for Beam::focus; set where the beam's footprint is what hides them
};

struct Reading {
    int order;
    double wavelength_nm;  // of the middle of the maximum
    // One standard deviation: a sample's share of the line, skewness, the beam's footprint, and how far the
    // pattern of a single slit pulls.
    double uncertainty_nm;
    double width_nm;  // full width of the maximum
    std::optional<Blend> blend;
};

struct SpectralMaximum {
    Maximum maximum;
    std::optional<Reading> reading;  // none in the zero order, and without a grating
};

// What counts as a maximum at each sample: 0.5 % of the highest irradiance in its order, and as far from a
// higher one as one wavelength's image is wide.
std::vector<Threshold> thresholdsFor(const Samples& samples, const Spectrometer* spectrometer);

// The maxima, and what each means if the light came from the spectrometer. Weak ones whose light is of
// another wavelength than their place says are remote side lobes, and left out.
std::vector<SpectralMaximum> readMaxima(const Samples& samples, const Spectrometer* spectrometer);

}  // namespace fringe::profile
