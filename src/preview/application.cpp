#include "preview/application.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>

#include "image/pending_file.hpp"
#include "preview/document.hpp"
#include "preview/engine.hpp"
#include "preview/files.hpp"
#include "preview/instrument_panel.hpp"
#include "preview/navigation.hpp"
#include "preview/panel.hpp"
#include "preview/presenter.hpp"
#include "preview/widgets.hpp"
#include "preview/window.hpp"

namespace fringe::preview {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLowestWindow = 480;    // so that the panel has room beside a small picture
constexpr float kBackground = 0.11F;  // around the picture
constexpr double kIdle_s = 0.25;      // without any event, to look whether to end
constexpr double kGlance_s = 0.004;   // between two looks whether the engine has news
constexpr int kFramesToSettle = 2;
constexpr double kMoving_s = 0.02;               // likewise, to look whether it rests
constexpr std::chrono::milliseconds kRest(150);  // without a change, and it counts as resting
constexpr std::chrono::minutes kLosses(1);       // between two of a device, or the second is the last

// The largest place for a picture of this shape, in the middle of what the panels leave of the window; whole
// multiples are not asked for.
Rectangle placeFor(const scene::Image& image, Extent window, int panel, int right) {
    const int width = std::max(window.width - panel - right, 1), height = std::max(window.height, 1);
    const double scale = std::min(1.0 * width / image.width, 1.0 * height / image.height);
    const int shownWidth = std::clamp(static_cast<int>(std::lround(scale * image.width)), 1, width);
    const int shownHeight = std::clamp(static_cast<int>(std::lround(scale * image.height)), 1, height);
    return {panel + (width - shownWidth) / 2, (height - shownHeight) / 2,
            static_cast<std::uint32_t>(shownWidth), static_cast<std::uint32_t>(shownHeight)};
}

class Application {
public:
    Application(const Options& options, Clock::time_point start)
        : request_(options.device),
          engine_(options.device, options.shaders),
          document_(options.source),
          watch_(options.source.file),
          shaderWatch_(options.shaders),
          scene_(scene::parseScene(options.source.text, options.source.file, options.source.overrides)) {
        statistics_.began(start);
        settings_.samples = options.samples;
        sendWish(Statistics::Cause::other);  // the engine begins while the window opens
    }

    Outcome run(const Desktop& desktop, const std::atomic<bool>& interrupted) {
        const auto wanted = [](std::uint32_t side) { return static_cast<int>(std::min(side, 16384U)); };
        Window window(desktop,
                      {wanted(scene_.image.width) + panelWidth(settings_, 1.0F),
                       std::max(wanted(scene_.image.height), kLowestWindow)},
                      "Fringe");
        const Widgets widgets(window);
        gpu::DeviceRequest request = request_;
        request.surfaceExtensions = desktop.surfaceExtensions();
        std::vector<std::string> messages;
        const auto present = [&] {
            Presenter presenter(window, widgets, request);
            window.show();  // now that it can answer
            if (picture_) presenter.setPicture(picture_->width, picture_->height, picture_->rgba);
            try {
                while (!window.wantsToClose() && !interrupted) frame(window, widgets, presenter);
            } catch (const gpu::DeviceLost& error) {
                heedLoss(error.what());
            }
            const auto said = presenter.device().validationMessages();
            messages.insert(messages.end(), said.begin(), said.end());
        };
        try {
            while (!window.wantsToClose() && !interrupted) present();
        } catch (const gpu::DeviceError& error) {
            throw gpu::DeviceError(error.what() + rescued());
        }
        window.hide();  // what the engine is at may take some seconds
        engine_.close();
        const auto said = engine_.validationMessages();
        messages.insert(messages.begin(), said.begin(), said.end());
        return {statistics_, std::move(messages)};
    }

private:
    // A device was lost, the renderer's or the window's: another is opened, but not again and again.
    void heedLoss(const std::string& message) {
        const Clock::time_point now = Clock::now();
        if (lastLoss_ && now - *lastLoss_ < kLosses)
            throw gpu::DeviceError(message + "; it is the second loss in a row");
        lastLoss_ = now;
        notice_ = message.substr(0, message.find(';')) + "; everything was started again";
    }

    // Writes the scene as the user has changed it, and tells so or why not; nothing if it has not been
    // changed.
    std::string rescued() const {
        if (!document_.isChanged() && !camera_) return {};
        const std::filesystem::path file = editedFile(*document_.source());
        try {
            preview::saveScene(file, sceneText(document_, camera_));
        } catch (const image::FileError& error) {
            return fmt::format("; the changed scene could not be saved: {}", error.what());
        }
        return fmt::format("; the changed scene is in {}", file.string());
    }

