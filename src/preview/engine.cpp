#include "preview/engine.hpp"

#include <chrono>

#include "preview/measuring.hpp"
#include "preview/rendering.hpp"

namespace fringe::preview {
namespace {

using Clock = std::chrono::steady_clock;

// While nothing moves, new samples are shown this often: developing and drawing take time from rendering.
constexpr std::chrono::milliseconds kResting(100);

// While something moves, measurements that take longer to begin wait until it rests.
constexpr double kLive_ms = 25.0;

}  // namespace

Engine::Engine(gpu::DeviceRequest request, const std::filesystem::path& shaders)
    : request_(std::move(request)),
      shaders_(shaders.empty() ? nullptr : std::make_unique<LiveShaders>(shaders)),
      thread_([this] { run(); }) {}

Engine::~Engine() {
    close();
}

void Engine::close() {
    {
        const std::scoped_lock lock(mutex_);
        isEnding_ = true;
    }
    changed_.notify_one();
    if (thread_.joinable()) thread_.join();
}

void Engine::wish(Wish wish) {
    {
        const std::scoped_lock lock(mutex_);
        wish_ = std::move(wish);
    }
    changed_.notify_one();
}

std::optional<Picture> Engine::takePicture() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(picture_, std::nullopt);
}

void Engine::measure(const std::optional<Probe>& probe) {
    {
        const std::scoped_lock lock(mutex_);
        probe_ = probe;
        isNewProbe_ = probe.has_value();
        measured_.reset();
    }
    changed_.notify_one();
}

std::optional<Measured> Engine::takeMeasured() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(measured_, std::nullopt);
}

State Engine::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

template <class Change>
void Engine::report(Change change) {
    {
        const std::scoped_lock lock(mutex_);
        change(state_);
    }
    ++news_;
}

// The latest wish, once it is another than the one of that number or there is something new to measure;
// nothing at the end.
std::optional<Wish> Engine::waitForWish(std::uint64_t known) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return isEnding_ || (wish_ && (wish_->number != known || isNewProbe_)); });
    return isEnding_ ? std::nullopt : wish_;
}

std::optional<Wish> Engine::latestWish() const {
    const std::scoped_lock lock(mutex_);
    return isEnding_ ? std::nullopt : wish_;
}

// After a failure of the device, the next wish is tried on a device opened anew.
void Engine::run() {
    std::uint64_t known = 0;
    while (waitForWish(known)) {
        try {
            const gpu::Device device(request_);
            report([&](State& state) {
                state.device = device.description().name;
                state.driver = device.description().driver;
            });
            const auto keepMessages = [&] {
                const auto said = device.validationMessages();
                validation_.insert(validation_.end(), said.begin(), said.end());
            };
            try {
                serve(device);
            } catch (...) {
                keepMessages();
                throw;
            }
            keepMessages();
            return;
        } catch (const std::exception& error) {
            const std::scoped_lock lock(mutex_);
            known = wish_ ? wish_->number : 0;
            // Pictures go on without the measurement, in case it is the cause.
            isNewProbe_ = false;
            if (probe_) measured_ = Measured{probe_->number, nullptr, nullptr, error.what()};
            probe_.reset();
            state_.error = error.what();
            if (dynamic_cast<const gpu::DeviceLost*>(&error) != nullptr) ++state_.losses;
            state_.activity.clear();
        }
        ++news_;
    }
}

void Engine::serve(const gpu::Device& device) {
    Rendering rendering(device, shaders_.get());
    Measuring measuring(device);
    std::uint64_t known = 0;
    while (const auto wish = waitForWish(known)) {
        if (wish->number != known) fulfil(*wish, rendering, measuring);
        known = wish->number;
        measureFor(*wish, rendering, measuring);
    }
}

// Until there is another wish, or nothing left to do for this one.
void Engine::fulfil(const Wish& wish, Rendering& rendering, Measuring& measuring) {
    if (rendering.isNewScene(wish)) {
        report([](State& state) { state.activity = "compiling the scene"; });
        std::string error;
        try {
            rendering.load(wish);
        } catch (const scene::SceneError& problems) {
            error = problems.what();
        }
        report([&](State& state) {
            state.activity.clear();
            state.error = error;
            state.specialisation = rendering.specialisation();
        });
    }
    if (!rendering.hasScene()) return;
    if (rendering.hasNewShaders(wish)) report([](State& state) { state.activity = "compiling the shaders"; });
    rendering.follow(wish);
    report([&](State& state) {
        state.activity.clear();
        state.shaderError = rendering.shaderError();
    });

    bool isShown = false;  // something of this wish
    bool wasFull = false;
    Clock::time_point last;
    const auto show = [&] {
        publish(rendering.develop(), rendering);
        isShown = true;
        wasFull = rendering.isFull();
        last = Clock::now();
    };
    if (rendering.hasSamples()) show();  // the exposure may be another
    while (!rendering.isComplete()) {
        const auto latest = latestWish();
        // A moving picture is finished even when the next is wished for, or none would ever be.
        if (!latest || (latest->number != wish.number && (isShown || !wish.isMoving))) return;
        const bool isBetter = rendering.advance();
        const bool isDue = !isShown || wasFull != rendering.isFull() || rendering.isComplete() ||
                           Clock::now() - last > kResting;
        if (isBetter && isDue) show();
        if (isShown && rendering.isFull()) measureFor(wish, rendering, measuring);
    }
}

// Works on what is to be measured, in the scene of this wish, until it is done or there is another wish.
void Engine::measureFor(const Wish& wish, const Rendering& rendering, Measuring& measuring) {
    std::optional<Probe> probe;
    {
        const std::scoped_lock lock(mutex_);
        probe = probe_;
        isNewProbe_ = false;
    }
    if (wish.isMoving && measuring.begin_ms() > kLive_ms) return;
    if (!probe || !rendering.hasScene() || !measuring.isDue(*probe, rendering.scene())) return;
    const auto answer = [&](Measured measured) {
        report([&](State& state) { state.measuring.reset(); });
        {
            const std::scoped_lock lock(mutex_);
            if (probe_ && probe_->number == measured.probe) measured_ = std::move(measured);
        }
        ++news_;
    };
    const auto isWanted = [&] {
        const std::scoped_lock lock(mutex_);
        return !isEnding_ && wish_->number == wish.number && probe_ && probe_->number == probe->number;
    };
    try {
        report([](State& state) { state.measuring = 0.0; });
        measuring.begin(*probe, rendering.scene(), rendering.samplesOfScene(), wish.source->file);
        while (isWanted()) {
            const double done = measuring.advance();
            report([&](State& state) { state.measuring = done; });
            if (done >= 1.0) return answer(measuring.take());
        }
        report([&](State& state) { state.measuring.reset(); });
    } catch (const profile::LineError& error) {
        measuring.giveUp();
        answer({probe->number, rendering.scene(), nullptr, error.what()});
    }
}

void Engine::publish(Picture picture, const Rendering& rendering) {
    {
        const std::scoped_lock lock(mutex_);
        picture_ = std::move(picture);
        state_.timing = rendering.timing();
    }
    ++news_;
}

}  // namespace fringe::preview
