#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <variant>

#include "scene/extract.hpp"
#include "scene/extract_spectra.hpp"

namespace fringe::scene {
namespace {

// Sine of the angle between a beam and the plane of its grating below which they are parallel.
constexpr double kGrazing = 1e-6;

dvec3 slitDirectionOf(const Node& light, const dvec3& normal) {
    const Node node = light["slit_direction"];
    const dvec3 direction = unitDirection(node);
    const bool parallel = refuseParallel(
        node, direction, light["normal"], normal,
        "\"slit_direction\" is parallel to \"normal\", but slits lie in the plane of the grating");
    if (parallel || direction == dvec3(0.0)) return direction;
    return glm::normalize(direction - normal * glm::dot(direction, normal));
}

// The way the beam goes, which is to the side that `light` says.
dvec3 beamDirectionOf(const Node& light, const dvec3& normal) {
    const bool passes = light["side"].text() == "transmission";
    const dvec3 outward = passes ? normal : -normal;
    if (!light["beam"].has("direction")) return outward;
    const Node node = light["beam"]["direction"];
    const dvec3 direction = unitDirection(node);
    if (direction == dvec3(0.0) || normal == dvec3(0.0)) return direction;  // has its problem already
    const double along = glm::dot(direction, outward);
    if (along >= kGrazing) return direction;
    if (along > -kGrazing) {
        node.refuse(
            fmt::format("the beam goes along the grating and never meets it; write a direction such as {}",
                        written(outward)),
            {light["normal"]});
        return direction;
    }
    const dvec3 mirrored = direction - 2.0 * along * outward;
    node.refuse(
        fmt::format(
            "the beam goes {0} \"normal\", but in {1} it goes {2} it; write {3}, or \"side\": \"{4}\"",
            passes ? "against" : "along", passes ? "transmission" : "reflection",
            passes ? "along" : "against", written(mirrored), passes ? "reflection" : "transmission"),
        {light["normal"], light["side"]});
    return direction;
}

Beam beamOf(const Node& light, const dvec3& normal) {
    static const std::map<std::string, BeamProfile> profiles{{"flat", BeamProfile::flat},
                                                             {"gaussian", BeamProfile::gaussian},
                                                             {"rectangle", BeamProfile::rectangle}};
    const Node node = light["beam"];
    Beam beam;
    beam.profile = profiles.at(node["profile"].text());
    const bool rectangle = beam.profile == BeamProfile::rectangle;
    beam.width = node[rectangle ? "width" : "diameter"].length();
    beam.height = node[rectangle ? "height" : "diameter"].length();
    beam.direction = beamDirectionOf(light, normal);
    beam.power = node["power"].power();
    beam.angularSize = node["angular_size"].angle();
    if (node.has("focus")) beam.focus = node["focus"].length();
    return beam;
}

// ---- whether an aperture lies in its beam --------------------------------------------------------

// Points of the grating's plane, each the middle of a disc, whose convex hull covers the aperture.
struct Outline {
    std::vector<glm::dvec2> points;  // metres
    double radius = 0.0;
};

Outline outlineOf(const optics::RectangularAperture& rectangle) {
    const double x = 0.5 * rectangle.width.si;
    const double y = 0.5 * rectangle.height.si;
    return {{{x, y}, {-x, y}, {-x, -y}, {x, -y}}};
}

Outline outlineOf(const optics::CircularAperture& circle) {
    return {{{0.0, 0.0}}, 0.5 * circle.diameter.si};
}

Outline outlineOf(const optics::PolygonalAperture& polygon) {
    return {polygon.vertices};
}

Outline outlineOf(const optics::LatticeAperture& lattice) {
    const Outline cell = std::visit([](const auto& opening) { return outlineOf(opening); }, lattice.cell);
    const glm::dvec2 row = 0.5 * (lattice.firstCount - 1.0) * lattice.first;
    const glm::dvec2 column = 0.5 * (lattice.secondCount - 1.0) * lattice.second;
    Outline outline{{}, cell.radius};
    for (const glm::dvec2& corner : {row + column, row - column, column - row, -row - column}) {
        for (const glm::dvec2& point : cell.points) outline.points.push_back(corner + point);
    }
    return outline;
}

Outline outlineOf(const optics::MaskAperture& mask) {
    return outlineOf(optics::RectangularAperture{static_cast<double>(mask.columns) * mask.pixel,
                                                 static_cast<double>(mask.rows) * mask.pixel});
}

// What part of the beam's cross-section the outline reaches to, from the middle: at most 1 inside. A point
// of the grating is in the beam where its part across the beam is.
double reachOf(const Outline& outline, const Grating& grating) {
    const dvec3 x = glm::cross(grating.slitDirection, grating.normal);
    const Beam& beam = grating.beam;
    double reach = 0.0;
    for (const glm::dvec2& point : outline.points) {
        const dvec3 inPlane = point.x * x + point.y * grating.slitDirection;
        const dvec3 across = inPlane - glm::dot(inPlane, beam.direction) * beam.direction;
        if (beam.profile == BeamProfile::flat) {
            reach = std::max(reach, 2.0 * (glm::length(across) + outline.radius) / beam.width.si);
        } else {
            const double alongX = std::abs(glm::dot(across, x)) + outline.radius;
            const double alongY = std::abs(glm::dot(across, grating.slitDirection)) + outline.radius;
            reach = std::max({reach, 2.0 * alongX / beam.width.si, 2.0 * alongY / beam.height.si});
        }
    }
    return reach;
}

std::string inMillimetres(double factor, units::Length length) {
    return fmt::format("{:.4g} mm", std::ceil(factor * length.si * 1e6) * 1e-3);
}

void requireInBeam(const Node& light, const Grating& grating) {
    // Lengths that are equal as written may differ by the rounding of their units.
    constexpr double kRounding = 1e-9;
    if (std::holds_alternative<Slits>(grating.aperture) || grating.beam.profile == BeamProfile::gaussian)
        return;
    const double reach = std::visit(
        [&](const auto& aperture) {
            if constexpr (std::is_same_v<decltype(aperture), const Slits&>) {
                return 0.0;
            } else {
                return reachOf(outlineOf(aperture), grating);
            }
        },
        grating.aperture);
    if (reach <= 1.0 + kRounding) return;
    const Node beam = light["beam"];
    const Beam& is = grating.beam;
    const std::string size =
        is.profile == BeamProfile::flat
            ? fmt::format("a \"diameter\" of {}", inMillimetres(reach, is.width))
            : fmt::format("a \"width\" of {} and a \"height\" of {}", inMillimetres(reach, is.width),
                          inMillimetres(reach, is.height));
    beam.refuse(
        fmt::format("the aperture reaches out of the beam, to {:.4g} times its size; write {} at least, "
                    "a smaller aperture, or the profile \"gaussian\", which has no edge",
                    reach, size),
        {light["aperture"]});
}

void takeEfficiencies(const Node& light, Grating& grating) {
    const Node efficiencies = light["efficiencies"];
    grating.efficiencies = efficienciesOf(efficiencies);
    if (grating.efficiency) {
        light["efficiency"].refuse(
            "\"efficiency\" stands beside \"efficiencies\", which say the same in detail; keep one of them",
            {efficiencies});
    }
    if (!std::holds_alternative<Slits>(grating.aperture)) {
        efficiencies.refuse("only slits have orders of their own; write \"efficiency\" for other apertures",
                            {light["aperture"]});
    }
}

bool sumsOverWavelengths(Evaluator evaluator) {
    return evaluator == Evaluator::direct || evaluator == Evaluator::smallAngle ||
           evaluator == Evaluator::naive;
}

void takeEvaluator(const Node& light, Grating& grating) {
    static const std::map<std::string, Evaluator> evaluators{
        {"auto", Evaluator::automatic},         {"table", Evaluator::table}, {"direct", Evaluator::direct},
        {"small-angle", Evaluator::smallAngle}, {"naive", Evaluator::naive}, {"orders", Evaluator::orders}};
    const Node node = light["evaluator"];
    grating.evaluator = evaluators.at(node.text());
    if (grating.evaluator != Evaluator::automatic && !std::holds_alternative<Slits>(grating.aperture)) {
        node.refuse(
            fmt::format("\"{}\" is a way to the colour of slits; other apertures are always a sum over "
                        "wavelengths, so leave it out",
                        node.text()),
            {light["aperture"]});
    }
    if (grating.evaluator != Evaluator::automatic && grating.evaluator != Evaluator::table &&
        light.has("efficiencies")) {
        node.refuse(fmt::format("\"{}\" knows the orders of slits in an opaque screen alone; with "
                                "\"efficiencies\" write \"table\" or \"auto\"",
                                node.text()),
                    {light["efficiencies"]});
    }
    if (!light.has("wavelengths")) return;
    const Node wavelengths = light["wavelengths"];
    grating.wavelengths = wavelengths.count();
    if (!sumsOverWavelengths(grating.evaluator)) {
        wavelengths.refuse(
            fmt::format("\"wavelengths\" is for the evaluators \"direct\", \"small-angle\" and \"naive\", "
                        "but this one is \"{}\"; leave it out, or choose one of them",
                        node.text()),
            {node});
    }
}

}  // namespace

Slits slitsOf(const Node& node) {
    const Node width = node["width"];
    const Node period = node["period"];
    const Slits slits{node["count"].count(), width.length(), period.length()};
    if (slits.count > 1 && slits.width > slits.period) {
        width.refuse(
            fmt::format(
                "\"width\" is \"{}\"; write at most the period, which is \"{}\", or the slits overlap",
                width.text(), period.text()),
            {period});
    }
    return slits;
}

Faults faultsOf(const Node& node) {
    return node.text() == "as-printed" ? Faults::asPrinted : Faults::limit;
}

ThesisGrating thesisGratingOf(const Node& light) {
    ThesisGrating grating;
    grating.position = light["position"].vector();
    grating.normal = unitDirection(light["normal"]);
    grating.slitDirection = slitDirectionOf(light, grating.normal);
    grating.slits = slitsOf(light["aperture"]);
    grating.beamDiameter = light["beam"]["diameter"].length();
    grating.power = light["beam"]["power"].power();
    grating.attenuated = light["attenuation"].text() == "circular";
    grating.faults = faultsOf(light["faults"]);
    return grating;
}

Grating gratingOf(const Node& light) {
    Grating grating;
    grating.position = light["position"].vector();
    grating.normal = unitDirection(light["normal"]);
    grating.slitDirection = slitDirectionOf(light, grating.normal);
    grating.aperture = apertureOf(light["aperture"]);
    grating.beam = beamOf(light, grating.normal);
    requireInBeam(light, grating);
    if (light.has("efficiency")) grating.efficiency = light["efficiency"].number();
    if (light.has("efficiencies")) takeEfficiencies(light, grating);
    takeEvaluator(light, grating);
    return grating;
}

}  // namespace fringe::scene
