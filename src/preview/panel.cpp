#include "preview/panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "preview/false_color.hpp"
#include "preview/instrument.hpp"
#include "preview/navigation.hpp"
#include "preview/scene_editor.hpp"

namespace fringe::preview {
namespace {

constexpr float kPanelWidth = 340.0F;  // of the panel, before scaling
constexpr float kLabels = -110.0F;     // what values leave for them

constexpr std::array<KeyHelp, 5> kPanelKeys{{{"Tab", "panel"},
                                             {"? or F1", "these keys"},
                                             {"P", "save the picture, as PNG and EXR"},
                                             {"Ctrl and S", "save the changed scene"},
                                             {"Ctrl and Q", "quit"}}};

void drawLegend() {
    for (const Decade& decade : decades()) {
        const ImVec4 color(static_cast<float>(decade.color[0]) / 255.0F,
                           static_cast<float>(decade.color[1]) / 255.0F,
                           static_cast<float>(decade.color[2]) / 255.0F, 1.0F);
        ImGui::ColorButton("##decade", color, ImGuiColorEditFlags_NoTooltip);
        ImGui::SameLine();
        ImGui::Text("1e%d to 1e%d of display white", decade.exponent, decade.exponent + 1);
    }
}

bool drawDisplay(Settings& settings, const Facts& facts) {
    if (!ImGui::CollapsingHeader("Picture", ImGuiTreeNodeFlags_DefaultOpen)) return false;
    bool changed = false;
    auto exposure = static_cast<float>(settings.display.exposure);
    if (ImGui::SliderFloat("exposure", &exposure, -16.0F, 16.0F, "%+.2f stops")) {
        settings.display.exposure = double{exposure};
        changed = true;
    }
    auto curve = static_cast<int>(settings.display.toneCurve);
    const auto nameOf = [](void*, int index, const char** name) {
        *name = image::kToneCurves.at(static_cast<std::size_t>(index)).name.data();
        return true;
    };
    if (ImGui::Combo("tone curve", &curve, nameOf, nullptr, static_cast<int>(image::kToneCurves.size()))) {
        settings.display.toneCurve = image::kToneCurves.at(static_cast<std::size_t>(curve)).curve;
        changed = true;
    }
    auto view = static_cast<int>(settings.display.view);  // in the order of the enumeration
    if (ImGui::Combo("view", &view,
                     "colour\0luminance, in decades\0one wavelength\0one wavelength, in grey\0")) {
        settings.display.view = static_cast<View>(view);
        changed = true;
    }
    if (showsWavelength(settings.display.view)) {
        auto wavelength_nm = static_cast<float>(settings.wavelength_nm);
        if (ImGui::SliderFloat("wavelength", &wavelength_nm, 390.0F, 770.0F, "%.0f nm")) {
            settings.wavelength_nm = double{wavelength_nm};
            changed = true;
        }
    }
    if (settings.display.view == View::decades) drawLegend();
    int samples = static_cast<int>(settings.samples);
    if (ImGui::SliderInt("preview samples", &samples, 1, 1024, "%d", ImGuiSliderFlags_Logarithmic)) {
        settings.samples = static_cast<std::uint32_t>(std::clamp(samples, 1, 65535));
        changed = true;
    }
    if (facts.picture != nullptr) {
        ImGui::Text("%u x %u, sample %u of %u", facts.picture->width, facts.picture->height,
                    facts.picture->samples, settings.samples);
        ImGui::Text("exposure in all %+.2f stops", facts.picture->exposure);
    }
    return changed;
}

// What of the scene is shown.
bool drawSwitches(Settings& settings, const Document& document) {
    if (!ImGui::CollapsingHeader("Switches")) return false;
    bool changed = false;
    Switches& switches = settings.switches;
    changed = ImGui::Checkbox("mirrors, glass and discs as grey walls", &switches.mattOnly) || changed;
    changed = ImGui::Checkbox("no shadows", &switches.noShadows) || changed;
    const Json::Value& lights = document.root()["lights"];
    for (Json::ArrayIndex i = 0; i < lights.size(); ++i) {
        if (!lights[i].isObject()) continue;
        ImGui::PushID(static_cast<int>(i));
        bool isOn = !switches.darkLights.contains(i);
        if (ImGui::Checkbox(entryName(lights[i], i).c_str(), &isOn)) {
            if (isOn) switches.darkLights.erase(i);
            else switches.darkLights.insert(i);
            changed = true;
        }
        ImGui::PopID();
    }
    return changed;
}

void drawTimes(const Facts& facts) {
    if (!ImGui::CollapsingHeader("Renderer", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const State& state = facts.state;
    ImGui::TextWrapped("%s", state.device.empty() ? "opening the device" : state.device.c_str());
    // Either way a line, so that nothing jumps.
    if (facts.picturesPerSecond > 0.0F) {
        ImGui::Text("%5.1f pictures/s while it moves", double{facts.picturesPerSecond});
    } else {
        ImGui::TextUnformatted("    - pictures/s while it moves");
    }
    ImGui::Text("%5.1f ms a sample, full size", state.timing.sample);
    ImGui::Text("%5.1f ms to develop", state.timing.develop);
    ImGui::Text("%5.1f ms to compile the scene", state.timing.scene);
    ImGui::Text("%5.1f ms for the last pipeline (%llu)", state.timing.pipeline,
                static_cast<unsigned long long>(state.timing.pipelines));
    if (ImGui::TreeNode("specialisation")) {
        ImGui::TextWrapped("%s", state.specialisation.c_str());
        ImGui::TreePop();
    }
}

void drawKeys(Settings& settings, int left) {
    if (!settings.showsKeys) return;
    constexpr float kMargin = 20.0F;
    ImGui::SetNextWindowPos({static_cast<float>(left) + kMargin, kMargin}, ImGuiCond_Appearing);
    ImGui::Begin("Keys", &settings.showsKeys,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
    // Within the window, which may be narrow.
    const float room = std::max(ImGui::GetIO().DisplaySize.x - static_cast<float>(left) - 3.0F * kMargin,
                                20.0F * ImGui::GetFontSize());
    if (ImGui::BeginTable("keys", 2)) {
        const auto row = [&](const KeyHelp& help) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(help.keys);
            ImGui::TableNextColumn();
            ImGui::PushTextWrapPos(room);
            ImGui::TextUnformatted(help.what);
            ImGui::PopTextWrapPos();
        };
        for (const KeyHelp& help : navigationHelp()) row(help);
        for (const KeyHelp& help : instrumentHelp()) row(help);
        for (const KeyHelp& help : kPanelKeys) row(help);
        ImGui::EndTable();
    }
    ImGui::End();
}

// At the lower edge of the picture, over it.
void drawMessages(const Facts& facts, int left) {
    const State& state = facts.state;
    const std::string& news = facts.notice.empty() ? state.activity : facts.notice;
    const std::string& error = state.error.empty() ? state.shaderError : state.error;
    if (news.empty() && error.empty() && facts.fileProblem.empty()) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const auto begin = static_cast<float>(left);
    ImGui::SetNextWindowPos({begin, size.y}, ImGuiCond_Always, {0.0F, 1.0F});
    ImGui::SetNextWindowSize({size.x - begin, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.85F);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    ImGui::Begin("##messages", nullptr, flags);
    ImGui::PushStyleColor(ImGuiCol_Text, {1.0F, 0.55F, 0.45F, 1.0F});
    for (const std::string* problem : {&facts.fileProblem, &error})
        if (!problem->empty()) ImGui::TextWrapped("%s", problem->c_str());
    ImGui::PopStyleColor();
    if (!news.empty()) ImGui::TextWrapped("%s", news.c_str());
    ImGui::End();
}

}  // namespace

int panelWidth(const Settings& settings, float scale) {
    return settings.showsPanel ? static_cast<int>(kPanelWidth * scale) : 0;
}

PanelActions drawPanel(Settings& settings, Document& document, const Facts& facts, float scale) {
    PanelActions actions;
    const int width = panelWidth(settings, scale);
    if (settings.showsPanel) {
        ImGui::SetNextWindowPos({0.0F, 0.0F});
        ImGui::SetNextWindowSize({static_cast<float>(width), ImGui::GetIO().DisplaySize.y});
        ImGui::Begin("##panel", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoBringToFrontOnFocus);
        ImGui::PushItemWidth(kLabels * scale);
        actions.display = drawDisplay(settings, facts);
        actions.savePicture = ImGui::Button("save picture (P)");
        ImGui::SameLine();
        actions.saveScene = ImGui::Button("save scene (Ctrl S)");
        actions.scene = drawSceneEditor(document);
        if (drawSwitches(settings, document)) actions.display = true;
        drawTimes(facts);
        ImGui::PopItemWidth();
        ImGui::End();
    }
    drawKeys(settings, width);
    drawMessages(facts, width);
    return actions;
}

}  // namespace fringe::preview
