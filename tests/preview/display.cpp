#include "preview/display.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace fringe::preview {
namespace {

// Big-endian words of an XWD file, version 7 (X11/XWDFile.h).
std::uint32_t wordOf(const std::string& bytes, std::size_t index) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word = word << 8 | static_cast<std::uint8_t>(bytes.at(4 * index + i));
    return word;
}

}  // namespace

Display::Display() {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    server_ = fork();
    if (server_ == 0) {
        const std::string folder = folder_.path().string();
        const int silence = open("/dev/null", O_WRONLY);
        dup2(silence, STDERR_FILENO);
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        // Without -noreset it would start afresh whenever its last client leaves, such as an xdotool.
        execlp("Xvfb", "Xvfb", "-displayfd", "1", "-screen", "0", "1280x900x24", "-fbdir", folder.c_str(),
               "-nolisten", "tcp", "-noreset", nullptr);
        _exit(127);
    }
    close(ends[1]);
    char byte = 0;
    name_ = ':';
    while (read(ends[0], &byte, 1) == 1 && byte != '\n') name_ += byte;
    close(ends[0]);
    if (name_.size() == 1) throw std::runtime_error("Xvfb does not start");
}

Display::~Display() {
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
}

Screen Display::screen() const {
    const std::string bytes = image::bytesOf(folder_ / "Xvfb_screen0");
    const std::size_t headerSize = wordOf(bytes, 0), colors = wordOf(bytes, 19), lineSize = wordOf(bytes, 12);
    constexpr std::size_t kColorSize = 12;  // bytes of an entry of the colour map
    Screen screen{wordOf(bytes, 4), wordOf(bytes, 5), {}};
    for (std::uint32_t y = 0; y < screen.height; ++y) {
        for (std::uint32_t x = 0; x < screen.width; ++x) {
            const std::size_t at = headerSize + colors * kColorSize + y * lineSize + std::size_t{4} * x;
            const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes.at(at + i)); };
            screen.pixels.push_back(
                {byte(2), byte(1), byte(0)});  // blue first, as little-endian servers have it
        }
    }
    return screen;
}

void Display::setDensity(int dpi) const {
    const std::string command =
        "DISPLAY=" + name_ +
        " xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER 'Xft.dpi: " + std::to_string(dpi) + "'";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("xprop does not work");
}

std::string Display::tool(const std::string& arguments) const {
    const std::string command = "DISPLAY=" + name_ + " xdotool " + arguments + " 2>/dev/null";
    std::FILE* output = popen(command.c_str(), "r");
    std::string text;
    for (int c = std::fgetc(output); c != EOF; c = std::fgetc(output)) text += static_cast<char>(c);
    pclose(output);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

}  // namespace fringe::preview
