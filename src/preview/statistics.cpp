#include "preview/statistics.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace fringe::preview {
namespace {

// A longer pause between two pictures of a moving camera means that it rested.
constexpr double kPause_ms = 250.0;

double milliseconds(Statistics::Clock::duration time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

}  // namespace

void Statistics::wished(std::uint64_t number, Cause cause) {
    open_[number] = {Clock::now(), cause};
}

void Statistics::shown(const Picture& picture) {
    const Clock::time_point now = Clock::now();
    if (++pictures_ == 1) {
        firstPicture_ = milliseconds(now - start_);
        firstScene_ = picture.timing.scene;
    }
    // Wishes that a later one has replaced end with it: the time counts from the wish that is shown.
    const auto made = open_.find(picture.wish);
    if (made == open_.end()) return;
    const double latency = milliseconds(now - made->second.at);
    if (made->second.cause == Cause::knob) {
        knobLatencies_.push_back(latency);
        knobScenes_.push_back(picture.timing.scene);
    }
    if (made->second.cause == Cause::camera) {
        cameraLatencies_.push_back(latency);
        const double interval = milliseconds(now - lastCameraPicture_);
        if (interval < kPause_ms) cameraIntervals_.push_back(interval);
        lastCameraPicture_ = now;
    }
    open_.erase(open_.begin(), std::next(made));
}

float Statistics::picturesPerSecond() const {
    constexpr std::ptrdiff_t kLast = 15;
    const auto count = std::min<std::ptrdiff_t>(kLast, std::ssize(cameraIntervals_));
    if (count == 0) return 0.0F;
    const double sum = std::accumulate(cameraIntervals_.end() - count, cameraIntervals_.end(), 0.0);
    return static_cast<float>(1e3 * static_cast<double>(count) / sum);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace fringe::preview
