#include "preview/instrument_panel.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "compile/spectral.hpp"
#include "preview/chart_view.hpp"

namespace fringe::preview {
namespace {

constexpr float kWidth = 470.0F, kHeight = 660.0F;  // before scaling
constexpr float kChartHeight = 330.0F;
constexpr std::size_t kMostMaxima = 9;
constexpr double kMillimetres = 1e3;

void line(const std::string& text) {
    ImGui::TextWrapped("%s", text.c_str());
}

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

bool beginTable(const char* name, std::initializer_list<const char*> columns) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable(name, static_cast<int>(columns.size()), flags)) return false;
    for (const char* column : columns) ImGui::TableSetupColumn(column);
    ImGui::TableHeadersRow();
    return true;
}

std::string ordersText(const profile::Sighting& sighting) {
    std::string text;
    const auto append = [&](const std::string& words) { text += (text.empty() ? "" : "\n") + words; };
    if (sighting.isUndeviated) append("0");
    for (const profile::LineOrder& own : sighting.lines)
        append(fmt::format("{:+.3f} at {:.5g} nm", own.order, own.wavelength_nm));
    for (const profile::OrderWavelength& own : sighting.orders)
        append(fmt::format("{:+d} of {:.1f} nm", own.order, own.wavelength_nm));
    return text.empty() ? "-" : text;
}

void drawSightings(const Instrument& instrument) {
    if (instrument.sightings().empty()) return;
    if (!instrument.probe()->isPoint()) ImGui::TextUnformatted("from the middle of the line:");
    if (!beginTable("sightings", {"grating", "distance", "angle", "sine u, v", "order"})) return;
    for (const profile::Sighting& sighting : instrument.sightings()) {
        cell(sighting.grating);
        cell(profile::lengthText(sighting.distance));
        cell(fmt::format("{:.2f}\u00b0", sighting.angle_deg));
        cell(fmt::format("{:+.5f}{}", sighting.u,
                         sighting.v != 0.0 ? fmt::format("\n{:+.5f}", sighting.v) : std::string()));
        cell(ordersText(sighting));
    }
    ImGui::EndTable();
}

void drawMaxima(const profile::Report& report) {
    if (report.maxima.empty()) return;
    if (!beginTable("maxima", {"maximum at", "irradiance", "order", "wavelength"})) return;
    std::vector<const profile::SpectralMaximum*> highest;
    for (const profile::SpectralMaximum& maximum : report.maxima) highest.push_back(&maximum);
    std::stable_sort(highest.begin(), highest.end(),
                     [](const auto* a, const auto* b) { return a->maximum.value > b->maximum.value; });
    highest.resize(std::min(highest.size(), kMostMaxima));
    std::sort(highest.begin(), highest.end());
    for (const profile::SpectralMaximum* maximum : highest) {
        cell(fmt::format("{:.3f} mm", report.position(maximum->maximum.place) * kMillimetres));
        cell(fmt::format("{:.4g} W/m\u00b2", maximum->maximum.value));
        const auto& reading = maximum->reading;
        cell(reading ? fmt::format("{:+d}", reading->order) : report.spectrometer ? "0" : "-");
        cell(reading
                 ? fmt::format("{}{}", profile::wavelengthText(*reading), reading->blend ? ", several" : "")
                 : "-");
    }
    ImGui::EndTable();
    if (report.maxima.size() > kMostMaxima)
        line(fmt::format("the highest of {} maxima", report.maxima.size()));
}

void drawPoint(const profile::Report& report) {
    const glm::dvec3 p = report.line.at(0.5);
    line(fmt::format("{} at ({:.4f}, {:.4f}, {:.4f}) m", report.surface, p.x, p.y, p.z));
    line(fmt::format("{:.4g} W/m\u00b2     {:.4g} lx     mean wavelength {:.1f} nm",
                     report.samples.irradiance.front(), profile::illuminance_lx(report, 0),
                     report.samples.meanWavelength_nm.front()));
}

void drawLine(const profile::Report& report, bool isComputing) {
    line(fmt::format("{} of {}, {} samples", profile::lengthText(report.line.length()), report.surface,
                     report.samples.points.size()));
    const ImVec4 orange(0.87F, 0.55F, 0.2F, 1.0F);
    const std::string text = report.closedForm ? profile::closedFormText(*report.closedForm)
                             : isComputing     ? "closed form: being computed"
                                               : "no light of the scene has a closed form";
    ImGui::PushStyleColor(ImGuiCol_Text, orange);
    line(text);
    ImGui::PopStyleColor();
}

