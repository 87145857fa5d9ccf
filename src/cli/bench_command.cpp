// fringe bench: run time against error on this device, and what its features cost.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "cli/bench_compare.hpp"
#include "cli/bench_report.hpp"
#include "cli/commands.hpp"
#include "cli/device_choice.hpp"
#include "cli/input.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "image/pending_file.hpp"
#include "qualify/bench_evaluators.hpp"
#include "version.hpp"

namespace fringe::cli {
namespace {

struct BenchOptions {
    bool evaluators = false;
    bool frames = false;
    bool skip = false;
    std::vector<std::string> cases;
    int rounds = 7;
    double tolerance = 1e-3;
    std::vector<std::string> outputs;
    std::string compareWith;
    double allowed = 1.3;
    bool check = false;
    std::string device;
    bool quiet = false;
    bool json = false;

    bool all() const { return !evaluators && !frames && !skip; }
    bool wants(std::string_view name) const {
        return cases.empty() || std::find(cases.begin(), cases.end(), name) != cases.end();
    }
};

constexpr const char* kClock =
    "the host's steady clock around dispatches, from asking to having; median of the rounds, and half the "
    "distance between their quartiles";

// ---- what is asked for ------------------------------------------------------------------------------

std::vector<std::string_view> knownCases(const BenchOptions& options) {
    std::vector<std::string_view> known;
    if (options.all() || options.evaluators)
        for (const qualify::EvaluatorCase& which : qualify::evaluatorCases()) known.push_back(which.name);
    if (options.all() || options.frames)
        for (const qualify::FrameCase& frameCase : qualify::frameCases()) known.push_back(frameCase.name);
    if (options.all() || options.skip)
        for (const std::string_view name : qualify::skipCases()) known.push_back(name);
    return known;
}

void requireCases(const BenchOptions& options) {
    const std::vector<std::string_view> known = knownCases(options);
    for (const std::string& name : options.cases) {
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw InputError(fmt::format("no case \"{}\"; there are\n  {}", name, fmt::join(known, "\n  ")));
    }
}

std::string extensionOf(const std::string& path) {
    return std::filesystem::path(path).extension().string();
}

bool isChart(const std::string& path) {
    return plot::isChartFile(path);
}

// A wrong path is known before the work.
void requireOutputs(const BenchOptions& options) {
    for (const std::string& path : options.outputs) {
        if (extensionOf(path) != ".json" && extensionOf(path) != ".csv" && !isChart(path))
            throw InputError(fmt::format("{}: the name must end in .json, .csv, .svg or .png", path));
        const image::PendingFile probe(path);
    }
}

Json::Value readReport(const std::string& path) {
    const std::string text = readTextFile(path);
    const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
    Json::Value report;
    std::string problems;
    if (!reader->parse(text.data(), text.data() + text.size(), &report, &problems) || !isReport(report)) {
        throw InputError(fmt::format("{}: no report of fringe bench; make one with fringe bench -o {}", path,
                                     std::filesystem::path(path).filename().string()));
    }
    return report;
}

// ---- the measurements -------------------------------------------------------------------------------

// Every compilation is a first one: drivers keep what they have compiled on disk, unless told not to.
void disableShaderCaches() {
    for (const char* name : {"MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE"}) setenv(name, "true", 1);
    setenv("__GL_SHADER_DISK_CACHE", "0", 1);
}

// Runs the cases one after the other, and shows each when it is there.
class Bench {
public:
    Bench(const gpu::Device& device, const BenchOptions& options) : device_(device), options_(options) {
        report_["device"] = device.description().name;
        report_["driver"] = device.description().driver;
        report_["vulkan"] = device.description().vulkan;
        report_["version"] = kVersion;
        report_["commit"] = kCommit;
        report_["compiler"] = kCompiler;
        report_["clock"] = kClock;
        report_["options"]["rounds"] = options.rounds;
        report_["options"]["tolerance"] = options.tolerance;
        for (const std::string& name : options.cases) report_["options"]["cases"].append(name);
        report_["rows"] = Json::arrayValue;
        if (!options.json) {
            fmt::print("{}, {}; fringe {} ({})\n{}\n", device.description().name, device.description().driver,
                       kVersion, kCommit, kClock);
        }
    }

    void run() {
        if (options_.all() || options_.evaluators) runEvaluators();
        if (options_.all() || options_.frames) runFrames();
        if (options_.all() || options_.skip) runSkip();
    }

    const Json::Value& report() const { return report_; }

private:
    // Rows of type `Row`, measured by work(control).
    template <class Work>
    void measure(Work work) {
        auto rows = [&] {
            Progress progress(options_.quiet);
            return work(qualify::BenchControl{.rounds = options_.rounds,
                                              .cancelled = interrupted(),
                                              .onProgress = [&](double done) { progress.show(done); }});
        }();
        for (const auto& row : rows) show(toJson(row));
    }

    void runEvaluators() {
        for (const qualify::EvaluatorCase& which : qualify::evaluatorCases()) {
            if (!options_.wants(which.name) || interrupted()) continue;
            qualify::EvaluatorRequest request;
            request.tolerance = options_.tolerance;
            measure([&](const qualify::BenchControl& control) {
                return qualify::benchEvaluators(device_, which, request, control);
            });
        }
    }

    void runFrames() {
        for (const qualify::FrameCase& frameCase : qualify::frameCases()) {
            if (!options_.wants(frameCase.name) || interrupted()) continue;
            measure([&](const qualify::BenchControl& control) {
                return qualify::benchFrames(device_, frameCase.name, control);
            });
        }
    }

    void runSkip() {
        std::vector<std::string> names;
        for (const std::string_view name : qualify::skipCases())
            if (!options_.cases.empty() && options_.wants(name)) names.emplace_back(name);
        if (interrupted() || (names.empty() && !options_.cases.empty())) return;
        measure([&](const qualify::BenchControl& control) {
            return qualify::benchSkip(device_, names, control);
        });
    }

