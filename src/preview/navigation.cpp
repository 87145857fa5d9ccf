#include "preview/navigation.hpp"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "preview/camera_motion.hpp"
#include "preview/picking.hpp"

namespace fringe::preview {
namespace {

constexpr double kTurn = std::numbers::pi;  // radians that dragging across the picture's height orbits
constexpr double kWheel = 0.9;              // of the distance, per notch
constexpr double kDolly = 4.0;              // powers of two of the distance, per picture's height
constexpr double kFlight = 0.5;             // of the distance to the target, per second

struct FlightKey {
    int key;
    glm::dvec3 direction;  // right, up, forward
};
constexpr std::array<FlightKey, 6> kFlightKeys{{{GLFW_KEY_W, {0, 0, 1}},
                                                {GLFW_KEY_S, {0, 0, -1}},
                                                {GLFW_KEY_A, {-1, 0, 0}},
                                                {GLFW_KEY_D, {1, 0, 0}},
                                                {GLFW_KEY_E, {0, 1, 0}},
                                                {GLFW_KEY_Q, {0, -1, 0}}}};

struct ViewKey {
    int key;
    Side side;
};
constexpr std::array<ViewKey, 6> kViewKeys{{{GLFW_KEY_1, Side::front},
                                            {GLFW_KEY_2, Side::right},
                                            {GLFW_KEY_3, Side::top},
                                            {GLFW_KEY_4, Side::back},
                                            {GLFW_KEY_5, Side::left},
                                            {GLFW_KEY_6, Side::bottom}}};

constexpr std::array<KeyHelp, 7> kNavigationKeys{
    {{"left mouse button", "orbit around the target"},
     {"middle button, or Shift and left", "pan"},
     {"right button, or wheel", "dolly to the target and back"},
     {"W A S D, E Q", "fly: forward, left, back, right, up, down"},
     {"1 2 3", "look from the front, the right, the top"},
     {"4 5 6", "from the back, the left, the bottom"},
     {"H", "home: the camera of the scene file"}}};

bool hasKeyboard() {
    const ImGuiIO& io = ImGui::GetIO();
    return !io.WantTextInput && !io.KeyCtrl;
}

glm::dvec3 flight(const Window& window) {
    glm::dvec3 sum(0.0);
    if (!hasKeyboard()) return sum;
    for (const FlightKey& key : kFlightKeys)
        if (window.holds(key.key)) sum += key.direction;
    return sum;
}

std::optional<scene::Camera> dragged(const scene::Camera& camera, double height, bool leftOrbits) {
    const ImGuiIO& io = ImGui::GetIO();
    const double x = double{io.MouseDelta.x} / height, y = double{io.MouseDelta.y} / height;
    if ((x == 0.0 && y == 0.0) || io.WantCaptureMouse) return std::nullopt;
    const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (left && io.KeyShift)) return panned(camera, x, -y);
    if (left && !ImGui::IsMouseDragging(ImGuiMouseButton_Left)) return std::nullopt;  // a click, so far
    if (left && leftOrbits) return orbited(camera, -kTurn * x, kTurn * y);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) return dollied(camera, std::exp2(kDolly * y));
    return std::nullopt;
}

std::optional<scene::Camera> byKey(const scene::Camera& camera, const scene::Scene& scene,
                                   const Window& window, std::span<const KeyPress> keys) {
    if (!hasKeyboard()) return std::nullopt;
    for (const KeyPress& press : keys) {
        if (press.key == GLFW_KEY_H) return scene.camera;
        for (const ViewKey& view : kViewKeys)
            if (press.key == view.key) return withinRoom(scene, seenFrom(camera, view.side));
    }
    const glm::dvec3 direction = flight(window);
    if (direction == glm::dvec3(0.0)) return std::nullopt;
    const double distance = glm::distance(camera.position, camera.target);
    return flown(camera, kFlight * distance * double{ImGui::GetIO().DeltaTime} * direction);
}

}  // namespace

std::optional<scene::Camera> navigated(const scene::Camera& camera, const scene::Scene& scene,
                                       const Rectangle& place, const Window& window,
                                       std::span<const KeyPress> keys, bool leftOrbits) {
    const ImGuiIO& io = ImGui::GetIO();
    std::optional<scene::Camera> result = dragged(camera, std::max(1.0, 1.0 * place.height), leftOrbits);
    if (io.MouseWheel != 0.0F && !io.WantCaptureMouse)
        result = dollied(result.value_or(camera), std::pow(kWheel, double{io.MouseWheel}));
    if (const auto moved = byKey(result.value_or(camera), scene, window, keys)) result = moved;
    return result;
}

bool isFlying(const Window& window) {
    return flight(window) != glm::dvec3(0.0);
}

std::span<const KeyHelp> navigationHelp() {
    return kNavigationKeys;
}

}  // namespace fringe::preview
