// How much work one dispatch gets: grown and shrunk so that a dispatch lasts about 50 ms on any device. Long
// enough that its overhead does not count, short enough for a cancellation within a second and for the
// watchdogs of GPUs with a display (about two seconds).
#pragma once

#include <algorithm>
#include <cstdint>

#include "compile/interface.hpp"

namespace fringe::render {

// Rounded up to whole workgroups.
inline std::uint32_t wholeGroups(std::uint32_t pixels) {
    return (pixels + device::GROUP_EDGE - 1) / device::GROUP_EDGE * device::GROUP_EDGE;
}

class Tiling {
public:
    // Width and height of the film are whole workgroups, and so is every tile. `fixedEdge` 0: adaptive.
    Tiling(std::uint32_t width, std::uint32_t height, std::uint32_t samples, std::uint32_t fixedEdge)
        : width_(width),
          height_(height),
          samples_(samples),
          adaptive_(fixedEdge == 0),
          tileWidth_(std::min(width, adaptive_ ? kFirstEdge : wholeGroups(fixedEdge))),
          tileHeight_(std::min(height, adaptive_ ? kFirstEdge : wholeGroups(fixedEdge))) {}

    std::uint32_t tileWidth() const { return tileWidth_; }
    std::uint32_t tileHeight() const { return tileHeight_; }
    std::uint32_t batch() const { return batch_; }  // samples of a pixel in one dispatch

    // Tells how long a full tile took. Sizes may change, so call it only where the next dispatch may start
    // afresh: between rows of tiles. First the tile grows to the whole width and height, then the batch.
    void learn(double milliseconds) {
        if (!adaptive_) return;
        if (milliseconds < kShort_ms) grow();
        if (milliseconds > kLong_ms) shrink();
    }

private:
    // A picture of 600 x 600 is one dispatch, of 70 ms on two cores; smaller first tiles cost half as much
    // again.
    static constexpr std::uint32_t kFirstEdge = 640;
    static constexpr std::uint32_t kSmallestEdge = 32;
    static constexpr double kShort_ms = 20.0;
    static constexpr double kLong_ms = 80.0;

    void grow() {
        if (tileWidth_ < width_) {
            tileWidth_ = std::min(width_, 2 * tileWidth_);
        } else if (tileHeight_ < height_) {
            tileHeight_ = std::min(height_, 2 * tileHeight_);
        } else {
            batch_ = std::min(samples_, 2 * batch_);
        }
    }

    void shrink() {
        if (batch_ > 1) {
            batch_ /= 2;
        } else if (tileHeight_ > kSmallestEdge) {
            tileHeight_ = wholeGroups(tileHeight_ / 2);
        } else {
            tileWidth_ = std::min(tileWidth_, std::max(kSmallestEdge, wholeGroups(tileWidth_ / 2)));
        }
    }

    std::uint32_t width_, height_, samples_;
    bool adaptive_;
    std::uint32_t tileWidth_, tileHeight_;
    std::uint32_t batch_ = 1;
};

}  // namespace fringe::render
