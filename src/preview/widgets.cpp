#include "preview/widgets.hpp"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <cmath>

namespace fringe::preview {

Widgets::Widgets(const Window& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // what the user arranges is not kept: no file appears in the working folder
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = style.FrameRounding = style.GrabRounding = 3.0F;
    style.ScaleAllSizes(window.scale());
    ImFontConfig font;
    font.SizePixels = std::round(13.0F * window.scale());  // the built-in font is drawn for 13 pixels
    io.Fonts->AddFontDefault(&font);
    ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
}

Widgets::~Widgets() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Widgets::begin() const {
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Widgets::end() const {
    ImGui::Render();
}

}  // namespace fringe::preview
