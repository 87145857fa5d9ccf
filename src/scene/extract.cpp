#include "scene/extract.hpp"

#include <fmt/format.h>

#include <cassert>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "scene/extract_spectra.hpp"
#include "scene/wording.hpp"

namespace fringe::scene {
namespace {

ColorSpace colorSpaceOf(const Node& node) {
    static const std::map<std::string, ColorSpace> spaces{
        {"srgb", ColorSpace::srgb}, {"display-p3", ColorSpace::displayP3}, {"rec2020", ColorSpace::rec2020}};
    return spaces.at(node.text());
}

Image imageOf(const Node& node) {
    const Node exposure = node["exposure"];
    return {.width = node["width"].count(),
            .height = node["height"].count(),
            .samples = node["samples"].count(),
            .seed = node["seed"].count(),
            .maxDepth = node["max_depth"].count(),
            .exposure = exposure.isNumber() ? exposure.number() : 0.0,
            .autoExposure = exposure.isText(),
            .colorSpace = colorSpaceOf(node["color_space"]),
            .tolerance = node["tolerance"].number()};
}

Camera cameraOf(const Node& node) {
    Camera camera;
    const Node target = node["target"];
    camera.position = node["position"].vector();
    camera.target = target.vector();
    camera.up = unitDirection(node["up"]);
    if (node.has("white_balance")) camera.whiteBalance = spectrumOf(node["white_balance"]);
    const dvec3 view = camera.target - camera.position;
    if (glm::length(view) < kSmallestSize) {
        target.refuse("\"target\" is the same point as \"position\"; write a point that the camera looks at",
                      {node["position"]});
    } else {
        refuseParallel(node["up"], camera.up, target, glm::normalize(view),
                       "\"up\" is along the view from \"position\" to \"target\"");
    }
    if (node["type"].text() == "orthographic") {
        camera.projection = Orthographic{node["height"].number()};
        return camera;
    }
    Perspective perspective{node["fov"].angle(), std::nullopt};
    if (node.has("lens")) {
        const Node lens = node["lens"];
        perspective.lens = ThinLens{lens["diameter"].length(), lens["focus_distance"].length()};
    }
    camera.projection = perspective;
    return camera;
}

// Reads the parts of the scene in their order. Names and references are checked even in elements that are
// otherwise unsound, so that one run finds all problems.
class Extraction {
public:
    Extraction(const Json::Value& root, const Unsound& unsound, Surroundings& surroundings)
        : root_(root), unsound_(unsound), surroundings_(surroundings) {}

    Scene scene() {
        if (!root_.isObject()) return {};
        Scene scene;
        if (const auto node = part("description")) scene.description = node->text();
        if (const auto node = part("image")) scene.image = imageOf(*node);
        if (const auto node = part("camera")) scene.camera = cameraOf(*node);
        extractMaterials(scene);
        extractObjects(scene);
        extractLights(scene);
        return scene;
    }

private:
    // A part of the scene, or its default; empty if it is unsound or missing.
    std::optional<Node> part(std::string_view key) const {
        const Property* property = sceneSchema().find(key);
        assert(property != nullptr);
        const Json::Value* found = root_.find(key.data(), key.data() + key.size());
        if (found != nullptr && unsound_.contains(found)) return std::nullopt;
        if (found == nullptr && property->required) return std::nullopt;
        const Json::Value& value = found != nullptr ? *found : property->schema.defaultValue;
        return Node(property->name, value, property->schema, value.getOffsetStart(), surroundings_);
    }

    // The elements of an array or the values of a map, sound or not; none if it is no such thing.
    const Json::Value& members(const char* key, bool (Json::Value::*isRight)() const) const {
        static const Json::Value kNone;  // null has no members
        const Json::Value& value = root_[key];
        return (value.*isRight)() ? value : kNone;
    }

    void extractMaterials(Scene& scene) {
        const Schema& schema = *sceneSchema().find("materials")->schema.mapped;
        const Json::Value& materials = members("materials", &Json::Value::isObject);
        for (auto member = materials.begin(); member != materials.end(); ++member) {
            materialNames_.push_back(member.name());
            if (unsound_.contains(&*member)) continue;
            materialIndices_[member.name()] = static_cast<std::uint32_t>(scene.materials.size());
            const Node node("materials", *member, schema, member->getOffsetStart(), surroundings_);
            materialTypes_.push_back(node["type"]);
            scene.materials.push_back(materialOf(member.name(), node));
        }
    }

