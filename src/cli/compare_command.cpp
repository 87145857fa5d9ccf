// fringe compare: how far two pictures are apart; the exit status is a verdict for scripts.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "cli/commands.hpp"
#include "cli/report.hpp"
#include "image/compare.hpp"
#include "image/reader.hpp"

namespace fringe::cli {
namespace {

struct CompareOptions {
    std::string a;
    std::string b;
    double tolerance = 0.0;
    double allow = 0.0;
    bool json = false;
};

std::vector<const char*> channelNames(const image::Difference& difference) {
    if (difference.quantity != image::Quantity::color) return {image::nameOf(difference.quantity)};
    return {"red", "green", "blue"};
}

Json::Value toJson(const image::Difference& difference, bool passed) {
    Json::Value json;
    const std::vector<const char*> names = channelNames(difference);
    for (std::size_t i = 0; i < names.size(); ++i) {
        json["channels"][names[i]]["max"] = difference.channels[i].maxAbs;
        json["channels"][names[i]]["rmse"] = difference.channels[i].rmse;
    }
    json["max"] = difference.overall.maxAbs;
    json["rmse"] = difference.overall.rmse;
    if (std::isfinite(difference.psnr)) json["psnr_db"] = difference.psnr;
    json["max_at"].append(difference.maxX);
    json["max_at"].append(difference.maxY);
    json["pixels_beyond"] = Json::UInt64{difference.beyond};
    json["fraction_beyond"] = difference.beyondFraction;
    json["non_finite_mismatches"] = Json::UInt64{difference.nonFiniteMismatches};
    json["passed"] = passed;
    return json;
}

void print(const image::Difference& difference, double tolerance) {
    const std::vector<const char*> names = channelNames(difference);
    for (std::size_t i = 0; i < names.size(); ++i) {
        fmt::print("{:<6} max {:.3e}  rmse {:.3e}\n", names[i], difference.channels[i].maxAbs,
                   difference.channels[i].rmse);
    }
    fmt::print("all    max {:.3e}  rmse {:.3e}  psnr {:.1f} dB\n", difference.overall.maxAbs,
               difference.overall.rmse, difference.psnr);
    fmt::print("largest at {}, {}; {} pixels ({:.4f} %) beyond {:g}\n", difference.maxX, difference.maxY,
               difference.beyond, 100.0 * difference.beyondFraction, tolerance);
}

int compare(const CompareOptions& options) {
    const auto difference =
        image::compare(image::readImage(options.a), image::readImage(options.b), options.tolerance);
    const bool passed = difference.beyondFraction <= options.allow;
    if (options.json) printJson(toJson(difference, passed));
    else print(difference, options.tolerance);
    return passed ? kDone : kCheckFailed;
}

}  // namespace

void addCompare(CLI::App& app, Command& chosen) {
    CLI::App* command =
        app.add_subcommand("compare", "Compare two pictures in linear values; status 3 if they differ");
    const auto options = std::make_shared<CompareOptions>();
    command->add_option("A", options->a, "PNG or EXR file")->required();
    command->add_option("B", options->b, "PNG or EXR file")->required();
    command
        ->add_option("--tolerance", options->tolerance,
                     "largest difference of a channel that counts as equal")
        ->check(CLI::NonNegativeNumber);
    command
        ->add_option("--allow", options->allow, "share of the pixels (0..1) that may be beyond the tolerance")
        ->check(CLI::Range(0.0, 1.0));
    command->add_flag("--json", options->json, "print JSON");
    command->callback([=, &chosen] { chosen = [=] { return compare(*options); }; });
}

}  // namespace fringe::cli
