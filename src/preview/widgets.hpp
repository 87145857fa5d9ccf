// Dear ImGui on a window: its context, its looks and its input. One at a time.
#pragma once

#include "preview/window.hpp"

namespace fringe::preview {

class Widgets {
public:
    explicit Widgets(const Window& window);
    ~Widgets();
    Widgets(const Widgets&) = delete;
    Widgets& operator=(const Widgets&) = delete;

    // Between these, ImGui's functions may be called. A Presenter must exist, which draws them.
    void begin() const;
    void end() const;
};

}  // namespace fringe::preview
