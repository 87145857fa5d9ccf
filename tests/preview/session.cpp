#include "preview/session.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <sstream>
#include <thread>
#include <utility>

namespace fringe::preview {
namespace {

using namespace std::chrono_literals;
constexpr auto kPatience = 30s;  // many times what anything takes
constexpr auto kLook = 20ms;
constexpr auto kStep = 15ms;  // between two motions of the mouse

std::vector<std::string> windowsOn(const Display& display) {
    std::istringstream numbers(display.tool("search --onlyvisible --name Fringe"));
    return {std::istream_iterator<std::string>(numbers), {}};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::map<std::string, std::string> with(std::map<std::string, std::string> environment,
                                        const Display& display) {
    environment["DISPLAY"] = display.name();
    return environment;
}

}  // namespace

void expectDone(const cli::Outcome& outcome) {
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
}

bool becomes(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(kLook);
    }
    return true;
}

Session::Session(const cli::Arguments& arguments, std::shared_ptr<const Display> display,
                 std::map<std::string, std::string> environment)
    : display_(std::move(display)),
      others_(windowsOn(*display_)),
      program_(arguments,
               {.folder = folder_.path(), .environment = with(std::move(environment), *display_)}) {
    const bool isOpen = becomes([&] {
        for (const std::string& window : windowsOn(*display_))
            if (std::find(others_.begin(), others_.end(), window) == others_.end()) window_ = window;
        return !window_.empty();
    });
    EXPECT_TRUE(isOpen) << "no window";
    display_->tool("windowfocus " + window_);
}

std::string Session::title() const {
    return display_->tool("getwindowname " + window_);
}

bool Session::says(const std::string& text) const {
    return becomes([&] { return contains(title(), text); });
}

Screen Session::picture() const {
    const auto number = [&](const std::string& geometry, const std::string& name) {
        const std::size_t at = geometry.find(name + "=");
        return at == std::string::npos ? 0 : std::stoi(geometry.substr(at + name.size() + 1));
    };
    display_->tool("mousemove 1279 899");     // its arrow is on the screen as well
    std::this_thread::sleep_for(10 * kLook);  // the title is set just before the screen shows the picture
    const std::string geometry = display_->tool("getwindowgeometry --shell " + window_);
    const Screen whole = display_->screen();
    Screen inside{static_cast<std::uint32_t>(number(geometry, "WIDTH")),
                  static_cast<std::uint32_t>(number(geometry, "HEIGHT")),
                  {}};
    const auto left = static_cast<std::uint32_t>(number(geometry, "X"));
    const auto top = static_cast<std::uint32_t>(number(geometry, "Y"));
    for (std::uint32_t y = 0; y < inside.height; ++y)
        for (std::uint32_t x = 0; x < inside.width; ++x) inside.pixels.push_back(whole.at(left + x, top + y));
    return inside;
}

void Session::key(const std::string& keys) const {
    display_->tool(fmt::format("windowfocus {} key {}", window_, keys));
}

void Session::drag(int fromX, int fromY, int toX, int toY, int button) const {
    display_->tool(fmt::format("mousemove --window {} {} {}", window_, fromX, fromY));
    std::this_thread::sleep_for(5 * kStep);
    display_->tool(fmt::format("mousedown {}", button));
    std::this_thread::sleep_for(5 * kStep);
    constexpr int kSteps = 30;
    for (int i = 1; i <= kSteps; ++i) {
        display_->tool(fmt::format("mousemove --window {} {} {}", window_, fromX + (toX - fromX) * i / kSteps,
                                   fromY + (toY - fromY) * i / kSteps));
        std::this_thread::sleep_for(kStep);
    }
    display_->tool(fmt::format("mouseup {}", button));
    std::this_thread::sleep_for(20 * kStep);  // then it counts as resting
}

void Session::click(int x, int y) const {
    display_->tool(fmt::format("mousemove --window {} {} {}", window_, x, y));
    std::this_thread::sleep_for(5 * kStep);
    display_->tool("mousedown 1");
    std::this_thread::sleep_for(5 * kStep);
    display_->tool("mouseup 1");
    std::this_thread::sleep_for(5 * kStep);
}

void Session::move(int x, int y) const {
    display_->tool(fmt::format("windowmove {} {} {}", window_, x, y));
}

void Session::resize(int width, int height) const {
    display_->tool(fmt::format("windowsize {} {} {}", window_, width, height));
}

void Session::hide() const {
    display_->tool("windowunmap " + window_);
    std::this_thread::sleep_for(10 * kLook);
}

void Session::show() const {
    display_->tool("windowmap --sync " + window_);
    display_->tool("windowfocus " + window_);
}

cli::Outcome Session::quit() {
    key("ctrl+q");
    return program_.wait();
}

}  // namespace fringe::preview
