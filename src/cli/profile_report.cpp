#include "cli/profile_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace fringe::cli {
namespace {

constexpr double kMillimetres = 1e3;

double largest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

Json::Value pointJson(glm::dvec3 p) {
    Json::Value json(Json::arrayValue);
    for (int i = 0; i < 3; ++i) json.append(p[i]);
    return json;
}

std::string blendText(const ProfileReport& report, std::size_t number, const profile::Reading& reading) {
    const profile::Blend& blend = *reading.blend;
    std::string text =
        fmt::format("unresolved: maximum {} holds {:.2f} nm; ", number, fmt::join(blend.lines_nm, ", "));
    if (blend.focus) {
        return text +
               fmt::format("the beam's footprint covers them, a beam.focus of {} would bring it together",
                           profile::lengthText(*blend.focus));
    }
    return text + fmt::format("order {} tells them apart from {:.0f} lit slits on, {:.0f} are lit",
                              reading.order, std::ceil(blend.slitsNeeded), report.spectrometer->litSlits());
}

}  // namespace

Json::Value toJson(const ProfileReport& report) {
    Json::Value json;
    json["scene"] = report.scene;
    json["device"] = report.device;
    json["surface"] = report.surface;
    json["from"] = pointJson(report.line.from);
    json["to"] = pointJson(report.line.to);
    json["samples"] = Json::UInt64{report.samples.points.size()};
    json["step_m"] = report.samples.step;
    json["irradiance_W_m2"]["mean"] = mean(report.samples.irradiance);
    json["irradiance_W_m2"]["largest"] = largest(report.samples.irradiance);
    if (report.spectrometer) {
        Json::Value& grating = json["grating"];
        grating["name"] = report.grating;
        grating["lit_slits"] = report.spectrometer->litSlits();
    }
    json["maxima"] = Json::arrayValue;
    for (const profile::SpectralMaximum& maximum : report.maxima) {
        Json::Value entry;
        entry["position_m"] = report.position(maximum.maximum.place);
        entry["irradiance_W_m2"] = maximum.maximum.value;
        entry["width_m"] = maximum.maximum.width * report.samples.step;
        if (const auto& reading = maximum.reading) {
            entry["order"] = reading->order;
            entry["wavelength_nm"] = reading->wavelength_nm;
            entry["uncertainty_nm"] = reading->uncertainty_nm;
            entry["width_nm"] = reading->width_nm;
            if (reading->blend) {
                for (const double line_nm : reading->blend->lines_nm) entry["unresolved_nm"].append(line_nm);
                entry["slits_needed"] = std::ceil(reading->blend->slitsNeeded);
                if (reading->blend->focus) entry["focus_needed_m"] = *reading->blend->focus;
            }
        }
        json["maxima"].append(entry);
    }
    json["notes"] = Json::arrayValue;
    for (const std::string& note : report.notes) json["notes"].append(note);
    json["outputs"] = Json::arrayValue;
    for (const std::string& path : report.outputs) json["outputs"].append(path);
    return json;
}

void print(const ProfileReport& report) {
    fmt::print("line        {} on {}, {} samples {} apart\n", profile::lengthText(report.line.length()),
               report.surface, report.samples.points.size(), profile::lengthText(report.samples.step));
    fmt::print("irradiance  mean {:.4g} W/m^2, largest {:.4g} W/m^2\n", mean(report.samples.irradiance),
               largest(report.samples.irradiance));
    if (report.spectrometer) {
        fmt::print("grating     {}, {:.6g} slits lit, {} away\n", report.grating,
                   report.spectrometer->litSlits(),
                   profile::lengthText(report.spectrometer->distance(report.line.at(0.5))));
    }
    if (report.maxima.empty()) fmt::print("maxima      none\n");
    else fmt::print("maxima        position    irradiance      width   order   wavelength\n");
    for (std::size_t i = 0; i < report.maxima.size(); ++i) {
        const profile::Maximum& maximum = report.maxima[i].maximum;
        std::string text = fmt::format("{:>10}  {:>8.4f} mm  {:>8.4g} W/m^2 {:>8.4g} mm", i + 1,
                                       report.position(maximum.place) * kMillimetres, maximum.value,
                                       maximum.width * report.samples.step * kMillimetres);
        if (const auto& reading = report.maxima[i].reading) {
            text += fmt::format("  {:+5d}   {}{}", reading->order, wavelengthText(*reading),
                                reading->blend ? ", unresolved" : "");
        } else if (report.spectrometer) {
            text += "      0";
        }
        fmt::print("{}\n", text);
    }
    for (std::size_t i = 0; i < report.maxima.size(); ++i) {
        const auto& reading = report.maxima[i].reading;
        if (reading && reading->blend) fmt::print("{}\n", blendText(report, i + 1, *reading));
    }
    for (const std::string& note : report.notes) fmt::print("note: {}\n", note);
    if (!report.outputs.empty()) fmt::print("written     {}\n", fmt::join(report.outputs, ", "));
}

}  // namespace fringe::cli
