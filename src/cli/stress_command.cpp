// fringe stress: whether a device's arithmetic is good enough, function by function; the exit status is a
// verdict.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "cli/commands.hpp"
#include "cli/device_choice.hpp"
#include "cli/input.hpp"
#include "cli/report.hpp"
#include "qualify/stress.hpp"

namespace fringe::cli {
namespace {

using qualify::StressCase;
using qualify::StressReport;
using qualify::Witness;

// Each function takes about a second then.
constexpr std::uint64_t kUsualCount = 2'000'000;

struct StressOptions {
    std::string device;
    std::vector<std::string> names;
    std::uint64_t seed = 1;
    std::uint64_t count = 0;  // 0: as usual
    std::optional<double> bound;
    bool full = false;
    bool json = false;
};

std::vector<const StressCase*> chosenCases(const std::vector<std::string>& names) {
    std::vector<const StressCase*> chosen;
    std::vector<std::string_view> known;
    for (const StressCase& stressCase : qualify::stressCases()) {
        known.push_back(stressCase.name);
        if (names.empty() || std::find(names.begin(), names.end(), stressCase.name) != names.end())
            chosen.push_back(&stressCase);
    }
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw InputError(fmt::format("no case \"{}\"; there are {}", name, fmt::join(known, ", ")));
    }
    return chosen;
}

std::uint64_t countOf(const StressCase& stressCase, const StressOptions& options) {
    if (options.count > 0) return options.count;
    // What takes long to judge has fewer.
    return options.full ? stressCase.fullCount : std::min(kUsualCount, stressCase.fullCount / 50);
}

// What a case is judged by here; nothing where it is only shown.
std::optional<double> boundOf(const StressCase& stressCase, const StressOptions& options) {
    return options.bound ? options.bound : stressCase.bound;
}

bool passes(const StressReport& report, const std::optional<double>& bound) {
    return !bound || report.keeps(*bound);
}

std::string verdict(const StressReport& report, const std::optional<double>& bound) {
    if (!bound) return "not judged";
    return report.keeps(*bound) ? "holds" : "BROKEN";
}

std::string described(const StressCase& stressCase, const Witness& witness) {
    std::string text;
    for (std::size_t i = 0; i < witness.inputs.size(); ++i)
        text += fmt::format("{}{} {:.9g}", i == 0 ? "" : ", ", stressCase.inputs[i], witness.inputs[i]);
    return text;
}

void printHead(const gpu::Device& device, std::uint64_t seed) {
    fmt::print("{}, {}; seed {}\n", device.description().name, device.description().driver, seed);
    fmt::print("{:<18} {:>11} {:>10} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "function", "count", "non-finite",
               "largest", "99.9 %", "ulp", "99.9 %", "bound");
}

void print(const StressCase& stressCase, const StressReport& report, const std::optional<double>& bound) {
    fmt::print("{:<18} {:>11} {:>10} {:>9.2e} {:>9.2e} {:>9.2e} {:>9.2e} {:>9}  {}\n", stressCase.name,
               report.count, report.nonFinite, report.largest, report.most, report.largestUlps,
               report.mostUlps, bound ? fmt::format("{:.1e}", *bound) : "-", verdict(report, bound));
    if (report.worst && report.largest > 0.0) {
        fmt::print("    worst, number {}: {} gives {:.9g} for {:.9g}\n", report.worst->number,
                   described(stressCase, *report.worst), report.worst->judgement.got,
                   report.worst->judgement.expected);
    }
    if (report.firstNonFinite) {
        fmt::print("    no number, first number {}: {} gives {}\n", report.firstNonFinite->number,
                   described(stressCase, *report.firstNonFinite),
                   fmt::join(report.firstNonFinite->results, ", "));
    }
    std::fflush(stdout);  // a full run takes minutes
}

Json::Value toJson(const StressCase& stressCase, const Witness& witness) {
    Json::Value json;
    json["number"] = Json::UInt64{witness.number};
    for (std::size_t i = 0; i < witness.inputs.size(); ++i) {
        Json::Value& input = json["inputs"][std::string(stressCase.inputs[i])];
        input["value"] = witness.inputs[i];
        input["hex"] = fmt::format("{:a}", witness.inputs[i]);
    }
    for (const float result : witness.results) json["results"].append(fmt::format("{:a}", result));
    return json;
}

Json::Value toJson(const StressCase& stressCase, const StressReport& report,
                   const std::optional<double>& bound) {
    Json::Value json;
    json["name"] = std::string(stressCase.name);
    json["function"] = std::string(stressCase.function);
    json["count"] = Json::UInt64{report.count};
    json["non_finite"] = Json::UInt64{report.nonFinite};
    json["error"]["largest"] = report.largest;
    json["error"]["percentile_99_9"] = report.most;
    json["ulps"]["largest"] = report.largestUlps;
    json["ulps"]["percentile_99_9"] = report.mostUlps;
    if (bound) json["bound"] = *bound;
    json["reason"] = std::string(stressCase.reason);
    json["passed"] = passes(report, bound);
    json["seconds"] = report.seconds;
    if (report.worst) {
        json["worst"] = toJson(stressCase, *report.worst);
        json["worst"]["got"] = report.worst->judgement.got;
        json["worst"]["expected"] = report.worst->judgement.expected;
    }
    if (report.firstNonFinite) json["first_non_finite"] = toJson(stressCase, *report.firstNonFinite);
    return json;
}

int stress(const StressOptions& options) {
    const std::vector<const StressCase*> cases = chosenCases(options.names);
    const gpu::Device device(deviceRequest(options.device));
    Json::Value all;
    all["device"] = device.description().name;
    all["driver"] = device.description().driver;
    all["seed"] = Json::UInt64{options.seed};
    if (!options.json) printHead(device, options.seed);
    std::size_t broken = 0;
    double seconds = 0.0;
    for (const StressCase* stressCase : cases) {
        const StressReport report =
            qualify::stress(device, *stressCase, {options.seed, countOf(*stressCase, options)});
        const std::optional<double> bound = boundOf(*stressCase, options);
        if (!passes(report, bound)) ++broken;
        seconds += report.seconds;
        if (options.json) all["cases"].append(toJson(*stressCase, report, bound));
        else print(*stressCase, report, bound);
    }
    all["passed"] = broken == 0;
    if (options.json) printJson(all);
    else fmt::print("{} of {} bounds broken; {:.1f} s\n", broken, cases.size(), seconds);
    if (!passedValidation(device)) return kMachineCannot;
    return broken == 0 ? kDone : kCheckFailed;
}

}  // namespace

void addStress(CLI::App& app, Command& chosen) {
    CLI::App* command = app.add_subcommand(
        "stress", "Judge a device's arithmetic at millions of hard inputs; status 3 if a bound is broken");
    const auto options = std::make_shared<StressOptions>();
    command->add_option("--device", options->device, "Vulkan device, by index or part of its name");
    command->add_option("--case", options->names, "run this function alone; may be repeated");
    command->add_option("--seed", options->seed, "of the inputs; the same seed gives the same inputs")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    CLI::Option* count = command
                             ->add_option("--count", options->count,
                                          fmt::format("evaluations of each function [{}]", kUsualCount))
                             ->check(CLI::PositiveNumber);
    command
        ->add_option("--bound", options->bound, "judge every function by this error instead of its own bound")
        ->check(CLI::NonNegativeNumber);
    command
        ->add_flag("--full", options->full,
                   "a thousand million evaluations of the slits, a tenth of that of the others")
        ->excludes(count);
    command->add_flag("--json", options->json, "print JSON");
    command->callback([=, &chosen] { chosen = [=] { return stress(*options); }; });
}

}  // namespace fringe::cli