    void show(const Json::Value& row) {
        report_["rows"].append(row);
        if (options_.json) return;
        const std::string group = row["group"].asString();
        if (std::exchange(shown_, group) != group) fmt::print("\n{}\n", tableHead(group));
        const std::string caseName = row["case"].asString();
        if (group == "evaluators" && std::exchange(shownCase_, caseName) != caseName)
            fmt::print("{}\n", caseName);
        fmt::print("{}\n", tableLine(row));
        std::fflush(stdout);  // the next case takes seconds
    }

    const gpu::Device& device_;
    const BenchOptions& options_;
    Json::Value report_;
    std::string shown_;      // the group whose head is the last one
    std::string shownCase_;  // of an evaluator
};

// ---- the results ------------------------------------------------------------------------------------

void writeText(const std::string& path, const std::string& text) {
    image::PendingFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

void writeOutputs(const BenchOptions& options, const Json::Value& report) {
    for (const std::string& path : options.outputs) {
        if (extensionOf(path) == ".json") {
            writeText(path, formatJson(report));
        } else if (extensionOf(path) == ".csv") {
            writeText(path, csvOf(report["rows"]));
        } else if (const auto scatter = scatterOf(report)) {
            plot::writeScatter(path, *scatter);
        } else {
            fmt::print(stderr, "fringe: {}: nothing to draw, no row has both a time and an error\n", path);
        }
    }
}

// The changes of rows that are worse than allowed, or all; whether none is worse.
bool reportComparison(const BenchOptions& options, const Json::Value& old, Json::Value& report) {
    const BenchComparison comparison = compareReports(old, report, options.allowed);
    bool good = true;
    if (!options.json) {
        fmt::print("\n{:<56} {:>10} {:>10}\n", "new over old, " + options.compareWith, "time", "rms error");
        if (old["device"] != report["device"])
            fmt::print("the old device was another: {}\n", old["device"].asString());
    }
    for (const BenchChange& change : comparison.changes) {
        good = good && !change.slower && !change.lessExact;
        Json::Value json;
        json["row"] = change.row;
        json["time_ratio"] = change.time;
        json["error_ratio"] = change.error;
        json["slower"] = change.slower;
        json["less_exact"] = change.lessExact;
        report["changes"].append(json);
        if (options.json) continue;
        const auto shown = [](double ratio) { return ratio > 0.0 ? fmt::format("{:.3f}", ratio) : "-"; };
        fmt::print("{:<56} {:>10} {:>10}{}{}\n", change.row, shown(change.time), shown(change.error),
                   change.slower ? "  SLOWER" : "", change.lessExact ? "  LESS EXACT" : "");
    }
    if (!options.json && options.all() && options.cases.empty()) {
        for (const std::string& name : comparison.missing) fmt::print("{}: only in the old report\n", name);
    }
    return good;
}

int bench(const BenchOptions& options) {
    requireCases(options);
    requireOutputs(options);
    Json::Value old;
    if (!options.compareWith.empty()) old = readReport(options.compareWith);
    catchInterrupts();
    disableShaderCaches();
    const gpu::Device device(deviceRequest(options.device));
    Bench bench(device, options);
    bench.run();

    Json::Value report = bench.report();
    bool good = std::all_of(report["rows"].begin(), report["rows"].end(),
                            [](const Json::Value& row) { return row["verified"].asBool(); });
    if (!old.isNull()) good = reportComparison(options, old, report) && good;
    writeOutputs(options, report);
    if (options.json) printJson(report);
    if (!passedValidation(device)) return kMachineCannot;
    if (interrupted()) {
        fmt::print(stderr, "fringe: interrupted; what was measured until then is kept\n");
        return interruptStatus();
    }
    return options.check && !good ? kCheckFailed : kDone;
}

}  // namespace

void addBench(CLI::App& app, Command& chosen) {
    CLI::App* command =
        app.add_subcommand("bench", "Measure run time against error on this device, and what features cost");
    const auto options = std::make_shared<BenchOptions>();
    command->add_flag(
        "--evaluators", options->evaluators,
        "ways to the colour of slits, from one slit to a million, beside a sum by the processor");
    command->add_flag("--frames", options->frames,
                      "whole frames: samples, tiles, sizes, numbers of gratings and of spheres, physics");
    command->add_flag("--skip", options->skip,
                      "pipelines with and without each feature: frame, compilation, size of the shader");
    command->add_option("--case", options->cases, "this case alone; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--rounds", options->rounds, "timings of each setting")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--tolerance", options->tolerance, "largest error that \"auto\" is to keep, of the peak")
        ->check(CLI::Range(1e-5, 0.1))
        ->capture_default_str();
    command
        ->add_option("-o,--output", options->outputs,
                     "report, .json or .csv, or error against time as a chart, .svg or .png; may be repeated")
        ->allow_extra_args(false);
    CLI::Option* compare = command->add_option("--compare", options->compareWith,
                                               "show what got slower or less exact since this .json report");
    command->add_option("--allow", options->allowed, "ratio beyond which --compare calls something worse")
        ->check(CLI::Range(1.0, 1000.0))
        ->needs(compare)
        ->capture_default_str();
    command->add_flag(
        "--check", options->check,
        "status 3 where a picture is wrong, \"auto\" misses its tolerance or a Delta E of 1, or "
        "--compare finds something worse");
    command->add_option("--device", options->device, "Vulkan device, by index or part of its name");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->add_flag("--json", options->json, "print the report as JSON");
    command->callback([=, &chosen] { chosen = [=] { return bench(*options); }; });
}

}  // namespace fringe::cli
