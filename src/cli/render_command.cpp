// fringe render: a scene to pictures, on the device or on the reference renderer.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <cassert>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <thread>

#include "cli/commands.hpp"
#include "cli/device_choice.hpp"
#include "cli/grating_report.hpp"
#include "cli/input.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/picture_options.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "compile/compiled_scene.hpp"
#include "image/pending_file.hpp"
#include "oracle/reference.hpp"
#include "render/renderer.hpp"
#include "version.hpp"

namespace fringe::cli {
namespace {

struct RenderOptions {
    SceneSource source;
    std::vector<std::string> outputs;
    std::string device;
    std::string stats;
    std::uint32_t tile = 0;
    PictureOptions picture;
    bool reference = false;
    bool keepPartial = false;
    bool quiet = false;
    bool json = false;
};

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// What a render was and how long its parts took; the source of the summary, --stats and --json.
struct Report {
    std::string renderer;  // the device, or the reference
    std::string driver;
    std::vector<std::string> outputs;  // the files written
    double exposure = 0.0;             // stops; when automatic, the one found
    double parse_ms = 0.0;
    double startUp_ms = 0.0;
    render::Clocks clocks;
    double write_ms = 0.0;
    double total_ms = 0.0;
    Json::Value warnings = Json::arrayValue;  // of what the device shows wrongly
};

// ---- metadata -----------------------------------------------------------------------------------

// Longer scenes are named but not carried inside the picture.
constexpr std::size_t kLongestEmbeddedScene = 256 << 10;

std::string optionsText(const RenderOptions& options, const scene::Image& image, double exposure) {
    std::string text = fmt::format("{}x{}, {} samples, seed {}, max_depth {}, exposure {:g}", image.width,
                                   image.height, image.samples, image.seed, image.maxDepth, exposure);
    if (image.autoExposure) text += " (automatic)";
    text += pictureText(options.picture, image);
    if (options.reference) text += ", --reference";
    for (const std::string& given : options.source.overrides) text += ", --set " + given;
    if (!options.source.tolerance.empty()) text += ", --tolerance " + options.source.tolerance;
    return text;
}

image::Metadata metadata(const RenderOptions& options, const scene::Scene& scene, const std::string& text,
                         const Report& report, double exposure) {
    image::Metadata data{
        {"Software", fmt::format("fringe {} ({})", kVersion, kCommit)},
        {"Creation Time", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
        {"fringe scene file", options.source.file},
        {"fringe device", report.renderer},
        {"fringe driver", report.driver},
        {"fringe options", optionsText(options, scene.image, exposure)},
    };
    if (!scene.description.empty()) data.insert(data.begin(), {"Description", scene.description});
    if (text.size() <= kLongestEmbeddedScene) data.emplace_back("fringe scene", text);
    return data;
}

// ---- the two renderers --------------------------------------------------------------------------

using BandSink = std::function<void(std::span<const image::Pixel>)>;
using ProgressSink = std::function<void(double)>;

// False when interrupted; `sink` then got the bands that are complete. A band has as many rows as take about
// 100 ms, so that progress shows and little is lost.
bool renderReference(const oracle::Reference& reference, const scene::Image& image, const BandSink& sink,
                     const ProgressSink& progress, Report& report) {
    const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    std::vector<image::Pixel> pixels;
    std::uint32_t rows = 1;
    for (std::uint32_t row = 0; row < image.height;) {
        rows = std::min(rows, image.height - row);
        pixels.assign(std::size_t{rows} * image.width, {});
        const auto start = Clock::now();
        const bool complete = reference.render(row, rows, pixels, threads, interrupted());
        const double spent_ms = millisecondsSince(start);
        report.clocks.dispatch += spent_ms;
        if (!complete) return false;
        sink(pixels);
        row += rows;
        progress(double{1.0} * row / image.height);
        if (spent_ms < 50.0) rows *= 2;
        if (spent_ms > 200.0) rows = std::max(1U, rows / 2);
    }
    return true;
}

bool renderOnDevice(render::Renderer& renderer, std::uint32_t tile, const BandSink& sink,
                    const ProgressSink& progress) {
    return renderer.render({.cancelled = interrupted(),
                            .onProgress = progress,
                            .onBand = [&](const render::Band& band) { sink(band.pixels); },
                            .tile = tile});
}

// Luminance comes from the colour.
compile::Measure measureOf(image::Quantity quantity) {
    switch (quantity) {
        case image::Quantity::color:
        case image::Quantity::luminance:
            return compile::Measure::color;
        case image::Quantity::radiance:
            return compile::Measure::radiance;
        case image::Quantity::irradiance:
            return compile::Measure::irradiance;
    }
    assert(false);
    return compile::Measure::color;
}

// ---- what is said about it ----------------------------------------------------------------------

double peakMemory_MiB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts KiB
}

Json::Value toJson(const Report& report, const RenderOptions& options, const scene::Image& image) {
    Json::Value json;
    json["scene"] = options.source.file;
    json["outputs"] = Json::arrayValue;
    for (const std::string& path : report.outputs) json["outputs"].append(path);
    json["device"] = report.renderer;
    json["driver"] = report.driver;
    json["width"] = image.width;
    json["height"] = image.height;
    json["samples"] = image.samples;
    json["exposure"] = report.exposure;
    json["auto_exposure"] = image.autoExposure;
    Json::Value& clocks = json["clocks_ms"];
    clocks["parse"] = report.parse_ms;
    clocks["start_up"] = report.startUp_ms;
    clocks["upload"] = report.clocks.upload;
    clocks["compile"] = report.clocks.compile;
    clocks["dispatch"] = report.clocks.dispatch;
    clocks["readback"] = report.clocks.readback;
    clocks["write"] = report.write_ms;
    clocks["total"] = report.total_ms;
    json["dispatches"] = Json::UInt64{report.clocks.dispatches};
    json["peak_rss_mib"] = peakMemory_MiB();
    json["warnings"] = report.warnings;
    return json;
}

void writeStats(const std::string& path, const Json::Value& stats) {
    const std::string text = formatJson(stats);
    image::PendingFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

void printSummary(const Report& report, const scene::Image& image) {
    const std::string exposure =
        image.autoExposure ? fmt::format(", exposure {:+.2f} (automatic)", report.exposure) : "";
    fmt::print("{}: {} x {}, {} sample(s){}, {:.3f} s ({:.1f} ms rendering) on {}\n",
               fmt::join(report.outputs, ", "), image.width, image.height, image.samples, exposure,
               report.total_ms / 1e3, report.clocks.dispatch, report.renderer);
}

// ---- the command --------------------------------------------------------------------------------

// Finishes the files, or gives them up after an interruption; the exit status.
int conclude(Outputs& outputs, bool complete, bool keepPartial) {
    if (!complete && !keepPartial) {
        fmt::print(stderr, "fringe: interrupted; nothing was written (--keep-partial writes what is done)\n");
        return interruptStatus();
    }
    if (!complete) outputs.fill();
    outputs.finish();
    for (const std::string& failure : outputs.failures()) fmt::print(stderr, "fringe: {}\n", failure);
    if (!complete) {
        fmt::print(stderr, "fringe: interrupted; what was done is in {}\n",
                   fmt::join(outputs.written(), ", "));
        return interruptStatus();
    }
    return outputs.failures().empty() ? kDone : kMachineCannot;
}

int render(RenderOptions options) {
    const auto start = Clock::now();
    catchInterrupts();
    if (options.outputs.empty()) {
        const char* extension = quantityOf(options.picture) == image::Quantity::color ? ".png" : ".exr";
        options.outputs.push_back(std::filesystem::path(options.source.file).stem().string() + extension);
    }
    const compile::Measure measure = measureOf(quantityOf(options.picture));
    if (options.reference && measure != compile::Measure::color) {
        throw InputError(fmt::format("--quantity {}: the reference renderer has color and luminance only",
                                     options.picture.quantity));
    }
    Report report;
    const std::string text = readTextFile(options.source.file);
    scene::Scene scene = parseSource(options.source, text);
    applyTo(scene.image, options.picture);
    report.parse_ms = millisecondsSince(start);
    if (!options.reference) report.warnings = warningsJson(scene);
    if (!options.reference && !options.quiet) printWarnings(options.source.file, scene);

    // A wrong path is known before anything is started for it.
    for (const std::string& path : options.outputs) image::requireWritable(path);
    if (!options.stats.empty()) const image::PendingFile probe(options.stats);

    std::optional<gpu::Device> device;
    const auto startUp = Clock::now();
    if (options.reference) {
        report.renderer = "reference renderer (CPU, double precision)";
        report.driver = kCompiler;
    } else {
        device.emplace(deviceRequest(options.device));
        report.renderer = device->description().name;
        report.driver = device->description().driver;
    }
    report.startUp_ms = millisecondsSince(startUp);

    image::OutputOptions output = outputOptions(options.picture, scene);
    output.nonFiniteChannel = scene::hasPrintedFaults(scene);
    const auto outputAt = [&](double exposure) {
        output.development.exposure = exposure;
        output.metadata = metadata(options, scene, text, report, exposure);
        return output;
    };
    Outputs outputs(options.outputs, scene.image, outputAt);
    const BandSink sink = [&](std::span<const image::Pixel> rows) {
        if (interrupted() && !options.keepPartial) return;  // the files go anyway
        const auto writeStart = Clock::now();
        outputs.writeRows(rows);
        report.write_ms += millisecondsSince(writeStart);
    };
    bool complete = false;
    {
        Progress progress(options.quiet);
        const ProgressSink show = [&](double done) { progress.show(done); };
        if (options.reference) {
            complete = renderReference(oracle::Reference(scene), scene.image, sink, show, report);
        } else {
            const compile::CompiledScene compiled = compile::compileScene(scene, measure);
            render::Renderer renderer(*device, compiled, compile::specialise(compiled, scene.camera),
                                      render::Values::asConstants, compile::litTiles(scene, compiled));
            complete = renderOnDevice(renderer, options.tile, sink, show);
            report.clocks = renderer.clocks();
        }
    }
    const auto finishing = Clock::now();
    int status = conclude(outputs, complete, options.keepPartial);
    report.outputs = outputs.written();
    report.exposure = outputs.exposure();
    report.write_ms += millisecondsSince(finishing);
    report.total_ms = millisecondsSince(start);
    if (device && !passedValidation(*device)) status = kMachineCannot;
    if (!options.stats.empty()) writeStats(options.stats, toJson(report, options, scene.image));
    if (complete && options.json) printJson(toJson(report, options, scene.image));
    else if (complete && !options.quiet) printSummary(report, scene.image);
    return status;
}

}  // namespace

void addRender(CLI::App& app, Command& chosen) {
    CLI::App* command = app.add_subcommand("render", "Render a scene to PNG and EXR files");
    const auto options = std::make_shared<RenderOptions>();
    addSceneOptions(*command, options->source);
    command
        ->add_option("-o,--output", options->outputs,
                     "picture file, .png or .exr; may be given several times")
        ->allow_extra_args(false);
    command->add_flag("--reference", options->reference,
                      "render on the CPU in double precision, by other code");
    command->add_option("--device", options->device,
                        "Vulkan device, by index or part of its name (see: fringe devices)");
    command->add_option("--tile", options->tile, "edge of a tile in pixels (default: fitted to the device)")
        ->check(CLI::Range(1, 65536));
    addPictureOptions(*command, options->picture);
    command->add_option("--stats", options->stats, "write the clocks and the peak memory to this JSON file");
    command->add_flag("--keep-partial", options->keepPartial,
                      "on Ctrl-C, write what is done (the rest is black)");
    command->add_flag("--quiet", options->quiet, "no progress and no summary");
    command->add_flag("--json", options->json, "print the summary as JSON");
    command->callback([=, &chosen] { chosen = [=] { return render(*options); }; });
}

}  // namespace fringe::cli