    void frame(Window& window, const Widgets& widgets, Presenter& presenter) {
        // Widgets settle in the frame after the one that an event changed.
        if (waitForChange() || isFlying(window)) framesDue_ = kFramesToSettle;
        else if (framesDue_ > 0) --framesDue_;
        const Clock::time_point begin = Clock::now();
        news_ = engine_.news();
        if (const State state = engine_.state(); state.losses != losses_) {
            losses_ = state.losses;
            heedLoss(state.error);
            sendWish(Statistics::Cause::other);
        }
        takePicture(presenter);
        const std::vector<KeyPress> keys = window.takeKeys();
        presenter.beginWidgets();
        widgets.begin();
        const Rectangle place = placeFor(scene_.image, window.pixels(), panelWidth(settings_, window.scale()),
                                         instrumentWidth(instrument_, window.scale()));
        useInstrument(place);
        navigate(window, place, keys);
        const State state = engine_.state();
        const Facts facts{state, picture_ ? &*picture_ : nullptr, statistics_.picturesPerSecond(), notice_,
                          watch_.problem()};
        PanelActions actions = drawPanel(settings_, document_, facts, window.scale());
        const bool isWritten = drawInstrument(instrument_, state, scene_, camera_.value_or(scene_.camera),
                                              place, window.scale());
        if (isWritten) writeMeasured();
        obey(window, keys, actions);
        if (actions.display || actions.scene) moved(Statistics::Cause::knob);
        if (actions.saveScene) saveScene();
        if (actions.savePicture) savePicture();
        lookAtFiles();
        widgets.end();
        if (isMoving_ && Clock::now() - lastMove_ > kRest) {
            isMoving_ = false;
            sendWish(Statistics::Cause::other);
        }
        const bool isDrawn = presenter.draw(place, kBackground, ImGui::GetDrawData());
        if (isDrawn && isNew_) statistics_.shown(*picture_);
        if (isDrawn) isNew_ = false;
        window.setTitle(title());
        statistics_.busyFor(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    }

    // Until the user does something, which is true, or the engine has news, or it is time to look around.
    bool waitForChange() {
        const bool isResting = picture_ && picture_->isComplete && picture_->wish == wishes_;
        const double patience_s = framesDue_ > 0 ? 0.0 : isMoving_ ? kMoving_s : kIdle_s;
        // The engine's thread calls no function of the window system, which would not stand that everywhere.
        const double glance_s = isResting ? patience_s : std::min(kGlance_s, patience_s);
        const Clock::time_point start = Clock::now();
        const auto since = [](Clock::time_point time) {
            return std::chrono::duration<double>(Clock::now() - time).count();
        };
        do {
            const Clock::time_point glance = Clock::now();
            waitForEvents(glance_s);
            if (since(glance) < 0.9 * glance_s) return true;
        } while (engine_.news() == news_ && since(start) < patience_s);
        return false;
    }

    void navigate(const Window& window, const Rectangle& place, std::span<const KeyPress> keys) {
        const scene::Camera camera = camera_.value_or(scene_.camera);
        const auto next = navigated(camera, scene_, place, window, keys, !instrument_.isOn());
        if (!next) return;
        camera_ = *next;
        ++cameraNumber_;
        moved(Statistics::Cause::camera);
    }

    void useInstrument(const Rectangle& place) {
        if (auto measured = engine_.takeMeasured()) {
            instrument_.take(std::move(*measured));
            framesDue_ = kFramesToSettle;  // its tables take the widths of what they hold
        }
        instrument_.lookAtClosedForm();
        if (instrument_.followMouse(scene_, camera_.value_or(scene_.camera), place))
            engine_.measure(instrument_.probe());
    }

    // Beside the picture, which keeps its size where the desktop has room.
    void toggleInstrument(Window& window) {
        const int before = instrumentWidth(instrument_, window.scale());
        instrument_.toggle();
        const int added = instrumentWidth(instrument_, window.scale()) - before;
        window.grow(added, added > 0 ? instrumentHeight(window.scale()) : 0);
        engine_.measure(std::nullopt);
    }

    void writeMeasured() {
        const auto exported = instrument_.exported();
        if (!exported) {
            notice_ = "nothing has been measured; I turns the instrument on";
            return;
        }
        const auto& files = exported->files;
        inBackground(
            fmt::format("written: {}, {} and {}", files[0].string(), files[1].string(), files[2].string()),
            [exported = *exported] {
                for (const auto& file : exported.files) profile::writeReport(file, *exported.report);
            });
    }

    // Runs `work` beside the window, and tells `done` or what went wrong.
    template <class Work>
    void inBackground(const std::string& done, Work work) {
        saving_ = std::async(std::launch::async, [done, work]() -> std::string {
            try {
                work();
                return done;
            } catch (const std::exception& error) {
                return error.what();
            }
        });
    }

    void saveScene() {
        const std::filesystem::path file = editedFile(*document_.source());
        inBackground(fmt::format("written: {}", file.string()),
                     [file, text = sceneText(document_, camera_)] { preview::saveScene(file, text); });
    }

    void savePicture() {
        if (!picture_ || !picture_->film) {
            notice_ = showsWavelength(settings_.display.view)
                          ? "a view of one wavelength is not saved; choose another view"
                          : "the picture is still coarse; save it when it rests";
            return;
        }
        const auto png = pictureFile(*picture_->source, ".png"), exr = pictureFile(*picture_->source, ".exr");
        inBackground(fmt::format("written: {} and {}", png.string(), exr.string()),
                     [png, exr, picture = *picture_, text = sceneText(document_, camera_)] {
                         preview::savePicture(png, exr, picture, text);
                     });
    }

    // What was to be written is, and the scene file may have been.
    void lookAtFiles() {
        if (saving_.valid() && saving_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
            notice_ = saving_.get();
        if (shaderWatch_.hasChanged()) {
            ++shaders_;
            sendWish(Statistics::Cause::other);
        }
        const auto text = watch_.changedText();
        if (!text) return;
        const Json::Value before = document_.root()["camera"];
        document_.reload(*text);
        notice_.clear();
        if (document_.root()["camera"] != before) {
            camera_.reset();
            ++cameraNumber_;
        }
        sendWish(Statistics::Cause::other);
    }

    void obey(Window& window, std::span<const KeyPress> keys, PanelActions& actions) {
        for (const KeyPress& press : keys) {
            if (press.control && (press.key == GLFW_KEY_Q || press.key == GLFW_KEY_W)) window.close();
            if (press.control && press.key == GLFW_KEY_S) actions.saveScene = true;
            if (ImGui::GetIO().WantTextInput || press.control) continue;
            if (press.key == GLFW_KEY_I) toggleInstrument(window);
            if (press.key == GLFW_KEY_X) writeMeasured();
            if (press.key == GLFW_KEY_P) actions.savePicture = true;
            if (press.key == GLFW_KEY_TAB) settings_.showsPanel = !settings_.showsPanel;
            if (press.key == GLFW_KEY_F1 || (press.shift && press.key == GLFW_KEY_SLASH))
                settings_.showsKeys = !settings_.showsKeys;
        }
    }

    // Something is under way: until it rests, coarse pictures come quickly.
    void moved(Statistics::Cause cause) {
        notice_.clear();
        isMoving_ = true;
        lastMove_ = Clock::now();
        sendWish(cause);
    }

    void takePicture(Presenter& presenter) {
        auto picture = engine_.takePicture();
        if (!picture) return;
        presenter.setPicture(picture->width, picture->height, picture->rgba);
        scene_ = *picture->scene;
        picture_ = std::move(picture);
        isNew_ = true;
    }

    void sendWish(Statistics::Cause cause) {
        ++wishes_;
        Switches switches = settings_.switches;
        if (showsWavelength(settings_.display.view)) switches.wavelength_nm = settings_.wavelength_nm;
        statistics_.wished(wishes_, cause);
        engine_.wish({.number = wishes_,
                      .source = document_.source(),
                      .switches = std::move(switches),
                      .shaders = shaders_,
                      .cameraNumber = cameraNumber_,
                      .camera = camera_,
                      .display = settings_.display,
                      .samples = settings_.samples,
                      .isMoving = isMoving_});
    }

    std::string title() const {
        const std::string name = std::filesystem::path(document_.source()->file).filename().string();
        if (!picture_) return fmt::format("{} - Fringe", name);
        return fmt::format("{} - {} of {} samples{} - Fringe", name, picture_->samples, settings_.samples,
                           picture_->isComplete && picture_->wish == wishes_ ? ", complete" : "");
    }

    gpu::DeviceRequest request_;
    Engine engine_;
    Document document_;
    FileWatch watch_;
    ShaderWatch shaderWatch_;
    std::uint64_t shaders_ = 1;  // goes up when they have changed
    Instrument instrument_;
    std::future<std::string> saving_;
    std::string notice_;
    scene::Scene scene_;  // on show
    Settings settings_;
    Statistics statistics_;
    std::uint64_t wishes_ = 0;
    std::uint64_t losses_ = 0;  // of the renderer's device, that have been heeded
    std::optional<Clock::time_point> lastLoss_;
    std::optional<scene::Camera> camera_;  // none: the scene's
    std::uint64_t cameraNumber_ = 0;
    bool isMoving_ = false;
    Clock::time_point lastMove_;
    std::optional<Picture> picture_;
    bool isNew_ = false;      // the picture has not been drawn yet
    std::uint64_t news_ = 0;  // of the engine, that has been looked at
    int framesDue_ = 0;
};

}  // namespace

Outcome run(const Options& options, const std::atomic<bool>& interrupted) {
    const auto start = Clock::now();
    const Desktop desktop;
    return Application(options, start).run(desktop, interrupted);
}

}  // namespace fringe::preview
