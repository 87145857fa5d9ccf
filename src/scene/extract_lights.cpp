#include <fmt/format.h>

#include <cassert>
#include <glm/geometric.hpp>

#include "scene/extract.hpp"

namespace fringe::scene {
namespace {

PointLight pointLightOf(const Node& node) {
    return {node["position"].vector(), node["power"].power()};
}

SpotLight spotLightOf(const Node& node) {
    const Node outer = node["angle"];
    const Node inner = node.has("inner_angle") ? node["inner_angle"] : outer;
    if (inner.angle() > outer.angle()) {
        inner.refuse(fmt::format("\"inner_angle\" is \"{}\"; write at most the angle, which is \"{}\"",
                                 inner.text(), outer.text()),
                     {outer});
    }
    return {node["position"].vector(), unitDirection(node["direction"]), outer.angle(), inner.angle(),
            node["power"].power()};
}

DirectionalLight directionalLightOf(const Node& node) {
    return {unitDirection(node["direction"]), node["irradiance"].irradiance()};
}

AreaLight areaLightOf(const Node& node) {
    const Node shape = node["shape"];
    const std::string type = shape["type"].text();
    const units::Power power = node["power"].power();
    const bool twoSided = node["two_sided"].flag();
    if (type == "rectangle") return {rectangleOf(shape), power, twoSided};
    if (type == "disc") return {discOf(shape), power, twoSided};
    assert(type == "sphere");
    return {sphereOf(shape), power, twoSided};
}

ThesisGrating gratingOf(const Node& node) {
    ThesisGrating grating;
    grating.position = node["position"].vector();
    grating.normal = unitDirection(node["normal"]);
    grating.slitDirection = unitDirection(node["slit_direction"]);
    if (!refuseParallel(
            node["slit_direction"], grating.slitDirection, node["normal"], grating.normal,
            "\"slit_direction\" is parallel to \"normal\", but slits lie in the plane of the grating")) {
        const dvec3 alongNormal = grating.normal * glm::dot(grating.slitDirection, grating.normal);
        grating.slitDirection = glm::normalize(grating.slitDirection - alongNormal);
    }
    grating.slits = slitsOf(node["aperture"]);
    grating.beamDiameter = node["beam"]["diameter"].length();
    grating.power = node["beam"]["power"].power();
    grating.attenuated = node["attenuation"].text() == "circular";
    grating.faults = faultsOf(node["faults"]);
    return grating;
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

Light lightOf(const Node& node) {
    Light light;
    if (node.has("name")) light.name = node["name"].text();
    light.color = node["color"].vector();
    const std::string type = node["type"].text();
    if (type == "point") {
        light.model = pointLightOf(node);
    } else if (type == "spot") {
        light.model = spotLightOf(node);
    } else if (type == "directional") {
        light.model = directionalLightOf(node);
    } else if (type == "area") {
        light.model = areaLightOf(node);
    } else if (type == "environment") {
        light.model = EnvironmentLight{node["radiance"].radiance()};
    } else {
        assert(type == "grating");
        light.model = gratingOf(node);
    }
    return light;
}

}  // namespace fringe::scene
