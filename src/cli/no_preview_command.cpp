// fringe preview, in a program that was built without a window.
#include "cli/commands.hpp"

namespace fringe::cli {

void addPreview(CLI::App& app, Command& chosen) {
    CLI::App* command =
        app.add_subcommand("preview", "Show a scene in a window (this program was built without it)");
    command->allow_extras();
    command->callback([&chosen] {
        chosen = []() -> int {
            throw NoWindow(
                "this program was built without the preview; install GLFW and Dear ImGui, on Debian: apt-get "
                "install libglfw3-dev libimgui-dev; then configure and build again");
        };
    });
}

}  // namespace fringe::cli
