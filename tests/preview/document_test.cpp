// A scene as it is edited: what overrides are made, and what is written.
#include "preview/document.hpp"

#include <gtest/gtest.h>

#include "preview/files.hpp"
#include "preview/schema_values.hpp"
#include "scene/parse.hpp"
#include "scene/schema.hpp"

namespace fringe::preview {
namespace {

constexpr const char* kText = R"({
    // a comment
    "fringe": 1,
    "camera": { "position": [0, 0, 2], "target": [0, 0, 0], "fov": "40 deg" },
    "lights": [ { "type": "point", "position": [0, 0.1, 1], "power": "4 W" } ]
})";

Source sourceOf(const std::string& text) {
    return {text, "scene.json", {}};
}

scene::Scene parsed(const Source& source) {
    return scene::parseScene(source.text, source.file, source.overrides);
}

TEST(Document, SetsValuesAsOverrides) {
    Document document(sourceOf(kText));
    const auto before = document.source();
    document.set("lights.0.power", "6 W");
    EXPECT_NE(document.source(), before);
    EXPECT_EQ(document.root()["lights"][0]["power"], "6 W");
    const scene::Scene scene = parsed(*document.source());
    EXPECT_EQ(std::get<scene::PointLight>(scene.lights[0].model).power / units::W, 6.0);
}

TEST(Document, KeepsOneOverrideForAPlaceHoweverOftenItIsTurned) {
    Document document(sourceOf(kText));
    for (int i = 1; i < 100; ++i) document.set("lights.0.power", std::to_string(i) + " W");
    EXPECT_EQ(document.source()->overrides.size(), 1U);
    document.set("lights.0", document.root()["lights"][0]);
    EXPECT_EQ(document.source()->overrides.size(), 1U);
    EXPECT_EQ(document.root()["lights"][0]["power"], "99 W");
}

TEST(Document, TakesTheFileAsItIsNow) {
    Document document(sourceOf(kText));
    document.set("lights.0.power", "6 W");
    std::string text = kText;
    text.replace(text.find("4 W"), 3, "5 W");
    document.reload(text);
    EXPECT_EQ(document.root()["lights"][0]["power"], "5 W");
    // The panel is drawn from what the schema takes.
    for (const char* broken :
         {"{ broken", "[]", "7", R"({"lights": 5})", R"({"lights": [{"type": "point", "power": {}}]})"}) {
        document.reload(broken);
        EXPECT_EQ(document.root()["lights"][0]["power"], "5 W") << broken;
        EXPECT_THROW(parsed(*document.source()), scene::SceneError) << broken;
    }
}

TEST(Document, IsWrittenAsAValidSceneWithItsCamera) {
    Document document(sourceOf(kText));
    document.set("lights.0.position", document.root()["lights"][0]["position"]);
    scene::Camera camera = parsed(*document.source()).camera;
    camera.position = {1.0, 2.0, 1.0 / 3.0};
    const std::string text = sceneText(document, camera);
    EXPECT_NE(text.find("0.1"), std::string::npos);
    EXPECT_EQ(text.find("0.10000000000000001"), std::string::npos) << text;
    const scene::Scene scene = parsed(sourceOf(text));
    EXPECT_NEAR(scene.camera.position.z, 1.0 / 3.0, 1e-6);
}

// Every kind of light, material, object and camera can be made from nothing but the schema.
TEST(SchemaValues, AnExampleOfEveryKindIsOfThatKind) {
    const scene::Schema& schema = scene::sceneSchema();
    for (const char* key : {"lights", "objects"}) {
        for (const scene::Schema& kind : schema.find(key)->schema.items->alternatives) {
            const Json::Value example = exampleOf(kind);
            EXPECT_EQ(scene::alternativeFor(*schema.find(key)->schema.items, example), &kind)
                << jsonText(example);
        }
    }
}

TEST(SchemaValues, AnotherKindKeepsWhatBothKnow) {
    const scene::Schema& lights = *scene::sceneSchema().find("lights")->schema.items;
    Json::Value light(Json::objectValue);
    light["type"] = "point";
    light["power"] = "3 W";
    light["position"] = Json::Value(Json::arrayValue);
    for (const double x : {1.0, 2.0, 3.0}) light["position"].append(x);
    for (const scene::Schema& kind : lights.alternatives) {
        const Json::Value made = adapted(light, kind);
        EXPECT_EQ(scene::alternativeFor(lights, made), &kind) << jsonText(made);
        if (kind.find("position") != nullptr) {
            EXPECT_EQ(made["position"], light["position"]);
        }
    }
}

}  // namespace
}  // namespace fringe::preview
