// `fringe preview` in a window of a virtual display, and hands on it. Every session is under the validation
// layer: what that says makes the program end with status 2.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "preview/display.hpp"

namespace fringe::preview {

// The scene that most sessions show, and places of its panel in pixels of the window.
inline const std::string kScene = FRINGE_SOURCE_DIR "/scenes/thesis/figure-24.json";
inline constexpr int kPanel = 340;                          // of the left
inline constexpr int kMoreSlitsX = 198, kMoreSlitsY = 356;  // "+" of the first grating's count

// That a program ended well and had nothing to complain of.
void expectDone(const cli::Outcome& outcome);

// Looks until it is so: a window answers in its own time, and what a driver for processors takes no test can
// know. False if it is not within 30 s.
bool becomes(const std::function<bool()>& condition);

class Session {
public:
    // Starts it in a folder of its own, and waits for the window.
    explicit Session(const cli::Arguments& arguments,
                     std::shared_ptr<const Display> display = std::make_shared<const Display>(),
                     std::map<std::string, std::string> environment = {});

    const Display& display() const { return *display_; }
    const std::filesystem::path& folder() const { return folder_.path(); }

    std::string title() const;

    // Waits until the title contains `text`; false if it does not within 30 s.
    bool says(const std::string& text) const;

    // Waits for a finished picture of all samples.
    bool completes() const { return says(", complete"); }

    // The window's inside.
    Screen picture() const;

    void key(const std::string& keys) const;                                  // "ctrl+q"
    void drag(int fromX, int fromY, int toX, int toY, int button = 1) const;  // in steps of a few pixels
    void click(int x, int y) const;
    void move(int x, int y) const;
    void resize(int width, int height) const;
    void hide() const;  // as minimising does
    void show() const;

    // Waits for the end, which is to come of itself.
    cli::Outcome end() { return program_.wait(); }

    // Presses Ctrl+Q and waits for the end.
    cli::Outcome quit();

private:
    std::shared_ptr<const Display> display_;
    image::TestFolder folder_;
    std::vector<std::string> others_;  // windows that were there before
    cli::Program program_;
    std::string window_;
};

}  // namespace fringe::preview
