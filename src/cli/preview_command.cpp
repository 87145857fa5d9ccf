// fringe preview: a scene in a window.
#include <fmt/format.h>
#include <json/json.h>

#include <algorithm>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/device_choice.hpp"
#include "cli/input.hpp"
#include "cli/interrupt.hpp"
#include "cli/report.hpp"
#include "image/pending_file.hpp"
#include "preview/application.hpp"
#include "preview/shader_compiler.hpp"
#include "preview/window.hpp"

namespace fringe::cli {
namespace {

struct PreviewOptions {
    SceneSource source;
    std::string device;
    std::string stats;
    std::string shaders;
    std::uint32_t samples = 0;
};

constexpr std::uint32_t kSamples = 16;  // where neither the scene nor the command line wants more

Json::Value summary(const std::vector<double>& milliseconds) {
    Json::Value json;
    json["count"] = Json::UInt64{milliseconds.size()};
    json["median"] = preview::median(milliseconds);
    json["largest"] =
        milliseconds.empty() ? 0.0 : *std::max_element(milliseconds.begin(), milliseconds.end());
    return json;
}

Json::Value toJson(const preview::Statistics& statistics) {
    Json::Value json;
    json["first_picture_ms"] = statistics.firstPicture();
    json["pictures"] = Json::UInt64{statistics.pictures()};
    json["camera_interval_ms"] = summary(statistics.cameraIntervals());
    json["camera_latency_ms"] = summary(statistics.cameraLatencies());
    json["knob_latency_ms"] = summary(statistics.knobLatencies());
    json["first_scene_ms"] = statistics.firstScene();
    json["knob_scene_ms"] = summary(statistics.knobScenes());
    json["longest_busy_ms"] = statistics.longestBusy();
    return json;
}

void writeStats(const std::string& path, const preview::Statistics& statistics) {
    const std::string text = formatJson(toJson(statistics));
    image::PendingFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

// Throws InputError or NoWindow.
void checkShaders(const std::filesystem::path& folder) {
    if (!preview::canCompileShaders()) {
        throw NoWindow(
            "this program was built without --shaders; install the glslang library, on Debian: apt-get "
            "install "
            "glslang-dev; then configure and build again");
    }
    if (std::filesystem::is_regular_file(folder / preview::kMainShader)) return;
    throw InputError(fmt::format(
        "--shaders {}: there is no {}; give the folder shaders/ of Fringe's source, or a copy of it",
        folder.string(), preview::kMainShader));
}

int previewScene(const PreviewOptions& options) {
    catchInterrupts();
    if (!options.shaders.empty()) checkShaders(options.shaders);
    const std::string text = readTextFile(options.source.file);
    const scene::Scene scene = parseSource(options.source, text);
    if (!options.stats.empty()) const image::PendingFile probe(options.stats);
    const preview::Options what{
        .source = {text, options.source.file, overridesOf(options.source)},
        .device = deviceRequest(options.device),
        .samples = options.samples > 0 ? options.samples : std::max(scene.image.samples, kSamples),
        .shaders = options.shaders};
    try {
        const preview::Outcome outcome = preview::run(what, interrupted());
        if (!options.stats.empty()) writeStats(options.stats, outcome.statistics);
        if (!passedValidation(outcome.validationMessages)) return kMachineCannot;
    } catch (const preview::WindowError& error) {
        throw NoWindow(error.what());
    }
    return interrupted() ? interruptStatus() : kDone;
}

}  // namespace

void addPreview(CLI::App& app, Command& chosen) {
    CLI::App* command =
        app.add_subcommand("preview", "Show a scene in a window, look around in it and change it");
    const auto options = std::make_shared<PreviewOptions>();
    addSceneOptions(*command, options->source);
    command
        ->add_option("--samples", options->samples,
                     "of every pixel once nothing moves (default: the scene's, but at least 16)")
        ->check(CLI::Range(1, 65535));
    command->add_option("--device", options->device,
                        "Vulkan device that renders, by index or part of its name (see: fringe devices)");
    command->add_option("--shaders", options->shaders,
                        "a folder with the renderer's shaders, which are compiled again when one is saved");
    command->add_option("--stats", options->stats,
                        "at the end, write how quick it was to this JSON file, in milliseconds");
    command->callback([=, &chosen] { chosen = [=] { return previewScene(*options); }; });
}

}  // namespace fringe::cli
