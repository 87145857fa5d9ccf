#include "cli/grating_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "compile/evaluators.hpp"
#include "compile/gratings.hpp"
#include "compile/near_field.hpp"
#include "compile/warnings.hpp"

namespace fringe::cli {
namespace {

using glm::dvec2;

constexpr double kDistance = 1.0;  // m

// Half of what an aperture covers across the slits and along them, in metres.
struct HalfExtent {
    dvec2 operator()(const optics::Slits& a) const {
        return {0.5 * (a.count - 1.0) * (a.period / units::m) + 0.5 * (a.width / units::m),
                std::numeric_limits<double>::infinity()};
    }
    dvec2 operator()(const optics::RectangularAperture& a) const {
        return {0.5 * (a.width / units::m), 0.5 * (a.height / units::m)};
    }
    dvec2 operator()(const optics::CircularAperture& a) const { return dvec2(0.5 * (a.diameter / units::m)); }
    dvec2 operator()(const optics::PolygonalAperture& a) const {
        dvec2 half(0.0);
        for (const dvec2& vertex : a.vertices) half = glm::max(half, glm::abs(vertex));
        return half;
    }
    dvec2 operator()(const optics::MaskAperture& a) const {
        return 0.5 * (a.pixel / units::m) * dvec2(a.columns, a.rows);
    }
    dvec2 operator()(const optics::LatticeAperture& a) const {
        return std::visit(*this, a.cell) + 0.5 * (a.firstCount - 1.0) * glm::abs(a.first) +
               0.5 * (a.secondCount - 1.0) * glm::abs(a.second);
    }
};

}  // namespace

Json::Value describeEvaluator(const scene::Grating& grating, const optics::Spectrum& spectrum,
                              compile::ResponseRows rows, double tolerance) {
    const auto* slits = std::get_if<optics::Slits>(&grating.aperture);
    if (slits == nullptr) return {};
    const compile::EvaluatorChoice choice =
        compile::chooseEvaluator(grating, *slits, spectrum, rows, tolerance);
    Json::Value json;
    json["name"] = compile::nameOf(choice.evaluator);
    json["reason"] = choice.reason;
    if (choice.wavelengths > 0) json["wavelengths"] = choice.wavelengths;
    json["estimated_error"] = choice.error;
    json["cost_in_look_ups"] = choice.cost;
    json["bytes"] = Json::UInt64{choice.bytes};
    return json;
}

Json::Value describeGrating(const scene::Grating& grating) {
    const scene::Beam& beam = grating.beam;
    const dvec2 beamSize(beam.width / units::m, beam.height / units::m);
    const dvec2 half = glm::min(std::visit(HalfExtent{}, grating.aperture), 0.5 * beamSize);
    const dvec2 fresnel = half * half / (compile::kFresnelWavelength * kDistance);

    Json::Value json;
    json["model"] = "physical";
    json["beam_power_W"] = beam.power / units::W;
    json["leaving_power_W"] = beam.power / units::W * compile::leavingShare(grating);
    json["fresnel_number_at_1_m"]["across"] = fresnel.x;
    json["fresnel_number_at_1_m"]["along"] = fresnel.y;
    return json;
}

Json::Value warningsJson(const scene::Scene& scene) {
    Json::Value json(Json::arrayValue);
    for (const auto& [light, message] : compile::warningsOf(scene)) {
        Json::Value warning;
        warning["light"] = light;
        warning["message"] = message;
        json.append(warning);
    }
    return json;
}

void printWarnings(const std::string& file, const scene::Scene& scene) {
    for (const auto& [light, message] : compile::warningsOf(scene))
        fmt::print(stderr, "{}: warning: {}: {}\n", file, light, message);
}

}  // namespace fringe::cli
