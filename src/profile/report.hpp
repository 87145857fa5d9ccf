// What a profile found, whole: what was measured, what its maxima are, and as CSV and a chart.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compile/interface.hpp"
#include "image/image.hpp"
#include "plot/chart.hpp"
#include "profile/closed_form.hpp"
#include "profile/spectrometer.hpp"

namespace fringe::profile {

struct Report {
    std::string scene;    // the file
    std::string surface;  // name of the object under the line
    SurfaceLine line;
    Samples samples;
    std::vector<std::array<double, device::SPECTRAL_BANDS>> bands;  // W/m^2, of each sample
    std::optional<Spectrometer> spectrometer;
    std::string grating;  // its name
    std::vector<SpectralMaximum> maxima;
    std::optional<ClosedFormProfile> closedForm;  // for comparison

    // Metres from the line's beginning.
    double position(double place) const { return (place + 0.5) * samples.step; }
};

// The lights that can be spectrometers: gratings of two slits or more.
std::vector<const scene::Light*> spectrometersOf(const scene::Scene& scene);

// A profile of `count` samples along the line, before anything is measured, with `light` as its spectrometer
// (null: none).
Report reportOn(const scene::Scene& scene, const std::string& file, const SurfaceLine& line,
                const scene::Light* light, std::uint32_t count);

// Takes the picture of lineScene (Measure::spectrum), a band in each row, and reads the maxima.
void takePicture(std::span<const image::Pixel> pixels, Report& report);

// Nanometres that a band stands for: the integral of its hat, which reaches to the ends of the visible range
// in the first band and the last.
double bandWidth_nm(device::uint band);

// Three significant decimals of a length: 12.34 um, 5.6 mm, 1.09 m.
std::string lengthText(double metres);

// As many decimals as the uncertainty has meaning for.
int decimalsOf(const Reading& reading);

// "589.59 +- 0.02 nm".
std::string wavelengthText(const Reading& reading);

// What the curve of closed forms is.
std::string closedFormText(const ClosedFormProfile& form);

// Of a sample, in lux: its bands by the luminous efficiency at their middles. 0.3 % too much in daylight; of
// a single line within 0.3 % from 480 to 600 nm, 2 % too much at 632.8 nm and 9 % at 670 nm; light beyond 700
// nm counts as if it were there.
double illuminance_lx(const Report& report, std::size_t sample);

std::string csvText(const Report& report);

// Along the line; of a single sample, its spectrum.
plot::Chart chartOf(const Report& report);

// Whether a report can be written to a file of this name: .csv, or a chart's.
bool isReportFile(const std::filesystem::path& path);

// The file appears whole or not at all. Throws image::FileError. Precondition: isReportFile(path).
void writeReport(const std::filesystem::path& path, const Report& report);

}  // namespace fringe::profile
