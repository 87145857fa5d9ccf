// The renderer behind a window, in a thread and on a device of its own: it is told what to show and answers
// with pictures. A scene is read and compiled, its tables included, in this thread; the last picture stays
// until there is one of the new scene.
#pragma once

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "gpu/device.hpp"
#include "preview/probe.hpp"
#include "preview/wish.hpp"

namespace fringe::preview {

class LiveShaders;
class Measuring;
class Rendering;

class Engine {
public:
    // With the shaders of a folder if one is named.
    Engine(gpu::DeviceRequest request, const std::filesystem::path& shaders);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    // Takes the place of the wish before.
    void wish(Wish wish);

    // The picture made since the last call, if there is one.
    std::optional<Picture> takePicture();

    // What is to be measured from now on, anew in every scene, in place of what was before; nothing: nothing.
    void measure(const std::optional<Probe>& probe);

    // What has been measured since the last call, if anything has.
    std::optional<Measured> takeMeasured();

    State state() const;

    // Another number after every new picture or state.
    std::uint64_t news() const { return news_; }

    // What the validation layer has said about its devices. Only for after close().
    const std::vector<std::string>& validationMessages() const { return validation_; }

    // Ends the work. Nothing but validationMessages() may be called afterwards.
    void close();

private:
    void run();
    void serve(const gpu::Device& device);
    void fulfil(const Wish& wish, Rendering& rendering, Measuring& measuring);
    void measureFor(const Wish& wish, const Rendering& rendering, Measuring& measuring);
    std::optional<Wish> waitForWish(std::uint64_t known);
    std::optional<Wish> latestWish() const;
    void publish(Picture picture, const Rendering& rendering);
    template <class Change>
    void report(Change change);

    gpu::DeviceRequest request_;
    std::unique_ptr<LiveShaders> shaders_;  // used by the thread alone; null: the program's own
    std::atomic<std::uint64_t> news_{0};
    std::vector<std::string> validation_;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Wish> wish_;
    std::optional<Picture> picture_;
    std::optional<Probe> probe_;
    std::optional<Measured> measured_;
    bool isNewProbe_ = false;
    State state_;
    bool isEnding_ = false;

    std::thread thread_;  // the last: it uses all the others
};

}  // namespace fringe::preview
