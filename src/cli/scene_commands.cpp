// fringe validate and fringe info: what a scene file says, without rendering it.
#include <fmt/format.h>

#include <cstring>
#include <iterator>
#include <map>

#include "cli/commands.hpp"
#include "cli/grating_report.hpp"
#include "cli/input.hpp"
#include "cli/report.hpp"
#include "compile/compiled_scene.hpp"

namespace fringe::cli {
namespace {

// ---- validate -----------------------------------------------------------------------------------

struct ValidateOptions {
    std::vector<std::string> files;
    bool json = false;
};

int validate(const ValidateOptions& options) {
    int status = kDone;
    Json::Value all(Json::arrayValue);
    for (const std::string& file : options.files) {
        Json::Value entry;
        entry["file"] = file;
        entry["problems"] = Json::arrayValue;
        entry["warnings"] = Json::arrayValue;
        const auto refuse = [&](const std::string& place, const std::string& message) {
            status = kWrongInput;
            Json::Value problem;
            problem["place"] = place;
            problem["message"] = message;
            entry["problems"].append(problem);
        };
        try {
            const scene::Scene scene = parseSource({file, {}, {}}, readTextFile(file));
            entry["warnings"] = warningsJson(scene);
            if (!options.json) {
                fmt::print("{}: valid\n", file);
                printWarnings(file, scene);
            }
        } catch (const scene::SceneError& error) {
            for (const auto& problem : error.problems()) refuse(problem.place, problem.message);
            if (!options.json) fmt::print(stderr, "{}\n", error.what());
        } catch (const InputError& error) {
            refuse(file, error.what());
            if (!options.json) fmt::print(stderr, "fringe: {}\n", error.what());
        }
        all.append(entry);
    }
    if (options.json) printJson(all);
    return status;
}

// ---- info ---------------------------------------------------------------------------------------

struct InfoOptions {
    SceneSource source;
    bool json = false;
};

constexpr std::array kShapeNames{"plane", "rectangle", "disc", "sphere",
                                 "box",   "cylinder",  "cone", "triangle"};
constexpr std::array kLightNames{"point", "spot", "directional", "area", "environment", "grating", "grating"};
static_assert(kShapeNames.size() == std::variant_size_v<scene::Shape>);
static_assert(kLightNames.size() == std::variant_size_v<decltype(scene::Light::model)>);

// Radiant power in watts of the lights that state one.
std::optional<double> powerOf(const scene::Light& light) {
    return std::visit(
        [](const auto& model) -> std::optional<double> {
            if constexpr (requires { model.power; }) return model.power / units::W;
            else return std::nullopt;
        },
        light.model);
}

Json::Value countsOf(const scene::Scene& scene) {
    Json::Value counts(Json::objectValue);
    for (const scene::Object& object : scene.objects) {
        Json::Value& count = counts[kShapeNames[object.shape.index()]];
        count = count.asUInt() + 1;
    }
    return counts;
}

Json::Value ledgerOf(const scene::Scene& scene, compile::ResponseRows rows) {
    Json::Value ledger(Json::arrayValue);
    for (const scene::Light& light : scene.lights) {
        Json::Value entry(Json::objectValue);
        const auto* grating = std::get_if<scene::Grating>(&light.model);
        if (grating != nullptr) entry = describeGrating(*grating);
        if (grating != nullptr && !light.spectrum.density.empty()) {
            const Json::Value evaluator =
                describeEvaluator(*grating, light.spectrum, rows, scene.image.tolerance);
            if (!evaluator.isNull()) entry["evaluator"] = evaluator;
        }
        if (std::holds_alternative<scene::ThesisGrating>(light.model)) entry["model"] = "thesis";
        entry["type"] = kLightNames[light.model.index()];
        if (!light.name.empty()) entry["name"] = light.name;
        if (const auto power = powerOf(light)) entry["power_W"] = *power;
        ledger.append(entry);
    }
    return ledger;
}

Json::Value constantsOf(const device::Specialisation& constants) {
    Json::Value json;
#define ADD(id, name) json[#name] = constants.name;
    FRINGE_SPECIALISATION(ADD)
#undef ADD
    return json;
}

// Device bytes of the scene, without alignment: the uniform block, and the arrays that do not fit there.
Json::UInt64 sceneBytes(const compile::CompiledScene& s) {
    const auto bytes = [](const auto& array) {
        return array.size() > device::FEW ? array.size() * sizeof(array[0]) : 0;
    };
    return sizeof(device::SceneBlock) + bytes(s.planes) + bytes(s.rectangles) + bytes(s.discs) +
           bytes(s.spheres) + bytes(s.boxes) + bytes(s.cylinders) + bytes(s.cones) + bytes(s.triangles) +
           bytes(s.materials) + bytes(s.lights) + bytes(s.gratings) + bytes(s.slitGratings) +
           bytes(s.openingGratings) + s.tables.size() * sizeof(float) +
           s.responses.size() * sizeof(device::ResponseEntry) +
           s.tree.nodes.size() * sizeof(device::TreeNode);
}

Json::Value describe(const scene::Scene& scene) {
    const compile::CompiledScene compiled = compile::compileScene(scene);
    Json::Value json;
    json["description"] = scene.description;
    json["image"]["width"] = scene.image.width;
    json["image"]["height"] = scene.image.height;
    json["image"]["samples"] = scene.image.samples;
    json["image"]["tolerance"] = scene.image.tolerance;
    json["objects"] = countsOf(scene);
    json["materials"] = static_cast<Json::UInt>(scene.materials.size());
    json["lights"] = ledgerOf(scene, {compiled.frame.reflectanceCount, compiled.bandResponses});
    json["warnings"] = warningsJson(scene);
    json["specialisation"] = constantsOf(compile::specialise(compiled, scene.camera));
    json["device_bytes"]["scene"] = sceneBytes(compiled);
    json["device_bytes"]["whole_film"] =
        Json::UInt64{scene.image.width} * scene.image.height * sizeof(device::FilmPixel);
    return json;
}

std::string beamText(const Json::Value& light) {
    const Json::Value& fresnel = light["fresnel_number_at_1_m"];
    return fmt::format(
        "{:.4g} W of a beam of {:g} W; Fresnel number {:.3g} across the slits and {:.3g} along them "
        "(at 1 m, 550 nm; it falls with distance, and below 0.1 is the far field)",
        light["leaving_power_W"].asDouble(), light["beam_power_W"].asDouble(), fresnel["across"].asDouble(),
        fresnel["along"].asDouble());
}

std::string evaluatorText(const Json::Value& evaluator) {
    return fmt::format("{}: {}; error about {:.1g} of the peak, {:.3g} MiB", evaluator["name"].asString(),
                       evaluator["reason"].asString(), evaluator["estimated_error"].asDouble(),
                       static_cast<double>(evaluator["bytes"].asUInt64()) / (1024.0 * 1024.0));
}

void print(const Json::Value& info) {
    if (!info["description"].asString().empty()) fmt::print("{}\n\n", info["description"].asString());
    fmt::print("picture    {} x {}, {} sample(s) a pixel\n", info["image"]["width"].asUInt(),
               info["image"]["height"].asUInt(), info["image"]["samples"].asUInt());
    std::string objects;
    for (const std::string& type : info["objects"].getMemberNames()) {
        objects += fmt::format("{}{} {}", objects.empty() ? "" : ", ", info["objects"][type].asUInt(), type);
    }
    fmt::print("objects    {}\n", objects.empty() ? "none" : objects);
    fmt::print("materials  {}\n", info["materials"].asUInt());
    for (const Json::Value& light : info["lights"]) {
        const std::string power = light.isMember("power_W")
                                      ? fmt::format("{:g} W", light["power_W"].asDouble())
                                  : light.isMember("beam_power_W") ? beamText(light)
                                                                   : "no stated power";
        fmt::print("light      {} {}: {}\n", light["type"].asString(), light["name"].asString(), power);
        if (light.isMember("evaluator")) fmt::print("           by {}\n", evaluatorText(light["evaluator"]));
    }
    std::string features;
    for (const std::string& name : info["specialisation"].getMemberNames()) {
        const unsigned value = info["specialisation"][name].asUInt();
        if (value > 0) features += fmt::format(" {}{}", name, value > 1 ? fmt::format("={}", value) : "");
    }
    fmt::print("compiled  {}\n", features.empty() ? " nothing" : features);
    fmt::print("on device  scene {} bytes, film {} bytes (at most 64 MiB of it at once)\n",
               info["device_bytes"]["scene"].asUInt64(), info["device_bytes"]["whole_film"].asUInt64());
}

int showInfo(const InfoOptions& options) {
    const scene::Scene scene = parseSource(options.source, readTextFile(options.source.file));
    const Json::Value info = describe(scene);
    if (options.json) printJson(info);
    else print(info);
    if (!options.json) printWarnings(options.source.file, scene);
    return kDone;
}

}  // namespace

void addValidate(CLI::App& app, Command& chosen) {
    CLI::App* command =
        app.add_subcommand("validate", "Check scene files and list every problem; renders nothing");
    const auto options = std::make_shared<ValidateOptions>();
    command->add_option("SCENE", options->files, "scene files")->required();
    command->add_flag("--json", options->json, "print JSON");
    command->callback([=, &chosen] { chosen = [=] { return validate(*options); }; });
}

void addInfo(CLI::App& app, Command& chosen) {
    CLI::App* command = app.add_subcommand("info", "Say what a scene contains and what is compiled for it");
    const auto options = std::make_shared<InfoOptions>();
    addSceneOptions(*command, options->source);
    command->add_flag("--json", options->json, "print JSON");
    command->callback([=, &chosen] { chosen = [=] { return showInfo(*options); }; });
}

}  // namespace fringe::cli
