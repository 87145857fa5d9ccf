// How quick the preview was: what `fringe preview --stats` writes.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "preview/wish.hpp"

namespace fringe::preview {

// Milliseconds.
class Statistics {
public:
    using Clock = std::chrono::steady_clock;

    void began(Clock::time_point start) { start_ = start; }

    // A wish was made because of what the user did: moved the camera, turned a knob.
    enum class Cause { camera, knob, other };
    void wished(std::uint64_t number, Cause cause);

    // A picture is on the screen that fulfils this wish.
    void shown(const Picture& picture);

    // The window did not look after its events for so long.
    void busyFor(double milliseconds) { longestBusy_ = std::max(longestBusy_, milliseconds); }

    double firstPicture() const { return firstPicture_; }
    // Of reading and compiling the first scene, and those after a knob.
    double firstScene() const { return firstScene_; }
    const std::vector<double>& knobScenes() const { return knobScenes_; }
    double longestBusy() const { return longestBusy_; }
    const std::vector<double>& cameraIntervals() const { return cameraIntervals_; }  // between pictures
    const std::vector<double>& cameraLatencies() const { return cameraLatencies_; }  // from wish to picture
    const std::vector<double>& knobLatencies() const { return knobLatencies_; }
    // Of the last pictures of a moving camera.
    float picturesPerSecond() const;

    std::uint64_t pictures() const { return pictures_; }

private:
    struct Made {
        Clock::time_point at;
        Cause cause;
    };

    Clock::time_point start_ = Clock::now();
    std::map<std::uint64_t, Made> open_;  // wishes without a picture so far
    Clock::time_point lastCameraPicture_{};
    double firstPicture_ = 0.0;
    double firstScene_ = 0.0;
    double longestBusy_ = 0.0;
    std::vector<double> cameraIntervals_, cameraLatencies_, knobLatencies_, knobScenes_;
    std::uint64_t pictures_ = 0;
};

// The value that half of them are below; 0 of none.
double median(std::vector<double> values);

}  // namespace fringe::preview
