#include "profile/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compile/spectral.hpp"
#include "image/develop.hpp"
#include "image/exposure_meter.hpp"
#include "image/pending_file.hpp"
#include "optics/color.hpp"

namespace fringe::profile {
namespace {

constexpr double kMillimetres = 1e3;

bool isRuled(const scene::Light& light) {
    const auto* grating = std::get_if<scene::Grating>(&light.model);
    const auto* slits = grating != nullptr ? std::get_if<optics::Slits>(&grating->aperture) : nullptr;
    return slits != nullptr && slits->count > 1;
}

std::string markText(const Report& report, const SpectralMaximum& maximum) {
    if (!maximum.reading && report.spectrometer) return "order 0";
    if (!maximum.reading)
        return fmt::format("{:.4g} mm", report.position(maximum.maximum.place) * kMillimetres);
    const Reading& reading = *maximum.reading;
    return fmt::format("{:.{}f} nm{} ({:+d})", reading.wavelength_nm, decimalsOf(reading),
                       reading.blend ? "*" : "", reading.order);
}

// The light of some samples on a white surface, by the middles of its bands.
image::Pixel colorOf(const Report& report, std::size_t first, std::size_t last) {
    glm::dvec3 xyz(0.0);
    for (std::size_t i = first; i < last; ++i) {
        for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band)
            xyz += report.bands[i][band] * optics::colorMatching(compile::bandMiddle_nm(band));
    }
    xyz *= 1.0 / static_cast<double>(last - first);
    return {static_cast<float>(xyz.x), static_cast<float>(xyz.y), static_cast<float>(xyz.z), false};
}

// Exposed as a picture of them would be.
std::vector<plot::Color> stripOf(const std::vector<image::Pixel>& pixels) {
    image::Development development;
    image::ExposureMeter meter(development);
    meter.add(pixels);
    development.exposure = meter.exposure();
    std::vector<std::uint8_t> rgb(3 * pixels.size());
    image::develop8(development, pixels, rgb);
    std::vector<plot::Color> strip;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        strip.push_back({rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]});
    return strip;
}

// The colours along the line.
std::vector<plot::Color> stripOf(const Report& report) {
    const std::size_t count = report.bands.size();
    const std::size_t columns = std::min(count, plot::kStripColumns);
    std::vector<image::Pixel> pixels;
    for (std::size_t column = 0; column < columns; ++column)
        pixels.push_back(colorOf(report, column * count / columns, (column + 1) * count / columns));
    return stripOf(pixels);
}

// The spectrum of one sample, and under it its colours, as a spectrograph shows them.
plot::Chart spectrumChart(const Report& report) {
    plot::Chart chart;
    const dvec3 p = report.samples.points.front();
    chart.title =
        fmt::format("{}: spectrum at ({:.4g}, {:.4g}, {:.4g}) on {}",
                    std::filesystem::path(report.scene).filename().string(), p.x, p.y, p.z, report.surface);
    chart.subtitle = fmt::format("{:.4g} W/m\u00b2, {:.4g} lx, mean wavelength {:.1f} nm",
                                 report.samples.irradiance.front(), illuminance_lx(report, 0),
                                 report.samples.meanWavelength_nm.front());
    chart.xLabel = "wavelength, nm";
    chart.yLabel = "spectral irradiance, W/m\u00b2/nm";
    for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band) {
        chart.x.push_back(compile::bandMiddle_nm(band));
        chart.y.push_back(report.bands.front()[band] / bandWidth_nm(band));
    }
    std::vector<image::Pixel> pixels;
    for (double at = chart.x.front(); at <= chart.x.back(); ++at) {
        const compile::BandShare share = compile::bandShare(at);
        const double density =
            (1.0 - share.upper) * chart.y[share.band] +
            share.upper * chart.y[std::min<std::size_t>(share.band + 1, chart.y.size() - 1)];
        const dvec3 xyz = density * optics::colorMatching(at);
        pixels.push_back(
            {static_cast<float>(xyz.x), static_cast<float>(xyz.y), static_cast<float>(xyz.z), false});
    }
    chart.strip = stripOf(pixels);
    return chart;
}

bool isCsv(const std::filesystem::path& path) {
    return path.extension() == ".csv";
}

}  // namespace

std::vector<const scene::Light*> spectrometersOf(const scene::Scene& scene) {
    std::vector<const scene::Light*> lights;
    for (const scene::Light& light : scene.lights)
        if (isRuled(light)) lights.push_back(&light);
    return lights;
}

Report reportOn(const scene::Scene& scene, const std::string& file, const SurfaceLine& line,
                const scene::Light* light, std::uint32_t count) {
    const scene::Object& under = scene.objects[line.object];
    Report report;
    report.scene = file;
    report.surface = under.name.empty() ? fmt::format("objects[{}]", line.object) : under.name;
    report.line = line;
    report.samples.step = line.length() / count;
    for (std::uint32_t i = 0; i < count; ++i) {
        const dvec3 onLine = line.at((i + 0.5) / count);
        const auto foot = footOn(under.shape, onLine);  // the surface may be slightly curved
        report.samples.points.push_back(foot ? foot->point : onLine);
    }
    if (light != nullptr) {
        report.spectrometer.emplace(*light);
        report.grating = light->name.empty() ? "without a name" : light->name;
    }
    return report;
}

