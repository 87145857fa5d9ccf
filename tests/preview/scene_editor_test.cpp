// The editor has a widget for everything that the schema lets a scene say.
#include "preview/scene_editor.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "preview/schema_values.hpp"
#include "scene/schema.hpp"

namespace fringe::preview {
namespace {

using scene::JsonType;
using scene::Property;
using scene::Schema;
using Counts = std::map<std::string, int>;

// Dear ImGui without a window: what it would write there comes as text.
class SceneEditorTest : public testing::Test {
protected:
    SceneEditorTest() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {400.0F, 400.0F};
        io.Fonts->Build();
        io.ClipboardUserData = &written_;
        io.SetClipboardTextFn = [](void* to, const char* text) { *static_cast<std::string*>(to) = text; };
    }
    ~SceneEditorTest() override { ImGui::DestroyContext(); }

    // How often each word is written with one section unfolded, and everything in it.
    Counts wordsOf(const Json::Value& root, const char* section) {
        Document document({fileText(root), "scene.json", {}});
        ImGui::NewFrame();
        ImGui::SetNextWindowSize({300.0F, 300.0F});
        ImGui::Begin("panel");
        for (const char* title : {"Lights", "Materials", "Objects", "Camera", "Image"})
            ImGui::GetStateStorage()->SetInt(ImGui::GetID(title), std::string(section) == title ? 1 : 0);
        ImGui::LogToClipboard(1000);
        drawSceneEditor(document);
        ImGui::LogFinish();
        ImGui::End();
        ImGui::Render();
        Counts counts;
        std::istringstream words(written_);
        for (std::string word; words >> word;) ++counts[word];
        return counts;
    }

    std::string written_;
};

// The keys that have a widget: but for the one value that makes a kind, and for names.
void countKeys(const Schema& schema, const Json::Value& value, Counts& keys) {
    const Schema* form = scene::alternativeFor(schema, value);
    ASSERT_NE(form, nullptr) << jsonText(value);
    if (value.isArray() && form->items != nullptr)
        for (const Json::Value& item : value) countKeys(*form->items, item, keys);
    if (!value.isObject()) return;
    for (const Property& property : form->properties) {
        if (property.isConstant() || property.name == "name") continue;
        ++keys[property.name];
        const Json::Value& inner =
            value.isMember(property.name) ? value[property.name] : property.schema.defaultValue;
        if (!inner.isNull()) countKeys(property.schema, inner, keys);
    }
}

// Calls `use` with values that between them hold every key and every form of every key.
void forEachForm(const Schema& schema, const std::function<void(const Json::Value&)>& use) {
    for (const Schema& form : schema.alternatives) forEachForm(form, use);
    if (!schema.alternatives.empty()) return;
    Json::Value whole = exampleOf(schema);
    if (schema.type == JsonType::array && schema.items != nullptr && !schema.items->alternatives.empty()) {
        forEachForm(*schema.items, [&](const Json::Value& item) {
            for (Json::Value& old : whole) old = item;
            use(whole);
        });
    }
    for (const Property& property : schema.properties)
        if (!whole.isMember(property.name)) whole[property.name] = exampleOf(property.schema);
    use(whole);
    for (const Property& property : schema.properties) {
        if (property.isConstant()) continue;
        forEachForm(property.schema, [&](const Json::Value& value) {
            Json::Value other = whole;
            other[property.name] = value;
            use(other);
        });
    }
}

TEST_F(SceneEditorTest, HasAWidgetForEveryKey) {
    const Schema& schema = scene::sceneSchema();
    struct Section {
        const char* title;
        const char* key;
        const Schema& entries;
        std::set<std::string> elsewhere;  // what the mouse does
    };
    const auto of = [&](const char* key) -> const Schema& { return schema.find(key)->schema; };
    const std::vector<Section> sections{{"Lights", "lights", *of("lights").items, {}},
                                        {"Materials", "materials", *of("materials").mapped, {}},
                                        {"Objects", "objects", *of("objects").items, {}},
                                        {"Camera", "camera", of("camera"), {"position", "target", "up"}},
                                        {"Image", "image", of("image"), {}}};
    std::set<std::string> known;
    int count = 0;
    for (const Section& section : sections) {
        known.insert(section.key);
        forEachForm(section.entries, [&](const Json::Value& value) {
            Json::Value root(Json::objectValue);
            Json::Value& place = root[section.key];
            if (of(section.key).type == JsonType::array) place.append(value);
            else if (of(section.key).mapped) place["entry"] = value;
            else place = value;
            Counts keys;
            countKeys(section.entries, value, keys);
            Counts words = wordsOf(root, section.title);
            for (const auto& [key, times] : keys) {
                if (section.elsewhere.contains(key)) continue;
                EXPECT_GE(words[key], times) << section.title << ": " << key << "\n"
                                             << jsonText(value) << written_;
            }
            ++count;
        });
    }
    EXPECT_GT(count, 100);
    // A section for every key of the scene itself, but for its words.
    for (const char* key : {"$schema", "fringe", "description"}) known.insert(key);
    for (const Property& property : schema.properties)
        EXPECT_TRUE(known.contains(property.name)) << property.name;
}

// What gratings are reckoned by is among them.
TEST_F(SceneEditorTest, ShowsEvaluatorWavelengthsAndTolerance) {
    const Schema& lights = *scene::sceneSchema().find("lights")->schema.items;
    for (const Schema& kind : lights.alternatives) {
        if (kind.find("evaluator") == nullptr) continue;
        Json::Value root(Json::objectValue);
        root["lights"].append(exampleOf(kind));
        Counts words = wordsOf(root, "Lights");
        EXPECT_EQ(words["evaluator"], 1);
        EXPECT_EQ(words["wavelengths"], 1);
        EXPECT_EQ(wordsOf(root, "Image")["tolerance"], 1);
        return;
    }
    FAIL() << "no light has an evaluator";
}

}  // namespace
}  // namespace fringe::preview
