// fringe profile: irradiance and spectrum along a line on a surface, and what its maxima are.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "cli/commands.hpp"
#include "cli/device_choice.hpp"
#include "cli/input.hpp"
#include "cli/interrupt.hpp"
#include "cli/profile_report.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "compile/compiled_scene.hpp"
#include "compile/warnings.hpp"
#include "image/pending_file.hpp"
#include "profile/sampling.hpp"
#include "render/renderer.hpp"

namespace fringe::cli {
namespace {

struct ProfileOptions {
    SceneSource source;
    std::string from;
    std::string to;
    std::uint32_t samples = 1000;
    std::string grating;
    std::vector<std::string> outputs;
    std::string device;
    bool closedForm = false;
    bool quiet = false;
    bool json = false;
};

// Raised between passes; there is nothing to keep.
struct Interrupted {};

glm::dvec3 pointOf(const char* option, const std::string& text) {
    glm::dvec3 point(0.0);
    const char* at = text.data();
    const char* const end = at + text.size();
    for (int i = 0; i < 3; ++i) {
        const auto [next, error] = std::from_chars(at, end, point[i]);
        const bool goesOn = i < 2 ? next != end && *next == ',' : next == end;
        if (error != std::errc() || !goesOn || !std::isfinite(point[i])) {
            throw InputError(fmt::format("{} {}: write a point as X,Y,Z in metres, as in {} -0.5,0,-1",
                                         option, text, option));
        }
        at = next + 1;
    }
    return point;
}

// A wrong path is known before anything is started for it.
void requireOutputs(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
        if (!profile::isReportFile(path)) {
            throw InputError(
                fmt::format("{}: a profile goes to a file that ends in .csv, .svg or .png", path));
        }
        const image::PendingFile probe(path);
    }
}

// ---- which grating ------------------------------------------------------------------------------

// The light called so, or the only one that can be a spectrometer; null and a note where there are several.
const scene::Light* gratingOf(const scene::Scene& scene, const std::string& name,
                              std::vector<std::string>& notes) {
    const std::vector<const scene::Light*> candidates = profile::spectrometersOf(scene);
    std::string names;
    for (const scene::Light& light : scene.lights)
        if (!name.empty() && light.name == name) return &light;
    for (const scene::Light* light : candidates)
        if (!light->name.empty()) names += (names.empty() ? "" : ", ") + light->name;
    if (!name.empty()) {
        throw InputError(fmt::format("--grating {}: no light has this name; gratings with names: {}", name,
                                     names.empty() ? "none" : names));
    }
    if (candidates.size() == 1) return candidates.front();
    if (candidates.size() > 1)
        notes.push_back("the scene has several gratings; --grating NAME reads wavelengths with one of them");
    return nullptr;
}

// ---- sampling -----------------------------------------------------------------------------------

// The picture of the line, a band in each row. Throws Interrupted.
std::vector<image::Pixel> measure(const gpu::Device& device, const scene::Scene& rowScene,
                                  Progress& progress) {
    const compile::CompiledScene compiled = compile::compileScene(rowScene, compile::Measure::spectrum);
    render::Renderer renderer(device, compiled, compile::specialise(compiled, rowScene.camera),
                              render::Values::asConstants);
    std::vector<image::Pixel> pixels;
    const bool complete =
        renderer.render({.cancelled = interrupted(),
                         .onProgress = [&](double done) { progress.show(done); },
                         .onBand =
                             [&](const render::Band& band) {
                                 pixels.insert(pixels.end(), band.pixels.begin(), band.pixels.end());
                             },
                         .tile = 0});
    if (!complete) throw Interrupted();
    return pixels;
}

// Lines finer than the samples show as single samples or not at all.
void noteCoarseSamples(ProfileReport& report) {
    if (!report.spectrometer || report.spectrometer->spectrum().lines.empty()) return;
    constexpr double kFewest = 4.0;  // samples to a maximum
    double narrowest = kFewest;
    const std::vector<profile::Threshold> thresholds =
        profile::thresholdsFor(report.samples, &*report.spectrometer);
    for (const profile::SpectralMaximum& maximum : report.maxima) {
        if (maximum.reading) narrowest = std::min(narrowest, thresholds[maximum.maximum.top].separation);
    }
    if (narrowest < kFewest && narrowest > 0.0) {
        report.notes.push_back(
            fmt::format("maxima may be narrower than the samples are apart; --samples {:.0f} shows them",
                        std::ceil(static_cast<double>(report.samples.points.size()) * kFewest / narrowest)));
    }
}

// ---- the command --------------------------------------------------------------------------------

int profileLine(const ProfileOptions& options) {
    catchInterrupts();
    const glm::dvec3 from = pointOf("--from", options.from);
    const glm::dvec3 to = pointOf("--to", options.to);
    const scene::Scene scene = parseSource(options.source, readTextFile(options.source.file));

    std::vector<std::string> notes;
    for (const auto& [name, message] : compile::warningsOf(scene)) notes.push_back(name + ": " + message);
    const scene::Light* light = gratingOf(scene, options.grating, notes);
    const profile::SurfaceLine line = profile::surfaceUnder(
        scene, from, to,
        light != nullptr ? std::get<scene::Grating>(light->model).position : scene.camera.position);
    ProfileReport report{
        profile::reportOn(scene, options.source.file, line, light, options.samples), {}, notes, {}};
    const scene::Scene rowScene = profile::lineScene(scene, report.line, options.samples);
    requireOutputs(options.outputs);

    const gpu::Device device(deviceRequest(options.device));
    report.device = device.description().name;
    try {
        Progress progress(options.quiet);
        profile::takePicture(measure(device, rowScene, progress), report);
    } catch (const Interrupted&) {
        fmt::print(stderr, "fringe: interrupted; nothing was written\n");
        return interruptStatus();
    }
    noteCoarseSamples(report);
    if (options.closedForm) {
        report.closedForm =
            profile::closedFormAlong(scene, report.line, report.samples.points, interrupted());
        if (interrupted()) {
            fmt::print(stderr, "fringe: interrupted; nothing was written\n");
            return interruptStatus();
        }
        if (!report.closedForm) report.notes.push_back("no light of the scene has a closed form");
    }
    for (const std::string& path : options.outputs) {
        profile::writeReport(path, report);
        report.outputs.push_back(path);
    }
    if (options.json) printJson(toJson(report));
    else if (!options.quiet) print(report);
    return passedValidation(device) ? kDone : kMachineCannot;
}

}  // namespace

