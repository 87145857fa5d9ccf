// The schema, and that the reader honours all of it.
#include "scene/schema.hpp"

#include <gtest/gtest.h>
#include <json/reader.h>
#include <json/writer.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "scene/support.hpp"
#include "scene/validate.hpp"

namespace fringe::scene {
namespace {

std::string fileText(const std::string& path) {
    std::ifstream file(std::string(FRINGE_SOURCE_DIR "/") + path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

Json::Value parsed(const std::string& text) {
    Json::Value value;
    std::istringstream stream(text);
    stream >> value;
    return value;
}

TEST(SceneSchema, IsTheFileOfTheSourceTree) {
    EXPECT_EQ(schemaText(), fileText("scenes/fringe.schema.json"));
}

TEST(SceneSchema, EveryKeywordIsUnderstood) {
    EXPECT_NO_THROW(readSchema(schemaText()));
}

TEST(SceneSchema, KeywordsThatAreNotUnderstoodAreRefused) {
    for (
        const char* schema : {
            R"({"type": "number", "multipleOf": 2})",
            R"({"type": "string", "pattern": "^a"})",
            R"({"type": "string", "minLength": 2})",
            R"({"type": "nothing"})",
            R"({"minimum": 2})",
            R"({"type": "object", "properties": {"a": {"type": "number", "not": {}}}, "additionalProperties": false})",
            R"({"type": "object", "properties": {}})",
            R"({"type": "object", "additionalProperties": true})",
            R"({"type": "object", "additionalProperties": {"type": "number"}})",
            R"({"type": "object", "properties": {}, "required": ["a"], "additionalProperties": false})",
            R"({"type": "array"})",
            R"({"type": "string", "unit": "length"})",
            R"({"type": "string", "unit": "mass", "examples": ["1 kg"]})",
            R"({"oneOf": [{"type": "object", "properties": {}, "additionalProperties": false}]})",
            R"({"$ref": "other.json"})",
            R"({"$ref": "#/$defs/none"})",
            R"({"$ref": "#/$defs/a", "minimum": 2, "$defs": {"a": {"type": "number", "minimum": 1}}})",
            "{",
        }) {
        EXPECT_THROW(readSchema(schema), std::logic_error) << schema;
    }
}

// A default that its own schema refused would break the promise that a Scene is valid.
void expectSoundDefaults(const Schema& schema, const std::string& path) {
    if (!schema.defaultValue.isNull()) {
        Findings findings;
        validate(schema.defaultValue, schema, {}, findings);
        EXPECT_TRUE(findings.empty()) << path << ": " << findings.front().message;
    }
    for (const Property& property : schema.properties) {
        expectSoundDefaults(property.schema, path + "." + property.name);
        EXPECT_FALSE(property.required && !property.schema.defaultValue.isNull())
            << path << "." << property.name << " is required and has a default";
    }
    for (const Schema& alternative : schema.alternatives) expectSoundDefaults(alternative, path);
    if (schema.items) expectSoundDefaults(*schema.items, path + "[]");
    if (schema.mapped) expectSoundDefaults(*schema.mapped, path + ".*");
}

TEST(SceneSchema, DefaultsAreSound) {
    expectSoundDefaults(sceneSchema(), "scene");
}

// tests/scene/verdicts.py asks python3-jsonschema for its verdict on the same documents.
TEST(SceneSchema, VerdictsAreThoseOfTheList) {
    for (const Json::Value& entry : parsed(fileText("tests/scene/verdicts.json"))) {
        const std::string problems =
            problemsOf(Json::writeString(Json::StreamWriterBuilder(), entry["scene"]));
        EXPECT_EQ(problems == "no problem", entry["valid"].asBool())
            << entry["case"].asString() << ": " << problems;
    }
}

}  // namespace
}  // namespace fringe::scene