    void extractObjects(Scene& scene) {
        const Schema& schema = *sceneSchema().find("objects")->schema.items;
        const Json::Value& objects = members("objects", &Json::Value::isArray);
        checkNames(objects, "objects");
        scene.objects.reserve(objects.size());
        for (const Json::Value& value : objects) {
            checkReference(value);
            if (unsound_.contains(&value)) continue;
            const Node node("objects", value, schema, value.getOffsetStart(), surroundings_);
            Object object{node.has("name") ? node["name"].text() : std::string(), shapeOf(node), 0};
            const auto material = materialIndices_.find(node["material"].text());
            if (material == materialIndices_.end()) continue;  // has its problem already
            object.material = material->second;
            checkDiscMaterial(node, object, scene.materials[object.material]);
            scene.objects.push_back(std::move(object));
        }
    }

    void extractLights(Scene& scene) {
        const Schema& schema = *sceneSchema().find("lights")->schema.items;
        const Json::Value& lights = members("lights", &Json::Value::isArray);
        checkNames(lights, "lights");
        std::optional<Node> environment;
        for (const Json::Value& value : lights) {
            if (unsound_.contains(&value)) continue;
            const Node node("lights", value, schema, value.getOffsetStart(), surroundings_);
            scene.lights.push_back(lightOf(node));
            if (!std::holds_alternative<EnvironmentLight>(scene.lights.back().model)) continue;
            if (environment) {
                node["type"].refuse("a second environment light; keep one, and add up their radiances",
                                    {*environment});
            }
            environment = node["type"];
        }
    }

    void checkNames(const Json::Value& elements, std::string_view owner) {
        struct First {
            Json::ArrayIndex index;
            std::ptrdiff_t offset;
        };
        std::unordered_map<std::string, First> taken;
        Json::ArrayIndex index = 0;
        for (const Json::Value& element : elements) {
            const Json::ArrayIndex here = index++;
            if (!element.isObject() || !element["name"].isString()) continue;
            const std::string name = element["name"].asString();
            const std::ptrdiff_t offset = element["name"].getOffsetStart();
            const auto [first, isNew] = taken.emplace(name, First{here, offset});
            if (isNew || name.empty()) continue;
            const bool madeByOverride = isOverride(first->second.offset) && !isOverride(offset);
            surroundings_.findings.push_back(
                {madeByOverride ? first->second.offset : offset,
                 fmt::format("\"{0}\"[{1}] and [{2}] both have the name {3}; give each of the {0} its own",
                             owner, first->second.index, here, inQuotes(name))});
        }
    }

    void checkReference(const Json::Value& object) {
        if (!object.isObject() || !object["material"].isString()) return;
        const Json::Value& reference = object["material"];
        const std::string name = reference.asString();
        if (members("materials", &Json::Value::isObject).isMember(name)) return;
        const std::string remedy = materialNames_.empty() ? "add it to \"materials\", which is empty"
                                                          : suggestion(name, materialNames_, "write");
        surroundings_.findings.push_back(
            {reference.getOffsetStart(), fmt::format("no material is named {}; {}", inQuotes(name), remedy)});
    }

    // Tracks run round the centre and the axis of a disc, which other shapes do not have.
    void checkDiscMaterial(const Node& node, const Object& object, const Material& material) const {
        if (!std::holds_alternative<ThesisDisc>(material.model) &&
            !std::holds_alternative<OpticalDisc>(material.model)) {
            return;
        }
        if (std::holds_alternative<Disc>(object.shape)) return;
        node["material"].refuse(fmt::format("{} is an optical disc; give it only to objects of type \"disc\"",
                                            inQuotes(material.name)),
                                {node["type"], materialTypes_[object.material]});
    }

    const Json::Value& root_;
    const Unsound& unsound_;
    Surroundings& surroundings_;
    std::vector<std::string> materialNames_;                // of all, sound or not
    std::map<std::string, std::uint32_t> materialIndices_;  // into Scene::materials and materialTypes_
    std::vector<Node> materialTypes_;
};

}  // namespace

Scene extractScene(const Json::Value& root, const Unsound& unsound, Surroundings& surroundings) {
    return Extraction(root, unsound, surroundings).scene();
}

}  // namespace fringe::scene
