// A window of the desktop, by GLFW.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

struct GLFWwindow;

namespace fringe::preview {

// There is no display, or no window can be had on it; the message says what to do.
class WindowError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// GLFW itself, from its start to its end. One at a time, in the main thread.
class Desktop {
public:
    Desktop();  // throws WindowError
    ~Desktop();
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    // What Vulkan's instance needs for surfaces on windows. Throws WindowError.
    std::vector<const char*> surfaceExtensions() const;
};

struct Extent {
    int width, height;

    bool operator==(const Extent&) const = default;
};

// A key went down. Those of a short press count as well, which is over before the next frame.
struct KeyPress {
    int key;  // GLFW_KEY_...
    bool shift, control;
};

struct Keyboard {
    std::vector<KeyPress> pressed;  // since they were last taken
    std::set<int> held;  // that went down without Ctrl: of a command nothing is left when Ctrl goes up first
};

class Window {
public:
    // Of about the wanted size in screen coordinates, but no larger than the desktop; hidden until show().
    // Throws WindowError.
    Window(const Desktop& desktop, Extent wanted, const std::string& title);

    GLFWwindow* handle() const { return window_.get(); }

    Extent pixels() const;  // of its inside; 0 x 0 while it is minimised
    float scale() const;    // pixels of a point of text, more than 1 on displays of high density
    bool wantsToClose() const;
    void show();
    void hide();
    void setTitle(const std::string& title);
    void close();

    // Wider by so many pixels and at least so high, as far as the desktop lets it.
    void grow(int width, int leastHeight);

    // The keys that went down since the last call.
    std::vector<KeyPress> takeKeys();

    // Whether it is held down, and was not pressed as a command with Ctrl.
    bool holds(int key) const { return keyboard_->held.contains(key); }

private:
    std::unique_ptr<Keyboard> keyboard_;  // on the heap: GLFW keeps its address
    std::unique_ptr<GLFWwindow, void (*)(GLFWwindow*)> window_;
    std::string title_;
};

// Waits for what the user does, but no longer than so many seconds.
void waitForEvents(double seconds);

}  // namespace fringe::preview
