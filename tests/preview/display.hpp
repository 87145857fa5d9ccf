// A virtual display: its screen as a picture, and a mouse and a keyboard by xdotool.
#pragma once

#include <sys/types.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "image/pictures.hpp"

namespace fringe::preview {

struct Screen {
    std::uint32_t width = 0, height = 0;
    std::vector<std::array<std::uint8_t, 3>> pixels;  // red, green, blue; row by row

    const std::array<std::uint8_t, 3>& at(std::uint32_t x, std::uint32_t y) const {
        return pixels.at(std::size_t{y} * width + x);
    }
};

class Display {
public:
    // Starts Xvfb. Throws std::runtime_error.
    Display();
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    const std::string& name() const { return name_; }  // ":99"

    Screen screen() const;

    // From now on programs see a display of this many dots per inch of text; 96 is the default.
    void setDensity(int dpi) const;

    // Runs `xdotool ARGUMENTS` and returns what it prints, without the last line's end.
    std::string tool(const std::string& arguments) const;

private:
    image::TestFolder folder_;  // the screen's memory is a file there
    pid_t server_ = -1;
    std::string name_;
};

}  // namespace fringe::preview