void addProfile(CLI::App& app, Command& chosen) {
    CLI::App* command = app.add_subcommand(
        "profile", "Measure irradiance and spectrum along a line on a surface, and name its maxima");
    const auto options = std::make_shared<ProfileOptions>();
    addSceneOptions(*command, options->source);
    command->add_option("--from", options->from, "X,Y,Z: where the line begins, metres, on a surface")
        ->required();
    command->add_option("--to", options->to, "X,Y,Z: where it ends, on the same surface")->required();
    command->add_option("--samples", options->samples, "how many, evenly (default 1000)")
        ->check(CLI::Range(2, 65536));
    command->add_option("--grating", options->grating,
                        "name of the grating that wavelengths are read with (default: the only one)");
    command->add_option("-o,--output", options->outputs, "files to write: .csv, and plots as .svg and .png");
    command->add_option("--device", options->device,
                        "Vulkan device, by index or part of its name (see: fringe devices)");
    command->add_flag("--closed-form", options->closedForm,
                      "add a second curve: the textbook's far field of the gratings, without shadows");
    command->add_flag("--quiet", options->quiet, "no progress and no summary");
    command->add_flag("--json", options->json, "print the result as JSON");
    command->callback([=, &chosen] { chosen = [=] { return profileLine(*options); }; });
}

}  // namespace fringe::cli
