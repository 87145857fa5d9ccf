#include "qualify/bench_skip.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>

#include "gpu/constant_block.hpp"
#include "gpu/frozen_constants.hpp"
#include "qualify/live_code.hpp"
#include "qualify/skip_features.hpp"
#include "render/variant.hpp"

namespace fringe::qualify {
namespace {

constexpr std::string_view kSmallest = "smallest shader", kEverything = "everything";

// The same picture, but for what the pipeline's test allows too (tests/render/pipelines_test.cpp): a compiler
// may arrange sums otherwise, and a rounding decides what a pixel on a silhouette shows.
constexpr double kMostUnlike = 1e-3;

// Compiling takes long and varies little.
constexpr int kMostCompilations = 3;
constexpr double kCompiling = 0.7;  // its share of the work, about

// The SPIR-V as render::Renderer makes it; gpu::Kernel then leaves out what is dead.
std::vector<std::uint32_t> moduleOf(const BenchFrame& frame) {
    const device::SceneBlock block = compile::sceneBlock(frame.compiled());
    std::array<std::uint32_t, device::kSpecialisationCount> constants{};
    std::memcpy(constants.data(), &frame.constants(), sizeof frame.constants());
    return gpu::withFrozenConstants(
        gpu::withConstantBlock(render::embeddedShader(render::variantFor(frame.compiled())),
                               std::as_bytes(std::span(&block, 1))),
        constants);
}

const SkipFeature& featureOf(std::string_view name) {
    const auto& all = skipFeatures();
    return *std::find_if(all.begin(), all.end(), [&](const SkipFeature& f) { return f.name == name; });
}

struct Pipeline {
    std::string_view name;
    std::string_view without;
    std::string text;  // of its scene
    std::unique_ptr<BenchFrame> frame = {};
    PictureError error = {};
    bool verified = true;
    std::vector<double> frame_ms = {}, compile_ms = {};
};

Pipeline pipelineOf(std::string_view name) {
    if (name == kSmallest) return {name, {}, emptyScene().text()};
    SceneParts scene = roomScene();
    if (name == kRoom) return {name, {}, scene.text()};
    if (name == kEverything) {
        for (const SkipFeature& feature : skipFeatures()) add(feature, scene);
        return {name, kRoom, scene.text()};
    }
    const SkipFeature& feature = featureOf(name);
    if (feature.without != kRoom) add(featureOf(feature.without), scene);
    add(feature, scene);
    return {name, feature.without, scene.text()};
}

// The names that were asked for, with what they are compared with, in the order of skipCases().
std::vector<std::string_view> withTheirOthers(std::span<const std::string> names) {
    std::set<std::string_view> wanted{kSmallest, kRoom};
    for (const std::string_view name : skipCases()) {
        if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
        wanted.insert(name);
        if (name != kSmallest && name != kRoom && name != kEverything) wanted.insert(featureOf(name).without);
    }
    std::vector<std::string_view> result = skipCases();
    std::erase_if(result, [&](std::string_view name) { return wanted.count(name) == 0; });
    return result;
}

class Run {
public:
    Run(const gpu::Device& device, std::span<const std::string> names, const BenchControl& control)
        : device_(device), control_(control) {
        for (const std::string_view name : withTheirOthers(names)) pipelines_.push_back(pipelineOf(name));
    }

    std::vector<SkipRow> run() {
        compileAll();
        verifyAll();
        timeFrames();
        std::vector<SkipRow> rows;
        if (!control_.cancelled)
            for (const Pipeline& pipeline : pipelines_) rows.push_back(rowOf(pipeline));
        return rows;
    }

private:
    // The last of each pipeline's compilations is the one that renders.
    void compileAll() {
        const int compilations = std::min(control_.rounds, kMostCompilations);
        for (int round = 0; round < compilations; ++round) {
            for (Pipeline& pipeline : pipelines_) {
                if (control_.cancelled) return;
                pipeline.frame =
                    std::make_unique<BenchFrame>(device_, pipeline.text, BenchFrame::Gratings::everywhere);
                pipeline.compile_ms.push_back(pipeline.frame->compile_ms());
            }
            control_.onProgress(kCompiling * (round + 1) / compilations);
        }
    }

    // All but the smallest shader show the room; that one shows nothing.
    void verifyAll() {
        image::Image room;
        for (Pipeline& pipeline : pipelines_) {
            if (control_.cancelled) return;
            const image::Image picture = pipeline.frame->render(control_.cancelled);
            if (control_.cancelled) return;
            if (pipeline.name == kSmallest) continue;
            if (pipeline.name == kRoom) room = picture;
            pipeline.error = pictureError(picture, room);
            pipeline.verified = pipeline.error.wrong <= kMostUnlike;
        }
    }

    void timeFrames() {
        for (int round = 0; round < control_.rounds; ++round) {
            for (Pipeline& pipeline : pipelines_) {
                if (control_.cancelled) return;
                if (pipeline.verified)
                    pipeline.frame_ms.push_back(pipeline.frame->dispatch_ms(control_.cancelled));
            }
            control_.onProgress(kCompiling + (1.0 - kCompiling) * (round + 1) / control_.rounds);
        }
    }

    SkipRow rowOf(const Pipeline& pipeline) const {
        SkipRow row{.feature = std::string(pipeline.name),
                    .without = std::string(pipeline.without),
                    .error = pipeline.error,
                    .verified = pipeline.verified,
                    .cost = {},
                    .frameRatio = {},
                    .compileRatio = {}};
        const std::vector<std::uint32_t> module = moduleOf(*pipeline.frame);
        row.cost.moduleBytes = module.size() * sizeof(std::uint32_t);
        row.cost.liveBytes = liveCodeBytes(module);
        row.cost.compile_ms = spreadOf(pipeline.compile_ms);
        if (pipeline.verified) row.cost.frame_ms = spreadOf(pipeline.frame_ms);
        const auto other = std::find_if(pipelines_.begin(), pipelines_.end(),
                                        [&](const Pipeline& p) { return p.name == pipeline.without; });
        if (other != pipelines_.end()) {
            row.compileRatio = ratioOf(pipeline.compile_ms, other->compile_ms);
            if (pipeline.verified && other->verified)
                row.frameRatio = ratioOf(pipeline.frame_ms, other->frame_ms);
        }
        return row;
    }

    const gpu::Device& device_;
    const BenchControl& control_;
    std::vector<Pipeline> pipelines_;
};

}  // namespace

std::vector<std::string_view> skipCases() {
    std::vector<std::string_view> names{kSmallest, kRoom};
    for (const SkipFeature& feature : skipFeatures()) names.push_back(feature.name);
    names.push_back(kEverything);
    return names;
}

std::vector<SkipRow> benchSkip(const gpu::Device& device, std::span<const std::string> names,
                               const BenchControl& control) {
    return Run(device, names, control).run();
}

}  // namespace fringe::qualify
