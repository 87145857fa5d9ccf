#include "qualify/bench_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "qualify/bench_scenes.hpp"

namespace fringe::qualify {
namespace {

constexpr std::array<FrameCase, 7> kCases{{
    {"samples",
     "samples of a pixel, judged by a frame of 2048 of another seed, and that by the reference renderer"},
    {"tile", "edge of a tile in pixels, judged by the frame in one piece"},
    {"size", "edge of the picture in pixels, judged by the reference renderer; ratio per pixel"},
    {"gratings", "gratings that light the scene, judged by the reference renderer"},
    {"hidden-gratings", "gratings behind the camera, judged by the frame without them"},
    {"spheres", "spheres over a floor, judged by the reference renderer"},
    {"model", "five gratings, judged by the reference renderer"},
}};

// Pixels that differ by more than 1 % of the peak are on silhouettes, where a rounding decides what a pixel
// shows, and some at the edges of beams, whose mean over a pixel the device works out and the reference
// renderer samples. Together they are less than 2 % of a picture; what a wrong formula spoils is more.
constexpr double kMostWrong = 0.02;

// So many pixels along either side are judged by the reference renderer.
constexpr std::uint32_t kJudged = 24;

// Its samples of a pixel. The device takes one in the middle: of silhouettes, and of all that is larger than
// a pixel, that is the same; the mean over a pixel, with Fresnel's ripples at the edge of a beam, takes more.
constexpr std::uint32_t kMiddle = 1, kMean = 8, kConverged = 64;

// One setting of a case.
struct Setting {
    std::string name;
    std::unique_ptr<BenchFrame> frame;
    std::uint32_t tile = 0;
    double pixels = 1.0;  // that its time is divided by for the ratio
    PictureError error = {};
    bool verified = true;
    std::vector<double> times_ms = {};
};

class Case {
public:
    Case(const gpu::Device& device, std::string_view name, const BenchControl& control)
        : device_(device), name_(name), control_(control) {}

    std::vector<FrameRow> run() {
        if (name_ == "samples") addSamples();
        else if (name_ == "tile") addTiles();
        else if (name_ == "size") addSizes();
        else if (name_ == "gratings") addGratings();
        else if (name_ == "hidden-gratings") addHiddenGratings();
        else if (name_ == "spheres") addSpheres();
        else addModels();
        measure();
        return control_.cancelled ? std::vector<FrameRow>() : rows();
    }

private:
    // ---- the settings, each verified --------------------------------------------------------------

    void addSamples() {
        SceneParts scene = softScene();
        scene.samples = 2048;
        // Another seed: else the samples judged would be among those that they are judged by.
        std::string text = scene.text();
        text.replace(text.find("\"samples\""), 0, "\"seed\": 77, ");
        const image::Image converged = BenchFrame(device_, text).render(control_.cancelled);
        if (control_.cancelled) return;
        const image::Image reference = thinnedReference(text, kJudged, kConverged, control_.cancelled);
        if (control_.cancelled) return;
        const bool isRight = pictureError(thinned(converged, kJudged), reference).wrong <= kMostWrong;
        for (const std::uint32_t samples : {1U, 4U, 16U, 64U, 256U}) {
            scene.samples = samples;
            if (Setting* setting = add(fmt::to_string(samples), scene)) {
                judge(*setting, setting->frame->render(control_.cancelled), converged);
                setting->verified = isRight;  // its own error is noise, and what is to be shown
            }
        }
    }

    void addTiles() {
        const SceneParts scene = fiveGratingsScene(GratingModel::physical);
        image::Image whole;
        for (const std::uint32_t tile : {0U, 512U, 256U, 128U, 64U, 32U}) {
            Setting* setting = add(tile == 0 ? "fitted" : fmt::to_string(tile), scene);
            if (setting == nullptr) return;
            setting->tile = tile;
            const image::Image picture = setting->frame->render(control_.cancelled, tile);
            if (tile == 0) whole = picture;
            judge(*setting, picture, whole);
            setting->verified = setting->error.largest == 0.0;  // promised: the same pixels
        }
    }

    void addSizes() {
        SceneParts scene = fiveGratingsScene(GratingModel::physical);
        for (const std::uint32_t size : {600U, 150U, 300U, 1200U, 2400U}) {
            scene.size = size;
            if (Setting* setting = add(fmt::to_string(size), scene)) {
                setting->pixels = double{1.0} * size * size;
                judgeByReference(*setting, scene, kMean);
            }
        }
    }

