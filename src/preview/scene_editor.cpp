#include "preview/scene_editor.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <optional>

#include "preview/schema_values.hpp"
#include "preview/value_widgets.hpp"
#include "scene/schema.hpp"

namespace fringe::preview {
namespace {

using scene::Property;
using scene::Schema;

struct Change {
    std::string path;
    Json::Value value;
};

std::optional<Change> drawAny(const Schema& schema, const std::string& label, const Json::Value& value,
                              const std::string& path);

// What the schema says about the widget that was drawn last, beside the panel while the mouse is on it.
void explain(const Schema& schema) {
    constexpr float kWidth = 26.0F;  // in heights of text
    if (!ImGui::IsItemHovered() || ImGui::IsAnyItemActive()) return;
    std::string text = schema.description;
    if (isDirection(schema)) {
        if (!text.empty()) text += '\n';
        text += "Here by two angles: around the vertical, from +z on to +x, and above the horizon.";
    }
    if (text.empty()) return;
    ImGui::SetNextWindowPos({ImGui::GetWindowPos().x + ImGui::GetWindowWidth(), ImGui::GetItemRectMin().y});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(kWidth * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

// A key that is not there: a button that adds it.
std::optional<Change> drawMissing(const Property& property, const std::string& path) {
    std::optional<Change> change;
    if (ImGui::SmallButton(fmt::format("+ {}", property.name).c_str()))
        change = Change{path, exampleOf(property.schema)};
    explain(property.schema);
    return change;
}

// A key that could as well be left out: a button that takes it away, which changes the object.
std::optional<Change> drawRemoval(const Property& property, const Json::Value& object,
                                  const std::string& path) {
    const bool isOptional =
        !property.required && property.schema.defaultValue.isNull() && object.isMember(property.name);
    if (!isOptional) return std::nullopt;
    const bool isPressed = ImGui::SmallButton("x");
    ImGui::SameLine();
    if (!isPressed) return std::nullopt;
    Json::Value without = object;
    without.removeMember(property.name);
    return Change{path, without};
}

std::optional<Change> drawObject(const Schema& schema, const Json::Value& object, const std::string& path) {
    std::optional<Change> change;
    for (const Property& property : schema.properties) {
        if (property.isConstant() || property.name == "name") continue;
        const std::string inner = fmt::format("{}.{}", path, property.name);
        ImGui::PushID(property.name.c_str());
        const bool isThere = object.isMember(property.name);
        if (isThere || !property.schema.defaultValue.isNull()) {
            if (auto removed = drawRemoval(property, object, path)) change = removed;
            const Json::Value& value = isThere ? object[property.name] : property.schema.defaultValue;
            if (auto changed = drawAny(property.schema, property.name, value, inner)) change = changed;
        } else if (auto added = drawMissing(property, inner)) {
            change = added;
        }
        ImGui::PopID();
    }
    return change;
}

// Which of several forms a value has.
std::optional<Change> drawForm(const Schema& schema, const Schema* form, const std::string& label,
                               const Json::Value& value, const std::string& path) {
    std::optional<Change> change;
    const std::string shown = form != nullptr ? labelOf(*form) : "?";
    const bool isOpen = ImGui::BeginCombo(label.c_str(), shown.c_str());
    explain(schema);
    if (!isOpen) return change;
    for (const Schema& other : schema.alternatives) {
        const bool isChosen = ImGui::Selectable(labelOf(other).c_str(), &other == form);
        if (isChosen && &other != form) change = Change{path, adapted(value, other)};
    }
    ImGui::EndCombo();
    return change;
}

std::optional<Change> drawArray(const Schema& schema, const Json::Value& array, const std::string& path) {
    constexpr Json::ArrayIndex kMost = 32;  // of an array's elements; longer ones are for an editor
    std::optional<Change> change;
    for (Json::ArrayIndex i = 0; i < std::min(array.size(), kMost); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (array.size() > schema.minItems) {
            if (ImGui::SmallButton("x")) {
                change = Change{path, array};
                change->value.removeIndex(i, nullptr);
            }
            ImGui::SameLine();
        }
        if (auto changed = drawAny(*schema.items, fmt::to_string(i), array[i], fmt::format("{}.{}", path, i)))
            change = changed;
        ImGui::PopID();
    }
    if (array.size() < std::min<std::size_t>(schema.maxItems.value_or(kMost), kMost) &&
        ImGui::SmallButton("+")) {
        change = Change{path, array};
        change->value.append(array.empty() ? exampleOf(*schema.items) : array[array.size() - 1]);
    }
    return change;
}

std::optional<Change> drawAny(const Schema& schema, const std::string& label, const Json::Value& value,
                              const std::string& path) {
    if (isSimple(schema)) {
        const auto changed = drawValue(schema, label.c_str(), value);
        explain(schema);
        return changed ? std::optional(Change{path, *changed}) : std::nullopt;
    }
    if (!schema.alternatives.empty()) {
        const Schema* form = scene::alternativeFor(schema, value);
        std::optional<Change> change = drawForm(schema, form, label, value, path);
        if (form == nullptr) return change;
        const bool isScalar = isSimple(*form);
        ImGui::Indent();
        ImGui::PushID("form");
        if (isScalar || !form->properties.empty() || form->items != nullptr) {
            // The list above says already what it is.
            auto changed = isScalar           ? drawAny(*form, "##value", value, path)
                           : value.isObject() ? drawObject(*form, value, path)
                                              : drawAny(*form, label, value, path);
            if (changed) change = changed;
        }
        ImGui::PopID();
        ImGui::Unindent();
        return change;
    }
    std::optional<Change> change;
    const bool isUnfolded = ImGui::TreeNodeEx(label.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
    explain(schema);
    if (!isUnfolded) return change;
    if (value.isObject()) change = drawObject(schema, value, path);
    else if (value.isArray() && schema.items != nullptr) change = drawArray(schema, value, path);
    ImGui::TreePop();
    return change;
}

// One light, material or object under a line of its own.
std::optional<Change> drawEntry(const Schema& schema, const std::string& name, const Json::Value& value,
                                const std::string& path, bool isOpen) {
    std::optional<Change> change;
    ImGui::PushID(path.c_str());
    if (ImGui::TreeNodeEx(name.c_str(), isOpen ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None)) {
        const Schema* form = scene::alternativeFor(schema, value);
        if (form == nullptr) ImGui::TextWrapped("see the message below the picture");
        else change = drawObject(*form, value, path);
        if (form != nullptr && &schema != form) {
            if (auto other = drawForm(schema, form, "kind", value, path)) change = other;
        }
        ImGui::TreePop();
    }
    ImGui::PopID();
    return change;
}

std::optional<Change> drawEntries(const Schema& schema, const Json::Value& entries, const std::string& path,
                                  bool opensFirstGrating) {
    std::optional<Change> change;
    for (Json::ArrayIndex i = 0; i < entries.size(); ++i) {
        const Json::Value& value = entries[i];
        if (!value.isObject()) continue;
        const bool isOpen = opensFirstGrating && value["type"] == "grating";
        opensFirstGrating = opensFirstGrating && !isOpen;
        if (auto changed =
                drawEntry(*schema.items, entryName(value, i), value, fmt::format("{}.{}", path, i), isOpen))
            change = changed;
    }
    return change;
}

std::optional<Change> drawMaterials(const Schema& schema, const Json::Value& materials) {
    std::optional<Change> change;
    for (const std::string& name : materials.getMemberNames()) {
        if (name.find('.') != std::string::npos) continue;  // no path leads there
        const bool isOpen = materials[name]["type"] == "optical-disc";
        if (auto changed = drawEntry(*schema.mapped, name, materials[name], "materials." + name, isOpen))
            change = changed;
    }
    return change;
}

// What of the camera is no matter of where it stands.
std::optional<Change> drawCamera(const Schema& schema, const Json::Value& camera) {
    std::optional<Change> change;
    const Schema* form = scene::alternativeFor(schema, camera);
    if (form == nullptr) return change;
    for (const Property& property : form->properties) {
        const std::string& name = property.name;
        if (property.isConstant() || name == "position" || name == "target" || name == "up") continue;
        const std::string path = "camera." + name;
        ImGui::PushID(name.c_str());
        if (camera.isMember(name) || !property.schema.defaultValue.isNull()) {
            if (auto removed = drawRemoval(property, camera, "camera")) change = removed;
            const Json::Value& value = camera.isMember(name) ? camera[name] : property.schema.defaultValue;
            if (auto changed = drawAny(property.schema, name, value, path)) change = changed;
        } else if (auto added = drawMissing(property, path)) {
            change = added;
        }
        ImGui::PopID();
    }
    return change;
}

}  // namespace

std::string entryName(const Json::Value& value, Json::ArrayIndex index) {
    const std::string type = value["type"].isString() ? value["type"].asString() : "?";
    if (!value["name"].isString()) return fmt::format("{} {}", index, type);
    return fmt::format("{} ({})", value["name"].asString(), type);
}

bool drawSceneEditor(Document& document) {
    const Schema& schema = scene::sceneSchema();
    const Json::Value& root = document.root();
    const auto of = [&](const char* key) -> const Schema& { return schema.find(key)->schema; };
    std::optional<Change> change;
    const auto section = [&](const char* title, const char* key, bool isOpen, auto draw) {
        const Json::Value& value = root.isMember(key) ? root[key] : of(key).defaultValue;
        if (value.isNull()) return;
        if (!ImGui::CollapsingHeader(title,
                                     isOpen ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None))
            return;
        ImGui::PushID(key);
        if (auto changed = draw(of(key), value)) change = changed;
        ImGui::PopID();
    };
    const auto isGrating = [](const Json::Value& light) {
        return light.isObject() && light["type"] == "grating";
    };
    const Json::Value& lights = root["lights"];
    const bool hasGratings = std::any_of(lights.begin(), lights.end(), isGrating);
    section("Lights", "lights", true,
            [](const Schema& s, const Json::Value& v) { return drawEntries(s, v, "lights", true); });
    section("Materials", "materials", !hasGratings, drawMaterials);  // of discs, then
    section("Objects", "objects", false,
            [](const Schema& s, const Json::Value& v) { return drawEntries(s, v, "objects", false); });
    section("Camera", "camera", false, drawCamera);
    section("Image", "image", false,
            [](const Schema& s, const Json::Value& v) { return drawObject(s, v, "image"); });
    if (change) document.set(change->path, change->value);
    return change.has_value();
}

}  // namespace fringe::preview
