// A line on the terminal that says how far a render is and how long it will take.
#pragma once

#include <chrono>

namespace fringe::cli {

class Progress {
public:
    // Silent when told so, and when standard error is no terminal.
    explicit Progress(bool quiet);
    ~Progress();  // takes the line away
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Share of the work done, 0..1. Shows nothing in the first second.
    void show(double done);

private:
    using Clock = std::chrono::steady_clock;

    bool enabled_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point lastShown_ = start_;
};

}  // namespace fringe::cli