// The bands add up to the irradiance, and their mean is the light's mean wavelength.
void takePicture(std::span<const image::Pixel> pixels, Report& report) {
    const std::size_t count = report.samples.points.size();
    assert(pixels.size() == count * device::SPECTRAL_BANDS);
    report.bands.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        double sum = 0.0, moment = 0.0;
        for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band) {
            const double irradiance = double{pixels[band * count + i].y};
            report.bands[i][band] = irradiance;
            sum += irradiance;
            moment += irradiance * compile::bandMiddle_nm(band);
        }
        report.samples.irradiance.push_back(sum);
        report.samples.meanWavelength_nm.push_back(sum > 0.0 ? moment / sum : 0.0);
    }
    report.maxima = readMaxima(report.samples, report.spectrometer ? &*report.spectrometer : nullptr);
}

double bandWidth_nm(device::uint band) {
    const double middle_nm = compile::bandMiddle_nm(band);
    const double below_nm = band == 0 ? middle_nm - optics::kShortestVisible_nm
                                      : 0.5 * (middle_nm - compile::bandMiddle_nm(band - 1));
    const double above_nm = band + 1 == device::SPECTRAL_BANDS
                                ? optics::kLongestVisible_nm - middle_nm
                                : 0.5 * (compile::bandMiddle_nm(band + 1) - middle_nm);
    return below_nm + above_nm;
}

std::string lengthText(double metres) {
    if (metres < 1e-3) return fmt::format("{:.4g} um", metres * 1e6);
    if (metres < 1.0) return fmt::format("{:.4g} mm", metres * kMillimetres);
    return fmt::format("{:.4g} m", metres);
}

int decimalsOf(const Reading& reading) {
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(reading.uncertainty_nm))), 0, 4);
}

std::string wavelengthText(const Reading& reading) {
    const int decimals = decimalsOf(reading);
    return fmt::format("{:.{}f} +- {:.{}f} nm", reading.wavelength_nm, decimals, reading.uncertainty_nm,
                       decimals);
}

std::string closedFormText(const ClosedFormProfile& form) {
    std::string text =
        form.gratings == 1 ? "closed form of the grating" : "closed forms of the gratings, added";
    text += ", without shadows and other lights";
    if (form.masks > 0) text += "; masks have none";
    return text;
}

std::string csvText(const Report& report) {
    std::string text = fmt::format("# {}: {} samples on {}, {:.6g} m apart\n", report.scene,
                                   report.samples.points.size(), report.surface, report.samples.step);
    text +=
        "# E_...nm: spectral irradiance in W/m^2/nm, mean over a band that reaches halfway to the next ones; "
        "the first from "
        "380 nm on, the last to 780 nm\n";
    text += "position_m,x_m,y_m,z_m,irradiance_W_m2,mean_wavelength_nm";
    for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band)
        text += fmt::format(",E_{:g}nm", compile::bandMiddle_nm(band));
    if (report.closedForm) text += ",closed_form_W_m2";
    text += '\n';
    for (std::size_t i = 0; i < report.samples.points.size(); ++i) {
        const glm::dvec3 p = report.samples.points[i];
        text +=
            fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.7g},{:.7g}", report.position(static_cast<double>(i)),
                        p.x, p.y, p.z, report.samples.irradiance[i], report.samples.meanWavelength_nm[i]);
        for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band)
            text += fmt::format(",{:.7g}", report.bands[i][band] / bandWidth_nm(band));
        if (report.closedForm) text += fmt::format(",{:.7g}", report.closedForm->irradiance[i]);
        text += '\n';
    }
    return text;
}

double illuminance_lx(const Report& report, std::size_t sample) {
    double sum = 0.0;
    for (device::uint band = 0; band < device::SPECTRAL_BANDS; ++band)
        sum += report.bands[sample][band] * optics::colorMatching(compile::bandMiddle_nm(band)).y;
    return optics::kMaximumLuminousEfficacy * sum;
}

plot::Chart chartOf(const Report& report) {
    if (report.samples.points.size() == 1) return spectrumChart(report);
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
    for (const SpectralMaximum& maximum : report.maxima) {
        const double position = report.position(maximum.maximum.place);
        chart.marks.push_back({position * kMillimetres, maximum.maximum.value, markText(report, maximum)});
    }
    chart.strip = stripOf(report);
    if (report.closedForm)
        chart.reference = {closedFormText(*report.closedForm), report.closedForm->irradiance};
    return chart;
}

bool isReportFile(const std::filesystem::path& path) {
    return isCsv(path) || plot::isChartFile(path);
}

void writeReport(const std::filesystem::path& path, const Report& report) {
    if (!isCsv(path)) {
        plot::writeChart(path, chartOf(report));
        return;
    }
    const std::string text = csvText(report);
    image::PendingFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

}  // namespace fringe::profile
