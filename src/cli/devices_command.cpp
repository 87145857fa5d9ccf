// fringe devices: the Vulkan devices of this machine, and whether each can run Fringe.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <json/json.h>

#include "cli/commands.hpp"
#include "cli/report.hpp"
#include "gpu/device.hpp"

namespace fringe::cli {
namespace {

Json::Value toJson(const gpu::DeviceDescription& device) {
    Json::Value json;
    json["name"] = device.name;
    json["type"] = device.type;
    json["driver"] = device.driver;
    json["vulkan"] = device.vulkan;
    json["usable"] = device.missing.empty();
    json["missing"] = Json::arrayValue;
    for (const std::string& what : device.missing) json["missing"].append(what);
    return json;
}

int listDevices(bool asJson) {
    const auto devices = gpu::listDevices();
    Json::Value all(Json::arrayValue);
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const gpu::DeviceDescription& device = devices[i];
        all.append(toJson(device));
        if (asJson) continue;
        const std::string verdict = device.missing.empty()
                                        ? "can run Fringe"
                                        : fmt::format("lacks {}", fmt::join(device.missing, ", "));
        fmt::print("{}: {}\n   {}, Vulkan {}, {}\n   {}\n", i, device.name, device.type, device.vulkan,
                   device.driver, verdict);
    }
    if (asJson) printJson(all);
    return kDone;
}

}  // namespace

void addDevices(CLI::App& app, Command& chosen) {
    CLI::App* command = app.add_subcommand("devices", "List Vulkan devices and whether each can run Fringe");
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "print JSON");
    command->callback([=, &chosen] { chosen = [=] { return listDevices(*json); }; });
}

}  // namespace fringe::cli
