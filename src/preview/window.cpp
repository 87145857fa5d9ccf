#include "preview/window.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fringe::preview {
namespace {

// GLFW's own words about what went wrong last.
std::string lastError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

Extent fitted(Extent wanted) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return wanted;
    Extent room{};
    glfwGetMonitorWorkarea(monitor, nullptr, nullptr, &room.width, &room.height);
    if (room.width <= 0 || room.height <= 0) return wanted;
    return {std::min(wanted.width, room.width), std::min(wanted.height, room.height)};
}

GLFWwindow* createWindow(Extent wanted, const std::string& title) {
    const Extent size = fitted(wanted);
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    GLFWwindow* window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
    if (window == nullptr) throw WindowError("no window can be opened: " + lastError());
    // Where the display has a high density it may have become larger than was asked for.
    Extent opened{};
    glfwGetWindowSize(window, &opened.width, &opened.height);
    const Extent room = fitted(opened);
    if (room != opened) glfwSetWindowSize(window, room.width, room.height);
    return window;
}

void onKey(GLFWwindow* window, int key, int /*scancode*/, int action, int modifiers) {
    auto& keyboard = *static_cast<Keyboard*>(glfwGetWindowUserPointer(window));
    if (action == GLFW_RELEASE) keyboard.held.erase(key);
    if (action != GLFW_PRESS) return;
    const bool control = (modifiers & GLFW_MOD_CONTROL) != 0;
    keyboard.pressed.push_back({key, (modifiers & GLFW_MOD_SHIFT) != 0, control});
    if (!control) keyboard.held.insert(key);
}

}  // namespace

Desktop::Desktop() {
    if (glfwInit() == GLFW_TRUE) return;
    throw WindowError(fmt::format(
        "there is no display to open a window on ({}); on a machine without one, fringe render writes "
        "pictures to files",
        lastError()));
}

Desktop::~Desktop() {
    glfwTerminate();
}

std::vector<const char*> Desktop::surfaceExtensions() const {
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (names == nullptr)
        throw WindowError("Vulkan cannot show pictures in windows of this display: " + lastError());
    return {names, names + count};
}

Window::Window(const Desktop& /*desktop*/, Extent wanted, const std::string& title)
    : keyboard_(std::make_unique<Keyboard>()),
      window_(createWindow(wanted, title), glfwDestroyWindow),
      title_(title) {
    glfwSetWindowUserPointer(handle(), keyboard_.get());
    glfwSetKeyCallback(handle(), onKey);
}

std::vector<KeyPress> Window::takeKeys() {
    return std::exchange(keyboard_->pressed, {});
}

void Window::show() {
    glfwShowWindow(handle());
}

void Window::hide() {
    glfwHideWindow(handle());
    glfwPollEvents();
}

void Window::close() {
    glfwSetWindowShouldClose(handle(), GLFW_TRUE);
}

void Window::grow(int width, int leastHeight) {
    Extent size{};
    glfwGetWindowSize(handle(), &size.width, &size.height);
    // Sizes are in screen coordinates, which are pixels but for some displays of high density.
    const double perPixel = 1.0 * size.width / std::max(pixels().width, 1);
    const auto scaled = [&](int count) { return static_cast<int>(std::lround(count * perPixel)); };
    const Extent wanted = fitted({size.width + scaled(width), std::max(size.height, scaled(leastHeight))});
    glfwSetWindowSize(handle(), wanted.width, wanted.height);
}

Extent Window::pixels() const {
    Extent size{};
    glfwGetFramebufferSize(handle(), &size.width, &size.height);
    if (glfwGetWindowAttrib(handle(), GLFW_ICONIFIED) == GLFW_TRUE) size = {0, 0};
    return size;
}

float Window::scale() const {
    float x = 1.0F, y = 1.0F;
    glfwGetWindowContentScale(handle(), &x, &y);
    return std::max(x, y);
}

bool Window::wantsToClose() const {
    return glfwWindowShouldClose(handle()) == GLFW_TRUE;
}

void Window::setTitle(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(handle(), title.c_str());
}

void waitForEvents(double seconds) {
    glfwWaitEventsTimeout(seconds);
}

}  // namespace fringe::preview
