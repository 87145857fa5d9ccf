#include <fmt/format.h>

#include <cassert>

#include "scene/extract.hpp"
#include "scene/extract_spectra.hpp"

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
    return {unitDirection(node["direction"]), node["irradiance"].irradiance(), node["angular_size"].angle()};
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

}  // namespace

Light lightOf(const Node& node) {
    Light light;
    if (node.has("name")) light.name = node["name"].text();
    light.color = node["color"].vector();
    const std::string type = node["type"].text();
    if (type == "grating" && node["model"].text() == "thesis") {
        light.model = thesisGratingOf(node);
        return light;
    }
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
        const Node beam = node["beam"];
        light.spectrum = tinted(spectrumOf(beam["spectrum"], beam["linewidth"].length()), node["color"]);
        return light;
    }
    light.spectrum = tinted(spectrumOf(node["spectrum"]), node["color"]);
    return light;
}

}  // namespace fringe::scene
