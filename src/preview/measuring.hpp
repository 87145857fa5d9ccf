// Measures a line on a surface on the engine's device, piece by piece: the same picture of the line that
// `fringe profile` takes, by a pipeline that serves while the scene's knobs are turned.
#pragma once

#include <memory>

#include "preview/probe.hpp"
#include "render/progressive.hpp"

namespace fringe::preview {

class Measuring {
public:
    // Keeps a reference to the device.
    explicit Measuring(const gpu::Device& device) : progressive_(device) {}

    // Whether there is something to do for this wish and this scene.
    bool isDue(const Probe& probe, const std::shared_ptr<const scene::Scene>& scene) const {
        return probe.number != number_ || scene != scene_ || !isDone_;
    }

    // Takes it up, unless it is the one under way. Throws profile::LineError, scene::SceneError or
    // gpu::DeviceError.
    void begin(const Probe& probe, const std::shared_ptr<const scene::Scene>& scene,
               std::uint32_t samplesOfScene, const std::string& file);

    // Milliseconds that the last beginning took.
    double begin_ms() const { return begin_ms_; }

    // Works on it for about 30 ms. Returns the share that is done, 1 in the end. Throws gpu::DeviceError.
    double advance();

    // What has been measured, once. Precondition: advance() has returned 1.
    Measured take();

    // Nothing is to be done for what begin() was called with last: it cannot be measured.
    void giveUp() { isDone_ = true; }

private:
    render::Progressive progressive_;
    std::uint64_t number_ = 0;
    std::shared_ptr<const scene::Scene> scene_;
    bool isDone_ = true;
    bool isUnderWay_ = false;
    double begin_ms_ = 0.0;
    std::uint32_t samples_ = 1;  // of each place on the line
    std::shared_ptr<profile::Report> report_;
};

}  // namespace fringe::preview
