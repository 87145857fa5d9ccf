// What a profile found, as text, JSON, CSV and a chart.
#pragma once

#include <json/json.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compile/interface.hpp"
#include "plot/chart.hpp"
#include "profile/spectrometer.hpp"

namespace fringe::cli {

struct ProfileReport {
    std::string scene;  // the file
    std::string device;
    std::string surface;  // name of the object under the line
    profile::SurfaceLine line;
    profile::Samples samples;
    std::vector<std::array<double, device::SPECTRAL_BANDS>> bands;  // W/m^2, of each sample
    std::optional<profile::Spectrometer> spectrometer;
    std::string grating;  // its name
    std::vector<profile::SpectralMaximum> maxima;
    std::vector<std::string> notes;
    std::vector<std::string> outputs;  // files written

    // Metres from the line's beginning.
    double position(double place) const { return (place + 0.5) * samples.step; }
};

std::string csvText(const ProfileReport& report);
Json::Value toJson(const ProfileReport& report);
void print(const ProfileReport& report);
plot::Chart chartOf(const ProfileReport& report);

}  // namespace fringe::cli