std::string hoverText(const profile::Report& report, std::size_t i) {
    if (report.samples.points.size() == 1) {
        const auto band = static_cast<device::uint>(i);
        return fmt::format("{:.4g} nm: {:.4g} W/m\u00b2/nm", compile::bandMiddle_nm(band),
                           report.bands.front()[i] / profile::bandWidth_nm(band));
    }
    std::string text =
        fmt::format("{:.4f} mm: {:.4g} W/m\u00b2", report.position(static_cast<double>(i)) * kMillimetres,
                    report.samples.irradiance[i]);
    if (report.closedForm) text += fmt::format(", closed form {:.4g}", report.closedForm->irradiance[i]);
    return text + fmt::format(", {:.4g} lx, mean {:.1f} nm", profile::illuminance_lx(report, i),
                              report.samples.meanWavelength_nm[i]);
}

// True when it is to be written to files.
bool drawFound(const Instrument& instrument, const State& state, float scale) {
    const Measured& found = *instrument.found();
    if (!found.report) {
        line(found.error);
        return false;
    }
    const profile::Report& report = *found.report;
    const bool isPoint = report.samples.points.size() == 1;
    if (isPoint) drawPoint(report);
    else drawLine(report, instrument.isComputing());
    const auto hovered =
        drawChart(instrument.chart(), ImGui::GetContentRegionAvail().x, kChartHeight * scale);
    line(hovered ? hoverText(report, *hovered) : state.measuring ? "measuring again" : " ");
    drawSightings(instrument);
    if (!isPoint) drawMaxima(report);
    const auto files = instrument.exported()->files;
    return ImGui::Button(fmt::format("write {} and others (X)", files.front().string()).c_str());
}

// Where it is measured, over the picture.
void drawPlaces(const Instrument& instrument, const scene::Scene& scene, const scene::Camera& camera,
                const Rectangle& place) {
    constexpr ImU32 kLight = IM_COL32(255, 255, 255, 255), kDark = IM_COL32(0, 0, 0, 200);
    constexpr float kRadius = 5.0F;
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const auto toWindow = [&](const glm::dvec3& point) -> std::optional<ImVec2> {
        const auto at = placeOf(scene.image, camera, point);
        if (!at) return std::nullopt;
        return ImVec2(static_cast<float>(place.x + at->x * place.width / scene.image.width),
                      static_cast<float>(place.y + at->y * place.height / scene.image.height));
    };
    const auto spot = [&](ImVec2 at) {
        list->AddCircle(at, kRadius, kDark, 0, 3.0F);
        list->AddCircle(at, kRadius, kLight, 0, 1.5F);
    };
    const auto mark = [&](const glm::dvec3& from, const glm::dvec3& to, bool isPoint) {
        const auto a = toWindow(from), b = toWindow(to);
        if (!a || !b) return;
        if (!isPoint) {
            list->AddLine(*a, *b, kDark, 3.0F);
            list->AddLine(*a, *b, kLight, 1.5F);
            spot(*a);
        }
        spot(*b);
    };
    if (instrument.drawn()) mark(instrument.drawn()->from, instrument.drawn()->to, false);
    else if (const auto& probe = instrument.probe()) mark(probe->from, probe->to, probe->isPoint());
}

}  // namespace

int instrumentWidth(const Instrument& instrument, float scale) {
    return instrument.isOn() ? static_cast<int>(kWidth * scale) : 0;
}

int instrumentHeight(float scale) {
    return static_cast<int>(kHeight * scale);
}

bool drawInstrument(const Instrument& instrument, const State& state, const scene::Scene& scene,
                    const scene::Camera& camera, const Rectangle& place, float scale) {
    if (!instrument.isOn()) return false;
    drawPlaces(instrument, scene, camera, place);
    const auto width = static_cast<float>(instrumentWidth(instrument, scale));
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x - width, 0.0F});
    ImGui::SetNextWindowSize({width, window.y});
    ImGui::Begin("##instrument", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    bool isToBeWritten = false;
    if (!instrument.complaint().empty()) line(instrument.complaint());
    else if (instrument.found()) isToBeWritten = drawFound(instrument, state, scale);
    else if (state.measuring)
        ImGui::ProgressBar(static_cast<float>(*state.measuring), {-1.0F, 0.0F}, "measuring");
    else
        line(
            "Click a surface: irradiance and spectrum there. Drag over it: the profile along a line. "
            "I leaves the instrument.");
    ImGui::End();
    return isToBeWritten;
}

}  // namespace fringe::preview
