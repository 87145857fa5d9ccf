// The spectra and reflectances of a scene, and the tables of colours that the device gets for them: every
// light's spectrum times every surface's reflectance, integrated against the colour-matching functions in
// double precision, so that no colour is ever a product of two colours.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "compile/interface.hpp"
#include "optics/spectrum.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

// What the film is to hold: CIE XYZ; or, three times over, radiance in W/(m^2 sr); or the irradiance in W/m^2
// of the diffuse surface that a pixel shows; or that irradiance on the line through the middle of a
// picture one row high, in SPECTRAL_BANDS rows, a band of wavelengths in each (bandShare).
enum class Measure { color, radiance, irradiance, spectrum };

// One wavelength with the power it stands for.
struct SpectralSample {
    double wavelength_nm;
    double power;
};

// The continuous part in steps of `step_nm` over the visible range (trapezoidal weights; 400 nm / step is
// whole).
std::vector<SpectralSample> continuousSamples(const optics::Spectrum& spectrum, double step_nm);

// The lines, each without width by one sample, others by seven across their Gaussian. Outside the visible
// range: none.
std::vector<SpectralSample> lineSamples(const optics::Spectrum& spectrum);

// The middle of a spectral band (shaders/interface.h, SPECTRAL_BANDS).
double bandMiddle_nm(device::uint band);

// A wavelength's light belongs to two bands next to each other: `upper` of it to `band + 1`, the rest to
// `band`.
struct BandShare {
    device::uint band;
    double upper;  // 0..1
};
BandShare bandShare(double wavelength_nm);

// The tables that slits have for one continuous spectrum.
struct ResponseRows {
    std::size_t reflectances = 1;
    bool inBands = false;  // for each band too, not for their sum alone

    std::size_t perReflectance() const { return inBands ? device::SPECTRAL_BANDS + 1 : 1; }
    std::size_t all() const { return reflectances * perReflectance(); }
};

class TableMemo;

class SpectralTables {
public:
    // `bands`: 1, or SPECTRAL_BANDS where paths carry bands. `memo`: where the tables of gratings are kept
    // from one scene to the next; null: nowhere.
    SpectralTables(Measure measure, device::uint bands, TableMemo* memo = nullptr);

    // Tables of slits are needed for each band too, though paths carry none.
    void divideResponses() { bandResponses_ = true; }

    struct Reflector {
        device::uint row;
        float factor;  // grey surfaces share a row
    };

    // Rows; equal ones are shared. Reflectance row 0 is 1 everywhere.
    device::uint spectrum(const optics::Spectrum& spectrum);
    Reflector reflector(const optics::Curve& reflectance);
    device::uint metal(scene::Metal metal);

    Measure measure() const { return measure_; }
    device::uint bands() const { return bands_; }
    TableMemo* memo() const { return memo_; }
    ResponseRows responseRows() const { return {reflectances_.size(), bandResponses_}; }
    const std::vector<optics::Spectrum>& spectra() const { return spectra_; }
    const std::vector<optics::Curve>& reflectances() const { return reflectances_; }

    // What the film records of one watt at this wavelength off this reflectance.
    glm::dvec3 response(std::size_t reflectance, double wavelength_nm) const;

    // The colours of all spectra off all reflectances so far: [spectrum][reflectance][xyz] where there is one
    // band, else [spectrum][reflectance][the whole and each band][xyz].
    std::vector<float> colors() const;

    // Refractive indices of the metals so far at the bands: [metal][band][n, k].
    std::vector<float> metalIndices() const;

private:
    Measure measure_;
    device::uint bands_;
    bool bandResponses_;
    TableMemo* memo_;
    double perWatt_;  // scale of the colour-matching functions
    std::vector<optics::Spectrum> spectra_;
    std::vector<optics::Curve> reflectances_;
    std::vector<scene::Metal> metals_;
};

}  // namespace fringe::compile
