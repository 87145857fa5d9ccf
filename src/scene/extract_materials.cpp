#include <fmt/format.h>

#include <cassert>
#include <map>
#include <utility>

#include "optics/spectrum.hpp"
#include "scene/extract.hpp"
#include "scene/extract_spectra.hpp"

namespace fringe::scene {
namespace {

using units::mm, units::nm, units::um;

Metal metalOf(const Node& node) {
    static const std::map<std::string, Metal> metals{{"aluminium", Metal::aluminium},
                                                     {"silver", Metal::silver},
                                                     {"gold", Metal::gold},
                                                     {"copper", Metal::copper}};
    return metals.at(node.text());
}

// ---- optical discs -------------------------------------------------------------------------------

struct Medium {
    units::Length pitch;
    units::Length pitWidth;
    units::Length pitDepth;
    double pitShare;
    double coverIndex;
    std::optional<Metal> metal;
    units::Length hubRadius;
    units::Length dataInnerRadius;
    units::Length dataOuterRadius;
    double labelReflectance;
};

// Where the figures come from, and which of them no standard fixes, is in docs/scene-format.md.
const Medium& mediumOf(const Node& node) {
    static const Medium cd{1.6 * um,         500.0 * nm, 120.0 * nm, 0.5,       1.55,
                           Metal::aluminium, 22.0 * mm,  25.0 * mm,  58.0 * mm, 0.75};
    static const Medium dvd{740.0 * nm,       320.0 * nm, 105.0 * nm, 0.5,       1.58,
                            Metal::aluminium, 20.0 * mm,  24.0 * mm,  58.0 * mm, 0.75};
    static const Medium bluRay{320.0 * nm,    130.0 * nm, 66.0 * nm, 0.5,       1.53,
                               Metal::silver, 21.0 * mm,  24.0 * mm, 58.0 * mm, 0.75};
    static const Medium vinyl{113.0 * um,   56.0 * um, 28.0 * um, 1.0,        1.53,
                              std::nullopt, 50.0 * mm, 60.3 * mm, 146.3 * mm, 0.4};
    static const std::map<std::string, const Medium*> media{
        {"cd", &cd}, {"dvd", &dvd}, {"blu-ray", &bluRay}, {"vinyl", &vinyl}, {"custom", &cd}};
    return *media.at(node.text());
}

units::Length lengthOr(const Node& node, std::string_view key, units::Length standard) {
    return node.has(key) ? node[key].length() : standard;
}

std::string inUnits(units::Length length) {
    return length < 1.0 * mm ? fmt::format("{:.6g} um", length / um) : fmt::format("{:.6g} mm", length / mm);
}

// Records a problem if one length, which may be that of the medium, is not less than another. `limit` names
// the other; `orEqual` lets them be the same.
void requireOrder(const Node& node, std::string_view key, units::Length value, std::string_view limitKey,
                  units::Length limit, bool orEqual) {
    if (value < limit || (orEqual && value == limit)) return;
    const Node place = node.has(key) || !node.has(limitKey) ? node[key] : node[limitKey];
    place.refuse(fmt::format("\"{}\" is {}; write {} \"{}\", which is {}", key, inUnits(value),
                             orEqual ? "at most" : "less than", limitKey, inUnits(limit)),
                 {node[key], node[limitKey], node["medium"]});
}

OpticalDisc opticalDiscOf(const Node& node) {
    const Medium& medium = mediumOf(node["medium"]);
    if (node["medium"].text() == "custom") {
        for (const std::string_view key : {"pitch", "pit_width", "pit_depth"}) {
            if (!node.has(key)) {
                node["medium"].refuse(fmt::format(
                    "missing key \"{}\", which a custom medium needs; add a length such as \"0.5 um\"", key));
            }
        }
    }
    OpticalDisc disc;
    disc.pitch = lengthOr(node, "pitch", medium.pitch);
    disc.pitWidth = lengthOr(node, "pit_width", medium.pitWidth);
    disc.pitDepth = lengthOr(node, "pit_depth", medium.pitDepth);
    disc.pitShare = node.has("pit_share") ? node["pit_share"].number() : medium.pitShare;
    disc.coverIndex = node.has("cover_index") ? node["cover_index"].number() : medium.coverIndex;
    disc.metal = medium.metal;
    if (node.has("metal") && node["metal"].text() == "none") {
        disc.metal = std::nullopt;
    } else if (node.has("metal")) {
        disc.metal = metalOf(node["metal"]);
    }
    const units::Length hub = lengthOr(node, "hub_radius", medium.hubRadius);
    const units::Length inner = lengthOr(node, "data_inner_radius", medium.dataInnerRadius);
    const units::Length outer = lengthOr(node, "data_outer_radius", medium.dataOuterRadius);
    requireOrder(node, "pit_width", disc.pitWidth, "pitch", disc.pitch, false);
    requireOrder(node, "hub_radius", hub, "data_inner_radius", inner, true);
    requireOrder(node, "data_inner_radius", inner, "data_outer_radius", outer, false);
    disc.metalInnerRadius = hub.si;
    disc.dataInnerRadius = inner.si;
    disc.dataOuterRadius = outer.si;
    disc.labelReflectance = node.has("label_reflectance") ? shareOf(node["label_reflectance"])
                                                          : optics::constantCurve(medium.labelReflectance);
    disc.castsLight = node["casts_light"].flag();
    if (node.has("efficiencies")) disc.efficiencies = efficienciesOf(node["efficiencies"]);
    return disc;
}

}  // namespace

Material materialOf(const std::string& name, const Node& node) {
    const std::string type = node["type"].text();
    if (type == "diffuse") return {name, Diffuse{shareOf(node["reflectance"])}};
    if (type == "conductor") return {name, Conductor{metalOf(node["metal"])}};
    if (type == "dielectric") return {name, Dielectric{node["ior"].number()}};
    if (type == "emissive") {
        return {name,
                Emissive{node["radiance"].radiance(), tinted(spectrumOf(node["spectrum"]), node["color"]),
                         node["two_sided"].flag()}};
    }
    assert(type == "optical-disc");
    if (node["model"].text() == "physical") return {name, opticalDiscOf(node)};
    return {name, ThesisDisc{slitsOf(node["slits"]), node["mirror_reflectance"].number(),
                             faultsOf(node["faults"])}};
}

}  // namespace fringe::scene
