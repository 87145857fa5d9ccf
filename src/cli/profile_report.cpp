#include "cli/profile_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "compile/spectral.hpp"
#include "image/develop.hpp"
#include "image/exposure_meter.hpp"
#include "optics/color.hpp"

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

// Three significant decimals of a length: 12.34 um, 5.6 mm, 1.09 m.
std::string lengthText(double metres) {
    if (metres < 1e-3) return fmt::format("{:.4g} um", metres * 1e6);
    if (metres < 1.0) return fmt::format("{:.4g} mm", metres * kMillimetres);
    return fmt::format("{:.4g} m", metres);
}

// As many decimals as the uncertainty has meaning for.
int decimalsOf(const profile::Reading& reading) {
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(reading.uncertainty_nm))), 0, 4);
}

std::string wavelengthText(const profile::Reading& reading) {
    const int decimals = decimalsOf(reading);
    return fmt::format("{:.{}f} +- {:.{}f} nm", reading.wavelength_nm, decimals, reading.uncertainty_nm,
                       decimals);
}

std::string blendText(const ProfileReport& report, std::size_t number, const profile::Reading& reading) {
    const profile::Blend& blend = *reading.blend;
    std::string text =
        fmt::format("unresolved: maximum {} holds {:.2f} nm; ", number, fmt::join(blend.lines_nm, ", "));
    if (blend.focus) {
        return text +
               fmt::format("the beam's footprint covers them, a beam.focus of {} would bring it together",
                           lengthText(*blend.focus));
    }
    return text + fmt::format("order {} tells them apart from {:.0f} lit slits on, {:.0f} are lit",
                              reading.order, std::ceil(blend.slitsNeeded), report.spectrometer->litSlits());
}

std::string markText(const ProfileReport& report, const profile::SpectralMaximum& maximum) {
    if (!maximum.reading && report.spectrometer) return "order 0";
    if (!maximum.reading)
        return fmt::format("{:.4g} mm", report.position(maximum.maximum.place) * kMillimetres);
    const profile::Reading& reading = *maximum.reading;
    return fmt::format("{:.{}f} nm{} ({:+d})", reading.wavelength_nm, decimalsOf(reading),
                       reading.blend ? "*" : "", reading.order);
}

// The light of some samples on a white surface, by the middles of its bands.
image::Pixel colorOf(const ProfileReport& report, std::size_t first, std::size_t last) {
    glm::dvec3 xyz(0.0);
    for (std::size_t i = first; i < last; ++i) {
        for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band)
            xyz += report.bands[i][band] * optics::colorMatching(compile::bandMiddle_nm(band));
    }
    xyz *= 1.0 / static_cast<double>(last - first);
    return {static_cast<float>(xyz.x), static_cast<float>(xyz.y), static_cast<float>(xyz.z), false};
}

// The colours along the line, exposed as a picture of it would be.
std::vector<plot::Color> stripOf(const ProfileReport& report) {
    const std::size_t count = report.bands.size();
    const std::size_t columns = std::min(count, plot::kStripColumns);
    std::vector<image::Pixel> pixels;
    for (std::size_t column = 0; column < columns; ++column)
        pixels.push_back(colorOf(report, column * count / columns, (column + 1) * count / columns));
    image::Development development;
    image::ExposureMeter meter(development);
    meter.add(pixels);
    development.exposure = meter.exposure();
    std::vector<std::uint8_t> rgb(3 * columns);
    image::develop8(development, pixels, rgb);
    std::vector<plot::Color> strip;
    for (std::size_t i = 0; i < columns; ++i) strip.push_back({rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]});
    return strip;
}

// Nanometres that a band stands for: the integral of its hat, which reaches to the ends of the visible range
// in the first band and the last.
double bandWidth_nm(device::uint band) {
    const double middle_nm = compile::bandMiddle_nm(band);
    const double below_nm = band == 0 ? middle_nm - optics::kShortestVisible_nm
                                      : 0.5 * (middle_nm - compile::bandMiddle_nm(band - 1));
    const double above_nm = band + 1 == device::SPECTRAL_BANDS
                                ? optics::kLongestVisible_nm - middle_nm
                                : 0.5 * (compile::bandMiddle_nm(band + 1) - middle_nm);
    return below_nm + above_nm;
}

}  // namespace

std::string csvText(const ProfileReport& report) {
    std::string text = fmt::format("# {}: {} samples on {}, {:.6g} m apart\n", report.scene,
                                   report.samples.points.size(), report.surface, report.samples.step);
    text +=
        "# E_...nm: spectral irradiance in W/m^2/nm, mean over a band that reaches halfway to the next ones; "
        "the first from "
        "380 nm on, the last to 780 nm\n";
    text += "position_m,x_m,y_m,z_m,irradiance_W_m2,mean_wavelength_nm";
    for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band)
        text += fmt::format(",E_{:g}nm", compile::bandMiddle_nm(band));
    text += '\n';
    for (std::size_t i = 0; i < report.samples.points.size(); ++i) {
        const glm::dvec3 p = report.samples.points[i];
        text +=
            fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.7g},{:.7g}", report.position(static_cast<double>(i)),
                        p.x, p.y, p.z, report.samples.irradiance[i], report.samples.meanWavelength_nm[i]);
        for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band)
            text += fmt::format(",{:.7g}", report.bands[i][band] / bandWidth_nm(band));
        text += '\n';
    }
    return text;
}

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
    fmt::print("line        {} on {}, {} samples {} apart\n", lengthText(report.line.length()),
               report.surface, report.samples.points.size(), lengthText(report.samples.step));
    fmt::print("irradiance  mean {:.4g} W/m^2, largest {:.4g} W/m^2\n", mean(report.samples.irradiance),
               largest(report.samples.irradiance));
    if (report.spectrometer) {
        fmt::print("grating     {}, {:.6g} slits lit, {} away\n", report.grating,
                   report.spectrometer->litSlits(),
                   lengthText(report.spectrometer->distance(report.line.at(0.5))));
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

plot::Chart chartOf(const ProfileReport& report) {
    plot::Chart chart;
    chart.title =
        fmt::format("{}: irradiance along {} of {}", std::filesystem::path(report.scene).filename().string(),
                    lengthText(report.line.length()), report.surface);
    if (report.spectrometer) {
        chart.subtitle = fmt::format(
            "marks: wavelength and order by \"{}\", {:.6g} slits lit; * holds several lines of the source. "
            "Strip: the "
            "colours on a white surface",
            report.grating, report.spectrometer->litSlits());
    } else {
        chart.subtitle = "strip: the colours on a white surface";
    }
    chart.xLabel = "position on the line, mm";
    chart.yLabel = "irradiance, W/m\u00b2";
    for (std::size_t i = 0; i < report.samples.points.size(); ++i) {
        chart.x.push_back(report.position(static_cast<double>(i)) * kMillimetres);
        chart.y.push_back(report.samples.irradiance[i]);
    }
    for (const profile::SpectralMaximum& maximum : report.maxima) {
        const double position = report.position(maximum.maximum.place);
        chart.marks.push_back({position * kMillimetres, maximum.maximum.value, markText(report, maximum)});
    }
    chart.strip = stripOf(report);
    return chart;
}

}  // namespace fringe::cli