    void addGratings() {
        for (const std::uint32_t count : {1U, 10U, 100U, 1000U}) {
            const SceneParts scene = manyGratingsScene(count, false);
            if (Setting* setting = add(fmt::to_string(count), scene))
                judgeByReference(*setting, scene, kMiddle);
        }
    }

    void addHiddenGratings() {
        image::Image without;
        for (const std::uint32_t count : {0U, 1U, 10U, 100U, 1000U}) {
            Setting* setting = add(fmt::to_string(count), manyGratingsScene(count, true));
            if (setting == nullptr) return;
            const image::Image picture = setting->frame->render(control_.cancelled);
            if (count == 0) without = picture;
            judge(*setting, picture, without);
        }
    }

    void addSpheres() {
        for (const std::uint32_t count : {10U, 16U, 17U, 100U, 1'000U, 10'000U, 100'000U}) {
            const SceneParts scene = spheresScene(count);
            if (Setting* setting = add(fmt::to_string(count), scene))
                judgeByReference(*setting, scene, kMiddle);
        }
    }

    void addModels() {
        const SceneParts thesis = fiveGratingsScene(GratingModel::thesis),
                         physical = fiveGratingsScene(GratingModel::physical);
        if (Setting* setting = add("thesis", thesis)) judgeByReference(*setting, thesis, kMiddle);
        if (Setting* setting = add("physical, D65", physical)) judgeByReference(*setting, physical, kMean);
    }

    // Null when it was cancelled.
    Setting* add(std::string name, const SceneParts& scene) {
        if (control_.cancelled) return nullptr;
        return &settings_.emplace_back(
            Setting{std::move(name), std::make_unique<BenchFrame>(device_, scene.text())});
    }

    void judge(Setting& setting, const image::Image& picture, const image::Image& reference) const {
        if (control_.cancelled) return;
        setting.error = pictureError(picture, reference);
        setting.verified = setting.error.wrong <= kMostWrong;
    }

    void judgeByReference(Setting& setting, const SceneParts& scene, std::uint32_t samples) const {
        const image::Image picture = setting.frame->render(control_.cancelled);
        if (control_.cancelled) return;
        judge(setting, thinned(picture, kJudged),
              thinnedReference(scene.text(), kJudged, samples, control_.cancelled));
    }

    // ---- the clock --------------------------------------------------------------------------------

    // Round 0 warms up and is not counted.
    void measure() {
        for (int round = 0; round <= control_.rounds; ++round) {
            for (Setting& setting : settings_) {
                if (control_.cancelled) return;
                if (!setting.verified) continue;
                const double time = setting.frame->dispatch_ms(control_.cancelled, setting.tile);
                if (round > 0) setting.times_ms.push_back(time);
            }
            control_.onProgress((round + 1.0) / (control_.rounds + 1.0));
        }
    }

    std::vector<FrameRow> rows() const {
        std::vector<FrameRow> rows;
        for (const Setting& setting : settings_) {
            FrameRow row{.caseName = std::string(name_),
                         .setting = setting.name,
                         .error = setting.error,
                         .verified = setting.verified,
                         .dispatch_ms = {},
                         .compile_ms = setting.frame->compile_ms(),
                         .ratio = {}};
            if (!setting.times_ms.empty()) row.dispatch_ms = spreadOf(setting.times_ms);
            const Setting& first = settings_.front();
            if (setting.times_ms.size() == first.times_ms.size() && !first.times_ms.empty()) {
                row.ratio = ratioOf(setting.times_ms, first.times_ms);
                row.ratio.median *= first.pixels / setting.pixels;
                row.ratio.half *= first.pixels / setting.pixels;
            }
            rows.push_back(std::move(row));
        }
        return rows;
    }

    const gpu::Device& device_;
    std::string_view name_;
    const BenchControl& control_;
    std::vector<Setting> settings_;
};

}  // namespace

std::span<const FrameCase> frameCases() {
    return kCases;
}

std::vector<FrameRow> benchFrames(const gpu::Device& device, std::string_view caseName,
                                  const BenchControl& control) {
    assert(std::any_of(kCases.begin(), kCases.end(), [&](const FrameCase& c) { return c.name == caseName; }));
    return Case(device, caseName, control).run();
}

}  // namespace fringe::qualify
